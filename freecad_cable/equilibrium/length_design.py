# SPDX-License-Identifier: LGPL-2.1-or-later
"""The length as the answer: the shortest cable whose free equilibrium keeps its bend radius and its clearance.

The tightest bend of a free cable is no monotone function of its length (a taut cable bends sharply at its ends, a slack
one under its weight), so what is feasible is an interval, or nothing. It is found by walking from the length of a
spline to shorter and to longer ones, each equilibrium starting from the last, and by closing in on both ends.
"""

from dataclasses import replace

import numpy as np
from scipy.optimize import minimize_scalar

from ..errors import ProblemError
from ..geometry.curves import spline
from ..problem import Scene
from ..problem.reach import stations
from ..problem.reduce import orientation
from ..result import LengthBound, Solution
from ..status import Status
from .length_samples import Sampler

AMPLE = 1.5
"""Longest cable that is tried among obstacles, over one that will do: there a slack cable takes a hundred times as long
as a short one, and none is ordered half as long again as it need be."""
GROWTH = 1.4
"""Factor of the slack from one length that is tried to the next."""
PRECISION = 1e-5
"""Of the ends of the interval, relative to the length."""
ROUGHLY = 1e-3
"""The same where the shortest is no requirement, but the last length at which an equilibrium was found."""


def shortest(scene: Scene, solve) -> Solution:
    """The solution with the shortest feasible length and ``feasible_lengths``; or, if no length is feasible, status
    INFEASIBLE and a sentence that says which requirement fails by how much. Errors: ``ProblemError`` where any length
    would do.

    ``solve(scene, start=None)`` finds an equilibrium at a given length.
    """
    sample = Sampler(scene, solve)
    tried = _until_solved(sample)
    # What was not found from nothing, at lengths before, may well be found from there.
    samples = _around(sample, tried[-1]) if tried[-1].solved else tried
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
        before = samples[a - 1]
        if not before.solved and a > 1 and samples[a - 2].solved:
            before = samples[a - 2]
        first, before = _bracketed(sample, first, before, end)
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


def _until_solved(sample) -> list:
    """Samples from the length of a spline on until one is solved: among obstacles it may take much more than past
    them."""
    samples = [sample(max(_spline_length(sample.scene), sample.least), None)]
    while not samples[-1].solved:
        length = sample.beyond(samples[-1].length, GROWTH**2)
        if length is None:
            break
        samples.append(sample(length, None))
    return samples


def _around(sample, first) -> list:
    """Samples in order of their length, from the first, which is solved, to shorter ones and to longer ones until what
    was feasible is no more."""
    samples = [*_walk(sample, first, 1 / GROWTH)[::-1], first]
    if any(each.feasible for each in samples):
        return samples + (_walk(sample, first, GROWTH) if first.feasible else [])
    longer = _walk(sample, first, GROWTH)
    good = next((i for i, each in enumerate(longer) if each.feasible), None)
    if good is None:
        good = max(range(len(longer)), key=lambda i: longer[i].margin, default=None)
    if good is None or longer[good].margin <= max(each.margin for each in samples):
        return samples + longer
    # On its way up the cable may have left for another equilibrium, which shorter ones have, too.
    return [*_walk(sample, longer[good], 1 / GROWTH)[::-1], *longer[good:]]


def _skipped(two):
    return len(two) == 2 and not two[0].solved and two[1].feasible


def _spline_length(scene) -> float:
    """Of the spline that a designer would draw."""
    points = [station.position for station in stations(scene)]
    try:
        return spline(points, orientation(scene.start), orientation(scene.end)).length
    except ProblemError:
        return 0.0


def _walk(sample, first, factor) -> list:
    """Samples beyond the first, which is solved, until what was feasible is no more or the end is reached."""
    samples, last, most = [first], first.solution, sample.most
    while True:
        before = samples[-1]
        if before.feasible and sample.scene.obstacles:
            most = min(most, AMPLE * before.length)
        length = sample.beyond(before.length, factor, most)
        if length is None:
            return samples[1:]
        here = sample(length, last)
        samples.append(here)
        if here.solved:
            last = here.solution
            # Shorter cables only pull harder. Longer ones may yet become feasible.
            worse = factor < 1 and (here.margin < before.margin or not before.solved)
            if not here.feasible and (before.feasible or worse):
                return samples[1:]
        elif here.requirement == "reach":
            return samples[1:]
        elif not before.solved:
            return samples[1:-1]  # one that does not solve may be an accident


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
    shortest, longest = samples[0].length, samples[-1].length
    if not best.solved:
        message = (
            f"{Status.INFEASIBLE.value} From {shortest:.4g} m to {longest:.4g} m no length was found at which it is in "
            f"equilibrium. At {best.length:.6g} m: {best.sentence}"
        )
        return replace(best.solution, status=Status.INFEASIBLE, message=message)
    message = (
        f"{Status.INFEASIBLE.value} No length up to {longest:.4g} m will do. The best is {best.length:.6g} m, but "
        f"{best.sentence}; a limit that this length keeps, other ends or supports, or a softer cable would help."
    )
    return replace(best.solution, status=Status.INFEASIBLE, message=message)
