# SPDX-License-Identifier: LGPL-2.1-or-later
"""Places and features of contact are looked up anew at the last solve until they stay."""

import numpy as np

from ..transcription import arms
from ..transcription.shape import Shape
from .problem import Problem
from .surroundings import NEAR
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


def settled(
    problem: Problem, shape: Shape, reach=NEAR, *, leaving=0, fallback=False, hasty=False
) -> Trial | None:
    """The equilibrium on the nodes of ``shape`` that the iteration finds from it, with its own places; None if it finds
    none. ``reach``: up to what gap elements are given places; ``leaving``: whether they are to leave what they are in,
    and which way the cable leaves itself; ``fallback``: whether it is worth asking the slower solver too; ``hasty``:
    see ``Problem.solve``."""
    around_it = problem.surroundings
    enough, near, last = SETTLED * around_it.radius, None, np.inf
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
        if stale < enough:
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
