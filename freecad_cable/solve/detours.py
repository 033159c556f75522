# SPDX-License-Identifier: LGPL-2.1-or-later
"""Starts for a cable whose free shape goes through an obstacle.

The nearest equilibrium is looked for first: from the free shape, swayed a little the way in which it is softest, for a
cable that is lifted or pushed aside exactly in its own plane is caught on a saddle. Where that ends nowhere, the slack
goes another way, past the obstacles rather than through them.
"""

import numpy as np

from ..transcription.guess import guess
from . import mesh

SWAY = 0.03
"""First displacement, in lengths: enough to break a symmetry, too little to change sides."""
FARTHER = (0.1, -0.1, 0.25, -0.25)
SAGS = (60.0, 250.0)
"""Loads that pull it there, without units."""
MOST = 8
"""Starts of the second kind that are tried, those that are least inside obstacles first."""


def detours(problem, trial, elements):
    """Shapes on ``elements`` elements, to try in this order."""

    def on(shape):
        return shape.on(mesh.refined(shape, elements))

    yield on(trial.swayed(SWAY))
    yield on(trial.swayed(-SWAY))
    others = [trial.swayed(size) for size in FARTHER]
    if problem.scene.spans:
        axes = np.array([(x, y, z) for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1)])
        axes = axes[np.isin(np.abs(axes).sum(axis=1), (1, 3))]
        nodes = mesh.uniform(mesh.COARSE, problem.breaks)
        for sag in SAGS:
            for axis in axes / np.linalg.norm(axes, axis=1)[:, None]:
                others.append(guess(problem.scene, problem.scaling, nodes, sag=sag * axis))
    inside = [problem.surroundings.share_inside(shape) for shape in others]
    for k in np.argsort(inside, kind="stable")[:MOST]:
        yield on(others[k])
