# SPDX-License-Identifier: LGPL-2.1-or-later
"""One length of a cable whose length is asked for: whether an equilibrium is found, and what it satisfies."""

import time
from dataclasses import dataclass, replace

import numpy as np

from ..errors import ProblemError
from ..problem.reach import shortest_way, stations
from ..result import Solution
from ..status import Status

LONGEST = 4.0
"""Longest cable that is tried, over the shortest possible (see ``longest``)."""
TAUTEST = 1e-3
"""Slack of the shortest one that is tried, relative to the shortest possible."""
PATIENCE, LEAST = 3.0, 2.0
"""Time for one length, in the longest time that one took until it was solved, and at least [s]: one at which there is
no equilibrium takes as long as it is given."""
FIRST = 0.5
"""Time for a length until one is solved, as a share of the limit: a longer one may be much easier."""


def longest(way: float, rod) -> float:
    """[m] Longest cable that is tried where the shortest way through what holds it is ``way`` long: however near its
    ends are to each other, it takes half a circle of its bend radius to come back."""
    return LONGEST * (way + np.pi * (rod.min_bend_radius or 0.0))


@dataclass(frozen=True)
class Sample:
    """What one length satisfies: the requirement with the least margin, relative to its limit."""

    length: float
    solution: Solution | None
    margin: float
    requirement: str
    arc_length: float | None
    sentence: str

    @property
    def feasible(self) -> bool:
        return self.margin >= 0

    @property
    def solved(self) -> bool:
        return self.margin > -np.inf


class Sampler:
    """What the lengths of a scene satisfy."""

    def __init__(self, scene, solve):
        self.scene, self.solve = scene, solve
        self.way = shortest_way(stations(scene))
        self.most = longest(self.way, scene.rod)
        self.least = max(self.way * (1 + TAUTEST), TAUTEST * self.most)
        if not (scene.spans and self.most):
            why = "its ends are at one place" if scene.spans else "an end is free"
            raise ProblemError(
                "cable.length_mode", f"asks for a length, but {why}, so that any will do; give one"
            )
        self.slowest = None
        """[s] that a length took until it was solved; None before one is"""

    def __call__(self, length, last) -> Sample:
        """``last``: an earlier solution to start from, or None."""
        scene, limit = self.scene, self.scene.options.time_limit
        patience = FIRST * limit
        if self.slowest is not None:
            patience = min(limit, max(PATIENCE * self.slowest, LEAST))
        begin = time.perf_counter()
        try:
            scene = replace(scene, rod=replace(scene.rod, length=length), asks_length=False)
            hurried = replace(scene, options=replace(scene.options, time_limit=patience))
            solution = self.solve(hurried, start=last)
        except ProblemError as error:
            return Sample(length, None, -np.inf, "reach", None, str(error))
        solution = replace(solution, scene=scene)
        if not solution.status.success:
            hasty = solution.status is Status.TIME_LIMIT and patience < limit
            sentence = Status.NOT_CONVERGED.value if hasty else solution.message
            return Sample(length, solution, -np.inf, "equilibrium", None, sentence)
        took = time.perf_counter() - begin
        self.slowest = max(self.slowest or 0.0, took)
        return _judged(scene, solution)

    def beyond(self, length, factor, most=np.inf) -> float | None:
        """The next length, with so many times the slack, in the bounds of what is tried; None beyond these."""
        wanted = self.way + (length - self.way) * factor
        wanted = np.clip(wanted, self.least, min(most, self.most))
        return float(wanted) if (wanted - length) * (factor - 1) > 1e-9 * length else None


def _judged(scene, solution) -> Sample:
    rod, length = scene.rod, scene.rod.length
    found = []
    if rod.min_bend_radius is not None:
        radius, place = solution.min_bend_radius
        found.append(
            (
                min(radius / rod.min_bend_radius, 1e9) - 1,
                "bend radius",
                place,
                f"it bends to {radius:.4g} m at {place:.4g} m, and {rod.min_bend_radius:.4g} m is the limit",
            )
        )
    if (first := solution.pushed_clear) is not None:
        place = scene.obstacles[first.obstacle].place
        found.append(
            (
                -1.0,
                "clearance",
                first.arc_length,
                f"it must be pushed from {place} at {first.arc_length:.4g} m to keep {scene.clearance:.4g} m clear",
            )
        )
    if not found:
        return Sample(length, solution, np.inf, "none", None, "there is no requirement")
    return Sample(length, solution, *min(found))
