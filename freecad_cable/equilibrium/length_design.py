# SPDX-License-Identifier: LGPL-2.1-or-later
"""The length as the answer: the shortest cable whose free equilibrium keeps its bend radius and its clearance.

The tightest bend of a free cable is no monotone function of its length (a taut cable bends sharply at its ends, a slack
one under its weight), so what is feasible is an interval, or nothing. It is found by walking from the length of a
spline to shorter and to longer ones, each equilibrium starting from the last, and by closing in on both ends.
"""

import time
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
AMPLE = 1.5
"""The same among obstacles, over one that will do: there a slack cable takes a hundred times as long as a short one,
and none is ordered half as long again as it need be."""
TAUTEST = 1e-3
"""Slack of the shortest one that is tried, relative to the shortest possible."""
GROWTH = 1.4
"""Factor of the slack from one length that is tried to the next."""
PRECISION = 1e-5
"""Of the ends of the interval, relative to the length."""
ROUGHLY = 1e-3
"""The same where the shortest is no requirement, but the last length at which an equilibrium was found."""
PATIENCE, LEAST = 3.0, 2.0
"""Time for one length, in the longest time that one took until it was solved, and at least [s]: one at which there is
no equilibrium takes as long as it is given."""
FIRST = 0.5
"""Time for a length until one is solved, as a share of the limit: a longer one may be much easier."""


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


def shortest(scene: Scene, solve) -> Solution:
    """The solution with the shortest feasible length and ``feasible_lengths``; or, if no length is feasible, status
    INFEASIBLE and a sentence that says which requirement fails by how much.

    ``solve(scene, start=None)`` finds an equilibrium at a given length.
    """
    way, sample = shortest_way(stations(scene)), Sampler(scene, solve)
    tried = _until_solved(sample, way, max(_spline_length(scene), way * (1 + TAUTEST)))
    # What was not found from nothing, at lengths before, may well be found from there.
    first, samples = tried[-1], tried
    if first.solved:
        samples = [
            *_walk(sample, way, first, 1 / GROWTH)[::-1],
            first,
            *_walk(sample, way, first, GROWTH),
        ]
    if not any(each.feasible for each in samples):
        samples = _with_best(sample, samples)
    good = [i for i, each in enumerate(samples) if each.feasible]
    if not good:
        return _infeasible(samples)
    a = b = good[0]
    # One length at which none is found between two that will do is the solver's, not the cable's.
    while any(each.feasible for each in samples[b + 1 : b + 2]) or _skipped(samples[b + 1 : b + 3]):
        b += 1 if samples[b + 1].feasible else 2
    first, end = samples[a], samples[b]
    if a > 0:
        first, before = _bracketed(sample, first, samples[a - 1], end)
        low = _bound(first, before, "shorter", "shortest")
    else:
        low = _tried(first, "shortest")
    if b + 1 < len(samples):
        beyond = samples[b + 1]
        if beyond.solved:
            end, beyond = _bracketed(sample, end, beyond, first)
        high = _bound(end, beyond, "longer", "longest")
    else:
        high = _tried(end, "longest")
    message = f"{first.solution.message} {low.sentence} {high.sentence}"
    return replace(first.solution, message=message, feasible_lengths=(low, high), anew=False)


def _skipped(two):
    return len(two) == 2 and not two[0].solved and two[1].feasible


def _spline_length(scene) -> float:
    """Of the spline that a designer would draw."""
    points = [station.position for station in stations(scene)]
    try:
        return spline(points, orientation(scene.start), orientation(scene.end)).length
    except ProblemError:
        return 0.0


def _until_solved(sample, way, length) -> list:
    """Samples from a length on until one is solved: among obstacles it may take much more than past them."""
    samples = [sample(length, None)]
    while not samples[-1].solved:
        length = way + (length - way) * GROWTH**2
        if length > LONGEST * way:
            break
        samples.append(sample(length, None))
    return samples


def _walk(sample, way, first, factor) -> list:
    """Samples beyond the first, which is solved, until what was feasible is no more or the end is reached."""
    samples, last, longest = [first], first.solution, LONGEST * way
    while True:
        before = samples[-1]
        if before.feasible and sample.scene.obstacles:
            longest = min(longest, AMPLE * before.length)
        length = way + (before.length - way) * factor
        if not (1 + TAUTEST) * way <= length <= longest:
            return samples[1:]
        here = sample(length, last)
        samples.append(here)
        if here.solved:
            last = here.solution
        # Shorter cables only pull harder; one that does not even solve has no better neighbour there.
        if factor < 1 and here.margin < before.margin and not here.feasible:
            return samples[1:]
        # Longer ones do not, and one that does not solve may be an accident.
        if before.feasible and here.solved and not here.feasible:
            return samples[1:]
        if not (before.solved or here.solved):
            return samples[1:-1]


class Sampler:
    """What the lengths of a scene satisfy."""

    def __init__(self, scene, solve):
        self.scene, self.solve = scene, solve
        self.longest = None
        """[s] that a length took until it was solved; None before one is"""

    def __call__(self, length, last) -> Sample:
        """``last``: an earlier solution to start from, or None."""
        scene, limit = self.scene, self.scene.options.time_limit
        scene = replace(scene, rod=replace(scene.rod, length=length), asks_length=False)
        patience = FIRST * limit
        if self.longest is not None:
            patience = min(limit, max(PATIENCE * self.longest, LEAST))
        hurried = replace(scene, options=replace(scene.options, time_limit=patience))
        begin = time.perf_counter()
        try:
            solution = self.solve(hurried, start=last)
        except ProblemError as error:
            return Sample(length, None, -np.inf, "reach", None, str(error))
        solution = replace(solution, scene=scene)
        if not solution.status.success:
            return Sample(length, solution, -np.inf, "equilibrium", None, solution.message)
        took = time.perf_counter() - begin
        self.longest = max(self.longest or 0.0, took)
        return _judged(scene, solution)


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


def _with_best(sample, samples):
    """The samples, and the best length between the neighbours of the best: what is feasible may lie between two."""
    best = int(np.argmax([each.margin for each in samples]))
    if not samples[best].solved:
        return samples
    low, high = samples[max(best - 1, 0)].length, samples[min(best + 1, len(samples) - 1)].length
    tried = []

    def loss(length):
        tried.append(sample(float(length), samples[best].solution))
        return -max(tried[-1].margin, -1e9)

    minimize_scalar(loss, bounds=(low, high), method="bounded", options={"xatol": 1e-4 * high})
    found = max(tried, key=lambda each: each.margin)
    return sorted([*samples, found], key=lambda each: each.length)


def _bracketed(sample, inside, outside, further):
    """The feasible and the infeasible length next to where feasibility ends: regula falsi (Illinois form) where the
    margin is known on both sides, else by what the last two feasible ones promise, ``further`` inside the one before.
    """
    weights, moved = [1.0, 1.0], None
    while abs(outside.length - inside.length) > _precision(outside) * inside.length:
        way = outside.length - inside.length
        if outside.solved and inside.margin < 1e3:
            a, b = inside.margin * weights[0], -outside.margin * weights[1]
            share = a / (a + b)
        else:
            share = min(_promised(inside, further) / way, 0.5)
        # At least half the precision from either side, so that the bracket closes.
        least = _precision(outside) * inside.length / 2 / abs(way)
        share = np.clip(share, least, 1 - least)
        middle = sample(float(inside.length + share * way), inside.solution)
        # An end that stays twice would stay for long.
        stays = int(middle.feasible)
        weights[stays] *= 0.5 if moved == 1 - stays else 1.0
        weights[1 - stays], moved = 1.0, 1 - stays
        if middle.feasible:
            inside, further = middle, inside
        else:
            outside = middle
    return inside, outside


def _precision(outside):
    return PRECISION if outside.solved or outside.requirement == "reach" else ROUGHLY


def _promised(inside, further):
    """Way on from the one to where the margin is used up, if it goes on as it does between the two; with its sign."""
    used, way = further.margin - inside.margin, inside.length - further.length
    return way * inside.margin / used if 0 < used < 1e3 else np.copysign(np.inf, way)


def _tried(sample, which) -> LengthBound:
    sentence = f"{sample.length:.6g} m is the {which} that was tried."
    return LengthBound(sample.length, None, None, sentence)


def _bound(inside, outside, direction, which) -> LengthBound:
    if outside.requirement == "equilibrium":
        sentence = (
            f"{inside.length:.6g} m is the {which} at which an equilibrium was found. At {outside.length:.6g} m: "
            f"{outside.sentence}"
        )
    else:
        sentence = f"If {direction} than {inside.length:.6g} m, {outside.sentence.rstrip('.')}."
    return LengthBound(inside.length, outside.requirement, outside.arc_length, sentence)


def _infeasible(samples) -> Solution:
    best = max(samples, key=lambda each: each.margin)
    if best.solution is None:
        raise ProblemError("cable.length_mode", f"no length will do: {best.sentence}")
    longest = samples[-1].length
    message = (
        f"{Status.INFEASIBLE.value} No length up to {longest:.4g} m will do. The best is {best.length:.6g} m, but "
        f"{best.sentence}; a limit that this length keeps, other ends or supports, or a softer cable would help."
    )
    return replace(best.solution, status=Status.INFEASIBLE, message=message)
