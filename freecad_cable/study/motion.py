# SPDX-License-Identifier: LGPL-2.1-or-later
"""A motion: what a cable goes through on a path of its scene, and how long it must be for all of it."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from scipy.interpolate import CubicHermiteSpline

from ..equilibrium import find_equilibrium
from ..errors import ProblemError
from ..geometry import rotation
from ..problem import Scene
from ..result import Solution
from .path import PRECISION, Jump, Step, change, follow
from .row import Row


@dataclass(frozen=True)
class Motion:
    """The worst over a motion; each with the value of the path where it is."""

    smallest_bend_radius: tuple[float, float]
    """value, [m]"""
    largest_end_force: tuple[float, float]
    """value, [N], at either end"""
    smallest_clearance: tuple[float, float] | None
    """value, [m]"""
    jumps: tuple[Jump, ...]
    unsolved: tuple[float, ...]
    """values without an equilibrium"""


def motion(steps: Iterable[Step]) -> Motion:
    """Summary of the steps of a path. Errors: ``ProblemError`` if none is solved."""
    steps = list(steps)
    solved = [step for step in steps if step.solved]
    if not solved:
        raise ProblemError("parameter", "has no value at which the cable can be solved")
    rows = [step.row for step in solved]
    radii = [(row.smallest_bend_radius, step.value) for row, step in zip(rows, solved, strict=True)]
    forces = [
        (max(row.start_force, row.end_force), step.value)
        for row, step in zip(rows, solved, strict=True)
    ]
    clearances = [
        (row.smallest_clearance, step.value)
        for row, step in zip(rows, solved, strict=True)
        if row.smallest_clearance is not None
    ]
    return Motion(
        smallest_bend_radius=min(radii)[::-1],
        largest_end_force=max(forces)[::-1],
        smallest_clearance=min(clearances)[::-1] if clearances else None,
        jumps=tuple(jump for step in steps for jump in step.jumps),
        unsolved=tuple(step.value for step in steps if not step.solved),
    )


@dataclass(frozen=True)
class NeededLength:
    """How long a cable must be to keep its limits all over a motion."""

    length: float
    """[m]"""
    value: float
    """where it must be as long"""
    longest: float
    """[m] that it may be"""
    longest_value: float

    @property
    def feasible(self) -> bool:
        """Whether one length will do everywhere."""
        return self.length <= self.longest


def needed_length(
    scene_at: Callable[[float], Scene],
    values: Iterable[float],
    *,
    solve=find_equilibrium,
    tick=lambda: None,
) -> NeededLength:
    """The length that the worst position needs, and the longest that all allow, by a search for the shortest cable at
    each value. ``tick`` is called after each; what it raises ends the search. Errors: ``ProblemError`` naming the value
    at which no length will do."""
    found = []
    for value in values:
        try:
            solution = solve(replace(scene_at(value), asks_length=True))
        except ProblemError as error:
            raise ProblemError(error.field, f"at {value:g}: {error.message}") from None
        if not solution.status.success:
            raise ProblemError("cable.length_mode", f"at {value:g}: {solution.message}")
        found.append((float(value), solution))
        tick()
    length, where = max((each.feasible_lengths[0].length, value) for value, each in found)
    allowed = [(_allowed(each, length, solve), value) for value, each in found]
    return NeededLength(length, where, *min(allowed))


def _allowed(solution, length, solve):
    """The longest cable that a position allows [m]; where its search has ended at one shorter than ``length`` for no
    requirement, that length is tried."""
    longest = solution.feasible_lengths[1]
    if longest.length >= length or longest.requirement not in (None, "equilibrium"):
        return longest.length
    scene = solution.scene
    there = replace(scene, rod=replace(scene.rod, length=length), asks_length=False)
    found = solve(there, start=solution)
    # As in the search, one that lies in a loop on itself is none to order.
    loops = any(contact.obstacle is None for contact in found.contacts)
    return length if Row.of((), found).holds and not loops else longest.length


def envelope(solutions: Iterable[Solution], spacing: float) -> np.ndarray:
    """(m, 3) [m] points of the centrelines of a motion, each at most ``spacing`` [m] from the next along its cable:
    with the cable's radius about each, what it sweeps at these values."""
    found = []
    for solution in solutions:
        s = solution.arc_length
        count = int(np.ceil(s[-1] / spacing)) + 1
        curve = CubicHermiteSpline(s, solution.position, rotation.tangent(solution.quaternion))
        found.append(curve(np.linspace(0, s[-1], count)))
    return np.concatenate(found) if found else np.zeros((0, 3))


MOST_SHAPES = 400
"""Of an envelope."""


def close_together(
    scene_at: Callable[[float], Scene], steps: list[Step], spacing: float, tick=lambda: None
) -> list[Step]:
    """The steps of a path with as many between them as it takes for no node to move farther than ``spacing`` [m]
    from one to the next, as far as ``MOST_SHAPES`` do; what jumps stays apart. ``tick`` is called for each that is
    added."""
    found = []
    for step in steps:
        last = next((each for each in reversed(found) if each.solved), None)
        if last is not None and step.solved:
            more = MOST_SHAPES - len(steps) - len(found)
            found += _between(scene_at, last, step, spacing, more, tick)
        found.append(step)
    return found


def apart(steps: list[Step], spacing: float) -> list[tuple[float, float, float]]:
    """Values of steps next to each other between which a node moves farther than ``spacing`` [m], and how far [m]."""
    solved = [step for step in steps if step.solved]
    moved = [(one.value, other.value, _moved(one, other)) for one, other in pairwise(solved)]
    return [each for each in moved if each[2] > spacing]


def _moved(one, other):
    return change(one.solution, other.solution)[0] * other.solution.arc_length[-1]


def _between(scene_at, one, other, spacing, most, tick):
    """Steps between two, each half way between its neighbours; where these stay apart however near their values are,
    the cable jumps."""
    least = PRECISION * abs(other.value - one.value)
    found, waiting = [], [(one, other)]
    while waiting and len(found) < most:
        before, after = waiting.pop(0)  # the widest first
        if _moved(before, after) <= spacing or abs(after.value - before.value) <= least:
            continue
        middle = (before.value + after.value) / 2
        (step,) = follow(scene_at, [middle], start=before.solution)
        tick()
        if step.solved:
            found.append(step)
            waiting += [(before, step), (step, after)]
    return sorted(found, key=lambda step: step.value, reverse=one.value > other.value)
