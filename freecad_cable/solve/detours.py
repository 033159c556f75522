# SPDX-License-Identifier: LGPL-2.1-or-later
"""Starts for a cable whose free shape goes through an obstacle.

The nearest equilibrium is looked for first: from the free shape, swayed a little the way in which it is softest, for a
cable that is lifted or pushed aside exactly in its own plane is caught on a saddle. Where that ends nowhere, the slack
goes another way, past the obstacles rather than through them.
"""

import numpy as np

from ..geometry import rotation
from ..problem import Clamped, Free
from ..transcription.guess import guess, rolled
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

    # A mode has no sign of its own: first the way that leads out.
    both = [trial.swayed(SWAY), trial.swayed(-SWAY)]
    for shape in sorted(both, key=problem.surroundings.intrusion):
        yield on(shape)
    if isinstance(problem.scene.start, Free) or isinstance(problem.scene.end, Free):
        yield on(_laid(problem, trial.shape))
    others = [trial.swayed(size) for size in FARTHER]
    if problem.scene.spans:
        axes = np.array([(x, y, z) for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1)])
        axes = axes[np.isin(np.abs(axes).sum(axis=1), (1, 3))]
        nodes = mesh.uniform(mesh.COARSE, problem.breaks)
        for sag in SAGS:
            for axis in axes / np.linalg.norm(axes, axis=1)[:, None]:
                others.append(guess(problem.scene, problem.scaling, nodes, sag=sag * axis))
    inside = [problem.surroundings.intrusion(shape, False) for shape in others]
    for k in np.argsort(inside, kind="stable")[:MOST]:
        yield on(others[k])


def _laid(problem, shape):
    """The cable let out from its held end: where it meets an obstacle it goes on along that."""
    scene, around = problem.scene, problem.surroundings
    order = slice(None, None, -1 if isinstance(scene.start, Free) else 1)
    steps, places = shape.steps[order], shape.position[order]
    wanted = np.diff(places, axis=0) / steps[:, None]
    laid, ahead = [places[0]], wanted[0]
    for step, direction in zip(steps, wanted, strict=True):
        place = laid[-1] + step * direction
        if around.gap(place)[0] < 0:
            place = laid[-1] + step * ahead
        for _ in range(5):
            gap, normal = around.gap(place)
            place = place + max(-gap, 0.0) * normal
            ahead = (place - laid[-1]) / max(np.linalg.norm(place - laid[-1]), 1e-12)
            place = laid[-1] + step * ahead
        laid.append(place)
    position = np.array(laid)[order]
    tangent = np.gradient(position, shape.arc_length, axis=0)
    tangent /= np.linalg.norm(tangent, axis=1)[:, None]
    start = scene.start
    first = start.quaternion if isinstance(start, Clamped) else rotation.from_tangent(tangent[0])
    frames = rotation.transport(first, tangent)
    return rolled(scene, problem.scaling, shape.arc_length, position, frames)
