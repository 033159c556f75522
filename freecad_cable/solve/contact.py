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

from ..transcription.shape import Shape
from . import mesh, strong_form, touching
from .detours import detours
from .gathering import APART, FIRST, MESHES, compared, gathered
from .passing import passed_through
from .problem import Problem, TimeUpError
from .saddle import descended
from .settling import settled
from .surroundings import BESIDE
from .trial import Trial

AT_RIMS = 4
"""Starts that are tried where a cable is in nothing but rims of rings."""

LEFT = 1e-8
"""Sum of the defects that the solvers leave."""
AGES = 1.1
"""Growth of an error from step to step of a drag, at least: so it is measured anew after some ten or twenty, and the
mesh, made for the first of them, with it. As many times more where there are more elements than the fewest, for these
will mostly do: where contact was is known now."""


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
    leave = partial(settled, problem, leaving=1, hasty=hasty)
    best = None
    try:
        for start in islice(detours(problem, trial, fixed or FIRST), AT_RIMS if at_rims else None):
            if fixed is None:
                start = _fine_at_holes(problem, start)
            found = leave(start)
            if found is None:
                continue
            found = descended(found, leave, 0.05, lambda t: t.stable)
            if around_it.deepest(found.shape) < around_it.radius:
                found = gathered(problem, found) if fixed is None else compared(problem, found)
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
            found = settled(problem, shape, leaving=side, fallback=True)
            if found is None:
                continue
            found = descended(
                found,
                lambda shape: settled(problem, shape, fallback=True),
                0.02,
                lambda t: t.stable,
            )
            if fixed is None:
                found = gathered(problem, found)
            if found.stable and not problem.own.depths(found.shape):
                return found
    except TimeUpError:
        pass
    problem.apart = False
    return trial


def _rank(trial, around_it):
    return around_it.deepest(trial.shape), not trial.stable, trial.energy


def rests(problem: Problem, trial: Trial | None) -> bool:
    """Whether a trial is in equilibrium, and in no obstacle."""
    return trial is not None and trial.stable and not problem.surroundings.deepest(trial.shape)


def handed_on(
    now: Problem, found: Trial, then: Problem, error: float
) -> tuple[Problem, Trial] | None:
    """One step of problems: ``then``, and what an equilibrium of ``now`` with that ``error`` has become in it; None
    if it has become none."""
    before, after = now.scaling, then.scaling
    start = found.shape.in_units(before.force / after.force, before.length / after.length)
    following = resumed(then, replace(start, error=error))
    return None if following is None else (then, following)


def resumed(problem: Problem, warm: Shape) -> Trial | None:
    """The equilibrium from an earlier one in contact or near it; None if there is none near."""
    problem.formed = problem.scene.enforce_bend_radius
    found = _resumed(problem, warm)
    if found is not None and passed_through(problem, warm, found.shape, problem.pushers):
        found = None
    problem.formed = problem.formed and found is not None
    return found


def _resumed(problem, warm):
    known, fixed = warm.error is not None, problem.scene.options.elements
    warm = warm.on(mesh.asked(warm, fixed))
    problem.apart = known and problem.own.links(warm, problem.own.radius) is not None
    around_it = problem.surroundings
    if not known and around_it.between(warm).min(initial=np.inf) > around_it.radius:
        return None
    found = _followed(problem, warm, known)
    if found is None or not found.stable:
        return None
    if not found.touches:
        return _clear(problem, found)
    if fixed is not None:
        return compared(problem, found)
    error = np.inf
    if known and not around_it.deepest(found.shape):
        error = _dragged(problem, found, warm)
        if error <= problem.scene.options.tolerance:
            return found.measured_as(error)
    return gathered(problem, found, error)


def _followed(problem, warm, fallback):
    """The equilibrium that the iteration finds from an earlier one. What the cable has come past without having had it
    in sight, it may have passed through; then once more, with that in sight."""
    found = settled(problem, warm, BESIDE, fallback=fallback)
    if found is None:
        return None
    moved = np.linalg.norm(found.shape.position - warm.position, axis=1)
    moved = np.maximum(moved[1:], moved[:-1])
    if moved.max() <= BESIDE:
        return found
    room = problem.surroundings.look(warm, moved.max()).least
    passed = (room > BESIDE) & (room < moved)
    if not passed.any():
        return found
    return settled(problem, warm, moved[passed].max(), fallback=fallback)


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


def _dragged(problem, trial, warm) -> float:
    """The error of an equilibrium on the nodes of an earlier one, from the error of that.

    Beside contacts it goes with the defects of the elements. Where the cable slides freely over a point it is of third
    order in the element there (decision 17); where contact begins and ends at nodes it goes with the elements, the
    finest of which are those where it began and ended when the error was measured."""
    shape, structure, values = trial.shape, trial.nlp.structure, trial.values
    both = shape, warm
    pushed = np.any([touching.pushed(each, values["weight"]) for each in both], axis=0)
    now, before = (strong_form.defect(each, values, structure, ~pushed) for each in both)
    coarser = 1.0
    if len(places := touching.places(problem, trial, pointed=False)):
        coarser = touching.fineness(shape, places) / warm.steps.min()
    ages = AGES * max(1.0, len(shape.steps) / min(MESHES))
    grown = max(ages, coarser, (now + LEFT) / (before + LEFT))
    return warm.error * grown + touching.displaced(trial)
