# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cable among obstacles: first as if there were none, then around those that it would enter.

Nodes keep away from the nearest features of the obstacles. Where a feature is all of the obstacle near a node (a
plane, a ball, the side of a cylinder) one solve is exact; else features are looked up anew at the nodes of the last
solve until they stay.
"""

from dataclasses import replace

import numpy as np

from ..geometry.runs import runs
from ..transcription import contact
from ..transcription.shape import Shape
from . import mesh
from .detours import detours
from .saddle import descended
from .surroundings import BESIDE, NEAR
from .trial import Problem, TimeUpError, Trial

PASSES = 12
"""Lookups of features after which an attempt ends."""
SETTLED = 1e-3
"""Change of a gap, in radii of the cable, below which a feature has been looked up often enough."""
FIRST = 64
"""Elements of the first mesh."""
MESHES = (96, 96, 128, 128, 192, 256)
LOST = 0.02
"""Change from mesh to mesh that is no refinement."""
NARROWEST = 3e-5
"""Shortest elements, relative to the length, that nodes gather to; with shorter ones the solvers fail."""
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
            found = descended(
                found,
                lambda shape: _settled(problem, shape, leaving=True),
                0.05,
                lambda t: t.stable,
            )
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


def resumed(problem: Problem, warm: Shape) -> Trial | None:
    """The equilibrium from an earlier one in contact; None if there is none near, or none in contact."""
    if problem.surroundings.between(warm).min(initial=np.inf) > problem.surroundings.radius:
        return None
    found = _settled(problem, warm, BESIDE, fallback=warm.error is not None)
    if found is None or not found.touches or not found.stable:
        return None
    if warm.error is not None and not problem.surroundings.deepest(found.shape):
        error = warm.error * _coarser(found, warm, problem.surroundings)
        if error <= problem.scene.options.tolerance:
            return replace(found, measured=error)
    return _gathered(problem, found)


def _coarser(trial, warm, around_it) -> float:
    """How much longer the elements are where contact begins and ends now than the finest were, which are those where it
    began and ended before: the error goes with them."""
    steps = trial.shape.steps
    here = np.searchsorted(trial.shape.arc_length, _places(trial, around_it)).clip(
        1, len(steps) - 1
    )
    return max(1.0, np.maximum(steps[here - 1], steps[here]).max() / warm.steps.min())


def _gathered(problem, found):
    """On meshes whose nodes gather where contact begins and ends, until the shape stays."""
    around_it, tolerance = problem.surroundings, problem.scene.options.tolerance
    found, width = replace(found, measured=np.inf), 1 / FIRST
    try:
        for elements in MESHES:
            width = max(width / GATHER, NARROWEST)
            places = _places(found, around_it)
            if not places:
                return replace(found, measured=None)  # touches nothing, so the strong form holds
            start = found.shape.on(mesh.gathered(found.shape, elements, places, width))
            finer = _settled(problem, start, BESIDE, fallback=True)
            if finer is None:
                return found
            moved = finer.shape.position - found.shape.on(finer.shape.arc_length).position
            error = float(np.linalg.norm(moved, axis=1).max())
            if error > LOST and found.measured < LOST:
                return found  # the finer one has left for another equilibrium
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
    places = []
    for a, b in runs(acting):
        places += [s[a]] if b == a + 1 else [s[a], s[b - 1]]
    if around_it.deepest(trial.shape):
        worst = int(np.argmin(around_it.between(trial.shape)))
        places.append((s[worst] + s[worst + 1]) / 2)
    return places


def _settled(problem, shape, reach=NEAR, leaving=False, fallback=False):
    """Solve on the nodes of ``shape`` until the features are those of the solution. ``reach``: up to what gap nodes
    are given features; ``fallback``: whether it is worth asking the slower solver too."""
    around_it = problem.surroundings
    settled = SETTLED * around_it.radius
    for turn in range(PASSES):
        found = around_it.features(shape, reach, leaving and turn == 0)
        features, owners = (None, None) if found is None else found
        trial = problem.solve(shape, features=features, fallback=fallback)
        if trial is None:
            return None
        trial = replace(trial, owners=owners)
        which, gap = around_it.gaps(trial.shape, 2 * around_it.keep)
        if (
            gap.min(initial=np.inf) > -settled
            and _staleness(trial, around_it, which, gap) < settled
        ):
            return trial
        shape = trial.shape
    return None


def _staleness(trial, around_it, which, gap) -> float:
    """Largest difference between the gap to a feature that pushes and the gap to its obstacle."""
    if trial.owners is None:
        return 0.0
    nodes, slots = np.nonzero(np.linalg.norm(trial.contact_forces, axis=2))
    if not len(nodes):
        return 0.0
    owners = trial.owners[nodes, slots]
    indices = around_it.indices[which]
    if not np.isin(owners, indices).all():
        return np.inf
    given = contact.value(trial.shape.position[nodes], trial.values["features"][nodes, slots])
    there = gap[np.searchsorted(indices, owners), nodes]
    return float(np.abs(given - there).max())
