# SPDX-License-Identifier: LGPL-2.1-or-later
"""Path following: a family of scenes, each solved from the equilibrium before it.

A cable that is moved slowly keeps its equilibrium while that changes in proportion to the step. Where it does not,
the step is halved until it does, or until the value is known closely at which the cable leaves for another
equilibrium: at a fold of its path, or where it loses its stability. Numerical continuation: Allgower and Georg,
*Introduction to Numerical Continuation Methods* (2003), ch. 2 and 6; here without a predictor, as the stable part of
the path is all that a cable shows.
"""

import time
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass

import numpy as np
from scipy.interpolate import CubicSpline

from ..equilibrium import find_equilibrium
from ..errors import DocumentError, ProblemError
from ..geometry import rotation
from ..problem import Scene
from ..result import Solution, is_near
from .row import Row

PRECISION = 1e-3
"""Width of the bracket of a jump, relative to the range of the values."""
SMALL = 2e-3
"""Change of shape below which two equilibria are one: some ten times what the tolerance of a solve leaves between
meshes (1e-4 of the length, and in turns as much)."""
FURTHER = 0.05
"""Change beyond a jump, up to which nothing more is suspected: what has buckled moves fast."""
FASTER = 2.5
"""How much faster than in the step before the shape may change. Before a fold it changes like the square root of
the distance to it, and a step that goes half the way there doubles the rate."""
CLOSER = 4
"""Halvings of a bracket that tell a jump from buckling, whose change goes like the root of the width: to a quarter,
if the bracket began where it buckles."""
STILL = 0.75
"""Share of its change that a jump keeps."""
SAMPLES = 65
"""Places along a cable at which shapes on different meshes are compared."""


@dataclass(frozen=True)
class Jump:
    """The cable left its equilibrium for another between two values."""

    before: float
    """value at which it had not yet"""
    after: float
    """value at which it had"""
    change: float
    """of shape, the largest of ``change``"""
    buckling: bool = False
    """whether it leaves gradually, on a path that branches off"""

    @property
    def value(self) -> float:
        return (self.before + self.after) / 2

    @property
    def sentence(self) -> str:
        between = f"between {self.before:.6g} and {self.after:.6g}"
        if self.buckling:
            return f"Begins to buckle {between}."
        return f"Jumps to another equilibrium {between}; its shape changes by {self.change:.2g} of the length."


@dataclass(frozen=True, eq=False)
class Step:
    """What was found at one value of a path."""

    value: float
    solution: Solution | None
    """None if the value gives no scene; see ``error``"""
    jumps: tuple[Jump, ...] = ()
    """on the way here from the value before"""
    error: str = ""
    solves: int = 1
    time: float = 0.0
    """[s]"""

    @property
    def solved(self) -> bool:
        return self.solution is not None and self.solution.status.success

    @property
    def row(self) -> Row:
        note = " ".join(jump.sentence for jump in self.jumps)
        return Row.of((self.value,), self.solution, time=self.time, note=note, error=self.error)


def follow(
    scene_at: Callable[[float], Scene],
    values: Iterable[float],
    *,
    start: Solution | None = None,
    precision: float = PRECISION,
    solve=find_equilibrium,
) -> Iterator[Step]:
    """The equilibria of a family of scenes at ``values``, in their order, each from the last.

    ``start`` is an equilibrium near the first value. A jump to another equilibrium is bracketed to ``precision``,
    relative to the range of the values, and the path goes on from there; a value that cannot be solved is a step with
    its reason, and the path goes on from the last that could.
    """
    values = [float(value) for value in values]
    walk = _Walk(scene_at, solve, precision * (max(values) - min(values)) if values else 0.0)
    if start is not None and values:
        walk.here = values[0], start
    for value in values:
        yield walk.to(value)


class _Walk:
    """Where a path has come to, and how fast the shape changes there."""

    def __init__(self, scene_at, solve, width):
        self.scene_at, self.solve, self.width = scene_at, solve, width
        self.here = None
        self.rate = None
        self.solves = 0

    def to(self, value) -> Step:
        begin, self.solves = time.perf_counter(), 0
        jumps, error, solution = [], "", None
        try:
            scene = self.scene_at(value)
            if self.here is None or scene.asks_length:
                solution = self._solved(scene)
            else:
                solution = self._reached(scene, value, jumps)
        except (ProblemError, DocumentError) as wrong:
            error = f"{str(wrong).rstrip('.')}."
        if solution is not None and solution.status.success:
            self.here = value, solution
        spent = time.perf_counter() - begin
        return Step(value, solution, tuple(jumps), error, self.solves, spent)

    def _solved(self, scene):
        self.solves += 1
        start = None if self.here is None else self.here[1]
        return self.solve(scene, start=start)

    def _reached(self, scene, value, jumps):
        """The solution at a value, by as many steps from here as it takes; ``jumps`` grows."""
        here, before = self.here
        step = abs(value - here)
        fine = step <= self.width
        if fine or is_near(before, scene):
            solution = self._solved(scene)
            if not solution.status.success:
                return solution
            changed = change(before, solution)
            if self._is_smooth(value, solution, changed):
                return solution
            if fine:
                return self._left(scene, value, solution, changed, jumps)
        middle = (here + value) / 2
        try:
            between = self.scene_at(middle)
        except (ProblemError, DocumentError):
            # Between two whole numbers there is none, and nothing is known of the way.
            self.rate = None
            return self._solved(scene)
        half = self._reached(between, middle, jumps)
        if not half.status.success:
            return self._beyond(scene, value, jumps)
        self.here = middle, half
        return self._reached(scene, value, jumps)

    def _beyond(self, scene, value, jumps):
        """The solution at a value on whose way there is none."""
        solution = self._solved(scene)
        if solution.status.success:
            here, before = self.here
            jumps.append(Jump(here, value, change(before, solution).max()))
            self.rate = None
        return solution

    def _left(self, scene, value, solution, changed, jumps):
        """The solution at a value before which the cable leaves its equilibrium: by a jump, whose change stays as it
        is while its bracket narrows, or by buckling, whose change goes to zero with it."""
        (low, before), (high, after) = self.here, (value, solution)
        for _ in range(CLOSER):
            middle = (low + high) / 2
            found = self._between(middle, before)
            if found is None or not found.status.success:
                break
            if (change(before, found) <= np.maximum(SMALL, changed / 2)).all():
                low, before = middle, found
            else:
                high, after = middle, found
        closer, worst = change(before, after), np.argmax(changed)
        buckles = bool(closer[worst] < STILL * changed[worst])
        jumps.append(Jump(low, high, float(closer.max()), buckles))
        self.here, self.rate = (high, after), None
        if high == value:
            return solution
        # The nearest equilibrium at the end of the bracket may be another one than a longer step had found.
        solution = self._solved(scene)
        if solution.status.success and (further := change(after, solution).max()) > FURTHER:
            jumps.append(Jump(high, value, float(further)))
        return solution

    def _between(self, value, start):
        """The solution at a value between two; None if there is no such value, as between whole numbers."""
        try:
            scene = self.scene_at(value)
        except (ProblemError, DocumentError):
            return None
        self.solves += 1
        return self.solve(scene, start=start)

    def _is_smooth(self, value, solution, changed):
        """Whether nothing speaks for a jump on the way to a value: the shape changes as fast as before, or, where that
        is not known, in both halves of the way alike."""
        here, before = self.here
        step = abs(value - here)
        if self.rate is not None:
            smooth = (changed <= np.maximum(SMALL, FASTER * self.rate * step)).all()
            self.rate = changed / step if smooth and step else self.rate
            return smooth
        if (changed <= SMALL).all():
            return True
        middle = self._between((here + value) / 2, before)
        if middle is None:
            return True  # there is nothing to tell
        if not middle.status.success:
            return False
        halves = [change(before, middle), change(middle, solution)]
        less, more = np.sort(halves, axis=0)
        smooth = (more <= np.maximum(SMALL, FASTER * less)).all()
        self.rate = 2 * halves[1] / step if smooth else None
        return smooth


def change(one: Solution, other: Solution) -> np.ndarray:
    """(2,) largest change of a node's position, relative to the length, and of its frame, in half turns, between two
    solutions, at the same shares of their lengths."""
    a, b = (each.arc_length / each.arc_length[-1] for each in (one, other))
    places = [one.position, other.position]
    frames = [one.quaternion, other.quaternion]
    if len(a) != len(b) or np.abs(a - b).max() > 1e-9:
        shares = np.linspace(0, 1, SAMPLES)
        places = [CubicSpline(s, r)(shares) for s, r in zip((a, b), places, strict=True)]
        frames = [CubicSpline(s, q)(shares) for s, q in zip((a, b), frames, strict=True)]
        frames = [q / np.linalg.norm(q, axis=1)[:, None] for q in frames]
    length = max(one.arc_length[-1], other.arc_length[-1])
    moved = np.linalg.norm(places[0] - places[1], axis=1).max() / length
    between = rotation.multiply(rotation.conjugate(frames[0]), frames[1])
    turned = np.linalg.norm(rotation.logarithm(between), axis=1).max()
    return np.array([moved, turned / np.pi])
