# SPDX-License-Identifier: LGPL-2.1-or-later
"""Starts for a cable whose free shape goes through an obstacle.

The nearest equilibrium is looked for first: from the free shape, swayed a little the way in which it is softest, for a
cable that is lifted or pushed aside exactly in its own plane is caught on a saddle. Where that ends nowhere, the slack
goes another way, past the obstacles rather than through them. At last it is pulled aside where it is deepest inside,
for a thin plate that it crosses pushes the nodes on either side apart.
"""

from itertools import islice, product

import numpy as np

from ..geometry import rotation
from ..geometry.runs import runs
from ..problem import Clamped, Free
from ..transcription.guess import guess, rolled
from . import mesh

SWAY = 0.03
"""First displacement, in lengths: enough to break a symmetry, too little to change sides."""
PULLS = (0.05, 0.1, 0.15, 0.2, 0.3)
"""Displacements, in lengths, by which it is pulled aside; the least that are enough."""
PULLED_ALONG = 0.15
"""Part of the length that goes along."""
WAYS = 3
"""Directions in which it is pulled aside."""
FARTHER = (0.1, -0.1, 0.25, -0.25)
SAGS = (60.0, 250.0)
"""Loads that pull it there, without units."""
MOST = 8
"""Starts of the second kind that are tried, those that are least inside obstacles first."""


AXES = np.array([axis for axis in product((-1, 0, 1), repeat=3) if any(axis)])
"""Directions, of all signs."""


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
        axes = AXES[np.isin(np.abs(AXES).sum(axis=1), (1, 3))]
        nodes = mesh.uniform(mesh.COARSE, problem.breaks)
        for sag in SAGS:
            for axis in axes / np.linalg.norm(axes, axis=1)[:, None]:
                others.append(guess(problem.scene, problem.scaling, nodes, sag=sag * axis))
    inside = [problem.surroundings.intrusion(shape, False) for shape in others]
    for k in np.argsort(inside, kind="stable")[:MOST]:
        yield on(others[k])
    for shape in _pulled_aside(problem, trial.shape):
        yield on(shape)


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
    return _through(problem, shape.arc_length, np.array(laid)[order])


def _pulled_aside(problem, shape):
    """The shape with the part that is deepest inside pulled past the obstacle, the nearest ways."""
    s, gap = shape.arc_length, problem.surroundings.between(shape)
    inside = max(runs(gap < 0), key=lambda run: -gap[slice(*run)].min(), default=None)
    if inside is None:
        return
    middle = (s[inside[0]] + s[inside[1]]) / 2
    share = np.exp(-(((s - middle) / PULLED_ALONG) ** 2)) * np.minimum(1, 10 * np.minimum(s, 1 - s))
    for pull in PULLS:
        if ways := list(islice(_clear(problem, shape, pull * share), WAYS)):
            yield from ways
            return


def _clear(problem, shape, pull):
    """The shape with its nodes moved by ``pull`` (n+1,), each way that leaves no part of it inside."""
    for axis in AXES / np.linalg.norm(AXES, axis=1)[:, None]:
        pulled = _through(problem, shape.arc_length, shape.position + pull[:, None] * axis)
        if problem.surroundings.intrusion(pulled) == 0:
            yield pulled


def _through(problem, arc_length, position):
    """A guess through places (n+1, 3)."""
    tangent = np.gradient(position, arc_length, axis=0)
    tangent /= np.linalg.norm(tangent, axis=1)[:, None]
    start = problem.scene.start
    first = start.quaternion if isinstance(start, Clamped) else rotation.from_tangent(tangent[0])
    frames = rotation.transport(first, tangent)
    return rolled(problem.scene, problem.scaling, arc_length, position, frames)
