# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cable among obstacles: first as if there were none, then around those that it would enter.

Nodes keep away from the nearest features of the obstacles. Where a feature is all of the obstacle near a node (a
plane, a ball, the side of a cylinder) one solve is exact; else features are looked up anew at the nodes of the last
solve until they stay.
"""

from dataclasses import replace

import numpy as np

from ..transcription import contact
from ..transcription.shape import Shape
from . import mesh
from .detours import detours
from .trial import Problem, TimeUpError, Trial

PASSES = 12
"""Lookups of features after which an attempt ends."""
SETTLED = 1e-3
"""Change of a gap, in radii of the cable, below which a feature has been looked up often enough."""
FIRST = 64
"""Elements of the first mesh."""
MESHES = (96, 96, 128, 128, 192, 256)
GATHER = 6.0
"""Factor by which nodes draw nearer, from mesh to mesh, to where contact begins and ends."""


def around(problem: Problem, trial: Trial) -> Trial | None:
    """The equilibrium among the scene's obstacles, from one without; None if none is found. If the cable keeps away
    from all of them by itself, the trial is the answer."""
    around_it, fixed = problem.surroundings, problem.scene.options.elements
    if not around_it.deepest(trial.shape):
        return trial
    best = None
    try:
        for start in detours(problem, trial, fixed or FIRST):
            found = _settled(problem, start, leaving=True)
            if found is None:
                continue
            found = _off_saddle(problem, found)
            if fixed is None and around_it.deepest(found.shape) < around_it.radius:
                found = _gathered(problem, found)
            if best is None or _rank(found, around_it) < _rank(best, around_it):
                best = found
            if best.stable and not around_it.deepest(best.shape):
                return best
    except TimeUpError:
        if best is None:
            raise
    return best


def _rank(trial, around_it):
    return around_it.deepest(trial.shape), not trial.stable, trial.energy


def _off_saddle(problem, trial):
    """Down from a saddle, both ways; the trial itself if that leads nowhere."""
    for _ in range(3):
        if trial.stable:
            break
        found = [_settled(problem, trial.swayed(size), leaving=True) for size in (0.05, -0.05)]
        below = [each for each in found if each is not None and each.energy < trial.energy]
        if not below:
            break
        trial = min(below, key=lambda each: each.energy)
    return trial


def resumed(problem: Problem, warm: Shape) -> Trial | None:
    """The equilibrium from an earlier one in contact; None if there is none near, or none in contact."""
    if problem.surroundings.between(warm).min(initial=np.inf) > problem.surroundings.radius:
        return None
    found = _settled(problem, warm)
    if found is None or not found.touches or not found.stable:
        return None
    return _gathered(problem, found)


def _gathered(problem, found):
    """On meshes whose nodes gather where contact begins and ends, until the shape stays."""
    around_it, tolerance = problem.surroundings, problem.scene.options.tolerance
    found, width = replace(found, measured=np.inf), 1 / FIRST
    try:
        for elements in MESHES:
            width /= GATHER
            places = _places(found, around_it)
            if not places:
                return replace(found, measured=None)  # touches nothing, so the strong form holds
            start = found.shape.on(mesh.gathered(found.shape, elements, places, width))
            finer = _settled(problem, start, fallback=True)
            if finer is None:
                return found
            moved = finer.shape.position - found.shape.on(finer.shape.arc_length).position
            error = float(np.linalg.norm(moved, axis=1).max())
            found = replace(finer, measured=error)
            if error <= tolerance and not around_it.deepest(found.shape):
                return found
    except TimeUpError:
        if np.isinf(found.measured):
            raise
    return found


def _places(trial, around_it):
    """Arc lengths where contact begins or ends, or is at a point."""
    acting = np.linalg.norm(trial.contact_forces, axis=2).any(axis=1)
    s = trial.shape.arc_length
    edges = np.flatnonzero(np.diff(np.concatenate([[0], acting.astype(int), [0]])))
    places = []
    for a, b in zip(edges[::2], edges[1::2] - 1, strict=True):
        places += [s[a]] if a == b else [s[a], s[b]]
    if around_it.deepest(trial.shape):
        worst = int(np.argmin(around_it.between(trial.shape)))
        places.append((s[worst] + s[worst + 1]) / 2)
    return places


def _settled(problem, shape, leaving=False, fallback=False):
    """Solve on the nodes of ``shape`` until the features are those of the solution. ``fallback``: whether it is worth
    asking the slower solver too."""
    around_it = problem.surroundings
    settled = SETTLED * around_it.radius
    for turn in range(PASSES):
        found = around_it.features(shape, leaving=leaving and turn == 0)
        features, owners = (None, None) if found is None else found
        trial = problem.solve(shape, features=features, fallback=fallback)
        if trial is None:
            return None
        trial = replace(trial, owners=owners)
        gap = around_it.gaps(trial.shape)
        if gap.min() > -settled and _staleness(trial, around_it, gap) < settled:
            return trial
        shape = trial.shape
    return None


def _staleness(trial, around_it, gap) -> float:
    """Largest difference between the gap to a feature that pushes and the gap to its obstacle."""
    if trial.owners is None:
        return 0.0
    nodes, slots = np.nonzero(np.linalg.norm(trial.contact_forces, axis=2))
    rows = np.searchsorted(around_it.indices, trial.owners[nodes, slots])
    features = trial.values["features"][nodes, slots]
    given = contact.value(trial.shape.position[nodes], features)
    there = gap[rows, nodes]
    return float(np.abs(given - there).max(initial=0.0))
