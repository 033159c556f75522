# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cable among obstacles: first as if there were none, then around those that it would enter. Likewise with itself.

Each element keeps the place on it that is nearest to an obstacle away from what is nearest there. Where that feature
is all of the obstacle near the place (a plane, a ball, the side of a cylinder) one solve is exact; else places and
features are looked up anew at the last solve until they stay.
"""

from dataclasses import replace
from functools import partial
from itertools import islice

import numpy as np

from ..transcription import arms
from ..transcription.shape import Shape
from . import mesh, touching
from .detours import detours
from .problem import Problem, TimeUpError
from .saddle import descended
from .surroundings import BESIDE, NEAR
from .trial import Trial

PASSES = 12
"""Lookups of features after which an attempt ends."""
SETTLED = 1e-3
"""Change of a gap, in radii of the cable, below which a feature has been looked up often enough."""
WELL_SETTLED, RIGHT = 1e-5, 0.01
"""The same from which no more lookups are tried, and what it may be of the tolerance: a gap tells of a cable that
slides along a round edge by the square of how far. The solvers leave 1e-6."""
TWICE = 2
"""Lookups after which features that pushed are kept, for they may be taking turns."""
HALVED = 0.5
"""Share of the last change that another lookup, beyond those that are enough, must promise. Where the cable touches
itself all are made: two parts side by side are a hinge that turns by a small gap over a short length."""
AT_RIMS = 4
"""Starts that are tried where a cable is in nothing but rims of rings."""
COARSER = 1.5
"""Error of a mesh to its distance from a finer one by a third, at order 4 of which that has a third of the error."""
CHANCE = 3.0
"""By how much more than first order the error of a mesh is taken to be, from the changes before it."""
FIRST, APART, HEAVY = 64, 96, 1e3
"""Elements of the first mesh; at least so many of a finer one where the cable touches itself or is so heavy (w L³/EI)
that it bends sharply where it leaves what it lies on."""
MESHES = (48, 64, 96, 96, 128, 128, 192, 256, 256, 256, 256, 384, 384)
LOST = 0.02
"""Change from mesh to mesh that is no refinement."""
NARROWEST = 3e-5
"""Shortest elements, relative to the length, that nodes gather to; with shorter ones the solvers fail."""
GATHER = 6.0
"""Factor by which nodes draw nearer, from mesh to mesh, to where contact begins and ends."""


def around(problem: Problem, trial: Trial) -> Trial | None:
    """The equilibrium among the scene's obstacles, from one without; None if none is found. If the cable keeps away
    from all of them by itself, the trial is the answer. Where none is found beside the rims of rings, these are left
    to the rings, and the clearance says what is wrong."""
    around_it, fixed = problem.surroundings, problem.scene.options.elements
    if not around_it.deepest(trial.shape):
        return trial
    lenient = around_it.without_rims()
    at_rims = lenient is not around_it and not lenient.deepest(trial.shape)
    # Through a ring there is one way, and around an obstacle there are many.
    hasty = lenient is around_it
    leave = partial(_settled, problem, leaving=1, hasty=hasty)
    best = None
    try:
        for start in islice(detours(problem, trial, fixed or FIRST), AT_RIMS if at_rims else None):
            if fixed is None:
                start = _fine_at_holes(problem, start)
            found = leave(start)
            if found is None:
                continue
            found = descended(found, leave, 0.05, lambda t: t.stable)
            if fixed is None and around_it.deepest(found.shape) < around_it.radius:
                found = _gathered(problem, found)
            if best is None or _rank(found, around_it) < _rank(best, around_it):
                best = found
            # One that does not touch what was in its way has gone to another equilibrium altogether.
            if best.stable and best.touches and not around_it.deepest(best.shape):
                return best
    except TimeUpError:
        if best is None and not at_rims:
            raise
    if lenient is around_it:
        return best
    problem.surroundings = lenient
    return around(problem, trial)


def _fine_at_holes(problem, shape):
    """With nodes at the rims of holes, which shorter elements would find deep inside the wall."""
    around_it = problem.surroundings
    places = [shape.arc_length[node] for node in around_it.in_holes(shape)]
    if not places:
        return shape
    return shape.on(mesh.gathered(shape, FIRST, places, around_it.radius))


def apart(problem: Problem, trial: Trial) -> Trial:
    """The equilibrium of a cable that keeps away from itself, from one that may run through itself: the same if it does
    not, and if no other is found."""
    places = problem.own.mesh_places(trial.shape)
    if not places:
        return trial
    problem.apart, fixed = True, problem.scene.options.elements
    try:
        for side in (1, -1):
            shape = trial.shape
            if fixed is None:
                shape = shape.on(mesh.gathered(shape, APART, places, problem.own.radius))
            found = _settled(problem, shape, leaving=side, fallback=True)
            if found is None:
                continue
            found = descended(
                found,
                lambda shape: _settled(problem, shape, fallback=True),
                0.02,
                lambda t: t.stable,
            )
            if fixed is None:
                found = _gathered(problem, found)
            if found.stable and not problem.own.depths(found.shape):
                return found
    except TimeUpError:
        pass
    problem.apart = False
    return trial


def _rank(trial, around_it):
    return around_it.deepest(trial.shape), not trial.stable, trial.energy


def resumed(problem: Problem, warm: Shape) -> Trial | None:
    """The equilibrium from an earlier one in contact or near it; None if there is none near."""
    known = warm.error is not None
    problem.apart = known and problem.own.links(warm, problem.own.radius) is not None
    around_it = problem.surroundings
    if not known and around_it.between(warm).min(initial=np.inf) > around_it.radius:
        return None
    found = _settled(problem, warm, BESIDE, fallback=known)
    if found is None or not found.stable:
        return None
    if not found.touches:
        return _clear(problem, found)
    error = np.inf
    if known and not around_it.deepest(found.shape):
        error = warm.error * _coarser(problem, found, warm)
        if error <= problem.scene.options.tolerance:
            return found.measured_as(error)
    return _gathered(problem, found, error)


def _clear(problem, found):
    """One that came near to obstacles and touches none, if that is all that there is to it."""
    if (
        problem.apart
        or problem.scene.enforce_bend_radius
        or problem.surroundings.deepest(found.shape)
    ):
        return None
    right = found.error <= problem.scene.options.tolerance and not problem.own.depths(found.shape)
    return found if right else None


def _coarser(problem, trial, warm) -> float:
    """How much longer the elements are where contact begins and ends now than the finest were, which are those where it
    began and ended before: the error goes with them."""
    places = touching.places(problem, trial)
    return max(1.0, touching.fineness(trial.shape, places) / warm.steps.min())


def _gathered(problem, found, error=np.inf):
    """On meshes whose nodes gather where contact begins and ends, until the shape stays. ``error`` of what was found,
    as far as it is known."""
    around_it, tolerance = problem.surroundings, problem.scene.options.tolerance
    found, width = found.measured_as(error), 1 / FIRST
    expected = last = 0.0
    here = touching.places(problem, found)
    coarsest = APART if problem.apart or problem.scaling.weight_ratio > HEAVY else 0
    try:
        for elements in MESHES:
            if elements < coarsest:
                continue
            if not len(here):
                return found.measured_as(None)  # touches nothing, so the strong form holds
            width = max(width / GATHER, NARROWEST)
            nodes = mesh.gathered(found.shape, elements, here, width)
            finer = _settled(problem, found.shape.on(nodes), BESIDE, fallback=True)
            if finer is None:
                return found
            # As one piece: supports that slide are elsewhere on the one than on the other.
            coarser = replace(found.shape, joints=()).on(finer.shape.arc_length)
            change = np.linalg.norm(finer.shape.position - coarser.position, axis=1).max()
            if change > LOST and found.measured < LOST:
                return found  # the finer one has left for another equilibrium
            # A node may lie well by chance, and then one change tells too little: the error goes with the elements. Two
            # that are small are no chance.
            fineness = touching.fineness(found.shape, here)
            here = touching.places(problem, finer)
            finer_by = touching.fineness(finer.shape, here) / fineness if len(here) else 1.0
            expected = max(min(expected, last), change) * min(finer_by, 1.0)
            last = change
            error = max(COARSER * change, CHANCE * expected)
            found = finer.measured_as(error)
            inside = problem.apart and problem.own.depths(found.shape)
            if error <= tolerance and not (inside or around_it.deepest(found.shape)):
                return found
    except TimeUpError:
        if np.isinf(found.measured):
            raise
    return found


def finer(problem: Problem, trial: Trial) -> Trial:
    """On twice as many elements, gathered where it touches, and once more if it is in something there; the same if that
    is not to be had."""
    best, elements = trial, mesh.size(2 * len(trial.shape.steps))
    for _ in range(2):
        places = touching.places(problem, best)
        width = touching.fineness(best.shape, places)
        nodes = mesh.gathered(best.shape, elements, places, width)
        found = _settled(problem, best.shape.on(nodes), BESIDE, fallback=True)
        if found is None:
            break
        best = found.measured_as(trial.error)
        if not problem.surroundings.deepest(best.shape):
            break
    return best


def _settled(problem, shape, reach=NEAR, leaving=0, fallback=False, hasty=False):
    """Solve on the nodes of ``shape`` until the places are those of the solution. ``reach``: up to what gap elements
    are given places; ``leaving``: whether they are to leave what they are in, and which way the cable leaves itself;
    ``fallback``: whether it is worth asking the slower solver too; ``hasty``: see ``Problem.solve``."""
    around_it = problem.surroundings
    settled, near, last = SETTLED * around_it.radius, None, np.inf
    well = WELL_SETTLED * around_it.radius
    if not problem.apart:
        well = max(well, RIGHT * problem.scene.options.tolerance)
    places = around_it.places(shape, reach, bool(leaving))
    for turn in range(PASSES):
        links = problem.own.links(shape, reach, leaving * (turn == 0)) if problem.apart else None
        trial = problem.solve(shape, places=places, links=links, fallback=fallback, hasty=hasty)
        if trial is None:
            return near
        shape = trial.shape
        places = around_it.places(shape, reach, pushed=trial.pushed if turn >= TWICE else None)
        stale = _staleness(around_it, trial, places)
        if stale < settled:
            own = _own_staleness(problem, trial) if problem.apart else 0.0
            if max(stale, own) < well:
                return trial
            if not problem.apart:
                if near is not None and stale > HALVED * last:
                    return trial
                near = trial
        last = stale
    return near


def _own_staleness(problem, trial) -> float:
    """Largest difference between the gap of a link that pushes and that of its node to where the cable is nearest now,
    and how far any node is in the cable."""
    there = problem.own.links(trial.shape, problem.own.radius)
    nearest = np.full(len(trial.shape.arc_length), np.inf)
    if there is not None:
        np.minimum.at(nearest, np.array(there.pairs)[:, 0], there.distance - 2 * problem.own.radius)
    touches = trial.with_itself
    stale = np.abs(touches.gaps - nearest[touches.nodes]).max(initial=0.0)
    return max(stale, -nearest.min())


def _staleness(around_it, trial, places) -> float:
    """How far the places that a look at a trial finds are inside what they keep away from, and the largest difference
    between a gap that pushes and that of its place to the obstacle."""
    stale = 0.0
    if places is not None:
        here = arms.rows(trial.nlp.structure, trial.shape, places)
        stale = -arms.read(trial.nlp, trial.raw.x, here).gap.min()
    pushed = trial.pushed
    for owner in () if pushed is None else np.unique(pushed.owners):
        own = pushed.owners == owner
        there = around_it.nearest_of(
            np.searchsorted(around_it.indices, owner), pushed.position[own]
        )
        gap = there.distance - around_it.keep
        stale = max(stale, np.abs(pushed.gap[own] - gap).max())
    return float(stale)
