# SPDX-License-Identifier: LGPL-2.1-or-later
"""The length as the answer: the shortest cable whose free equilibrium keeps its bend radius and its clearance.

The tightest bend of a free cable is no monotone function of its length (a taut cable bends sharply at its ends, a slack
one under its weight), so what is feasible is an interval, or nothing. It is found by walking from the length of a
spline to shorter and to longer ones, each equilibrium starting from the last, and by closing in on both ends.
"""

from dataclasses import dataclass, replace

import numpy as np
from scipy.optimize import minimize_scalar

from ..errors import ProblemError
from ..geometry.curves import spline
from ..problem import Scene
from ..problem.reach import shortest_way, stations
from ..problem.reduce import orientation
from ..result import LengthBound, Solution
from ..status import Status

LONGEST = 4.0
"""Longest cable that is tried, over the shortest possible."""
TAUTEST = 1e-3
"""Slack of the shortest one that is tried, relative to the shortest possible."""
GROWTH = 1.4
"""Factor of the slack from one length that is tried to the next."""
PRECISION = 1e-5
"""Of the ends of the interval, relative to the length."""


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


def shortest(scene: Scene, solve) -> Solution:
    """The solution with the shortest feasible length and ``feasible_lengths``; or, if no length is feasible, status
    INFEASIBLE and a sentence that says which requirement fails by how much.

    ``solve(scene, start=None)`` finds an equilibrium at a given length.
    """
    way = shortest_way(stations(scene))
    first = _sample(scene, max(_spline_length(scene), way * (1 + TAUTEST)), solve, None)
    samples = _walk(scene, solve, way, first, 1 / GROWTH)[::-1] + [first]
    samples += _walk(scene, solve, way, first, GROWTH)
    if not any(sample.feasible for sample in samples):
        samples = _with_best(scene, solve, samples)
    good = [i for i, sample in enumerate(samples) if sample.feasible]
    if not good:
        return _infeasible(samples)
    a = good[0]
    b = next(
        i for i in range(a, len(samples)) if i + 1 == len(samples) or not samples[i + 1].feasible
    )
    first, end = samples[a], samples[b]
    if a > 0:
        first, before = _bracketed(scene, solve, first, samples[a - 1])
        low = _bound(first, before, "shorter")
    else:
        low = _tried(first, "shortest")
    if b + 1 < len(samples):
        end, beyond = _bracketed(scene, solve, end, samples[b + 1])
        high = _bound(end, beyond, "longer")
    else:
        high = _tried(end, "longest")
    message = f"{first.solution.message} {low.sentence} {high.sentence}"
    return replace(first.solution, message=message, feasible_lengths=(low, high))


def _spline_length(scene) -> float:
    """Of the spline that a designer would draw."""
    points = [station.position for station in stations(scene)]
    try:
        return spline(points, orientation(scene.start), orientation(scene.end)).length
    except ProblemError:
        return 0.0


def _walk(scene, solve, way, first, factor) -> list:
    """Samples from the first on, until what was feasible is no more or the end is reached."""
    samples, last = [first], first.solution
    while True:
        length = way + (samples[-1].length - way) * factor
        if not 1 + TAUTEST <= length / way <= LONGEST:
            return samples[1:]
        samples.append(_sample(scene, length, solve, last))
        before, here = samples[-2:]
        if here.margin > -np.inf:
            last = here.solution
        # Shorter cables only pull harder; one that does not even solve has no better neighbour there.
        lost = factor < 1 and here.margin < before.margin and not here.feasible
        if (before.feasible and not here.feasible) or lost:
            return samples[1:]


def _sample(scene, length, solve, last) -> Sample:
    rod = replace(scene.rod, length=length)
    try:
        solution = solve(replace(scene, rod=rod, asks_length=False), start=last)
    except ProblemError as error:
        return Sample(length, None, -np.inf, "reach", None, str(error))
    if not solution.status.success:
        return Sample(length, solution, -np.inf, "equilibrium", None, solution.message)
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
    with_obstacles = [c for c in solution.contacts if c.obstacle is not None]
    if scene.clearance > 0 and with_obstacles:
        first = with_obstacles[0]
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


def _with_best(scene, solve, samples):
    """The samples, and the best length between the neighbours of the best: what is feasible may lie between two."""
    best = int(np.argmax([sample.margin for sample in samples]))
    if samples[best].margin == -np.inf:
        return samples
    low, high = samples[max(best - 1, 0)].length, samples[min(best + 1, len(samples) - 1)].length
    tried = []

    def loss(length):
        tried.append(_sample(scene, float(length), solve, samples[best].solution))
        return -max(tried[-1].margin, -1e9)

    minimize_scalar(loss, bounds=(low, high), method="bounded", options={"xatol": 1e-4 * high})
    found = max(tried, key=lambda sample: sample.margin)
    return sorted([*samples, found], key=lambda sample: sample.length)


def _bracketed(scene, solve, inside, outside):
    """The feasible and the infeasible length next to where feasibility ends: regula falsi (Illinois form) where the
    margin is known on both sides, else bisection."""
    weights = [1.0, 1.0]
    while abs(outside.length - inside.length) > PRECISION * inside.length:
        share = 0.5
        if np.isfinite(outside.margin) and inside.margin < 1e3:
            a, b = inside.margin * weights[0], -outside.margin * weights[1]
            share = a / (a + b)
        # At least half the precision from either side, so that the bracket closes.
        least = PRECISION * inside.length / 2 / abs(outside.length - inside.length)
        share = np.clip(share, least, 1 - least)
        length = inside.length + share * (outside.length - inside.length)
        middle = _sample(scene, float(length), solve, inside.solution)
        if middle.feasible:
            inside, weights = middle, [1.0, weights[1] / 2]
        else:
            outside, weights = middle, [weights[0] / 2, 1.0]
    return inside, outside


def _tried(sample, which) -> LengthBound:
    sentence = f"{sample.length:.6g} m is the {which} that was tried."
    return LengthBound(sample.length, None, None, sentence)


def _bound(inside, outside, direction) -> LengthBound:
    sentence = f"If {direction} than {inside.length:.6g} m, {outside.sentence}."
    return LengthBound(inside.length, outside.requirement, outside.arc_length, sentence)


def _infeasible(samples) -> Solution:
    best = max(samples, key=lambda sample: sample.margin)
    if best.solution is None:
        raise ProblemError("cable.length_mode", f"no length will do: {best.sentence}")
    longest = samples[-1].length
    message = (
        f"{Status.INFEASIBLE.value} No length up to {longest:.4g} m will do. The best is {best.length:.6g} m, but "
        f"{best.sentence}; a limit that this length keeps, other ends or supports, or a softer cable would help."
    )
    return replace(best.solution, status=Status.INFEASIBLE, message=message)
