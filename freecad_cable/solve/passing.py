# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a cable came through an obstacle: of one that is thinner than a step an iteration may not know."""

from dataclasses import replace

import numpy as np

from ..transcription.shape import Shape

LEAST = 2.0
"""Way, in distances to keep, below which nothing is passed through: from one side of a sheet to the other."""
THROUGH = 0.5
"""Share of the distance to keep, nearer than which what changes sides is taken to come through."""


def passed_through(problem, before: Shape, after: Shape, pushers=None) -> bool:
    """Whether a place of the cable that goes straight from where it is ``before`` to where it is ``after`` comes
    through an obstacle to another side of it; seen from the obstacle, if that is one of ``pushers`` (see ``Problem``).
    """
    around_it, length, pushers = problem.on_the_way, problem.scaling.length, pushers or {}
    shifts = {
        number: pushers[index] / length
        for number, index in enumerate(around_it.indices)
        if index in pushers
    }
    after = replace(after, joints=())  # supports that slide are elsewhere on it
    moved = np.linalg.norm(after.on(before.arc_length).position - before.position, axis=1).max()
    moved += max(map(np.linalg.norm, shifts.values()), default=0.0)
    if moved <= LEAST * around_it.keep:
        return False
    look = around_it.look(before, moved)
    there = after.on(look.fine.arc_length).position
    for near, gap in zip(look.found, look.gaps, strict=True):
        where = near.where[np.isfinite(gap[near.where])]
        here, was = look.fine.position[where], near.of(where)
        if near.obstacle in shifts:
            here = here + shifts[near.obstacle]
            was = around_it.nearest_of(near.obstacle, here)
        if _comes_through(around_it, near.obstacle, here, was, there[where]):
            return True
    return False


def _comes_through(around_it, obstacle, here, was, there):
    way = np.linalg.norm(there - here, axis=1)
    may = np.flatnonzero((way > LEAST * around_it.keep) & (was.distance - around_it.keep < way))
    if not len(may):
        return False
    now = around_it.nearest_of(obstacle, there[may]).normal
    may = may[np.einsum("mi,mi->m", was.normal[may], now) < 0]
    if not len(may):
        return False
    closely = THROUGH * around_it.keep
    parts = np.linspace(0.0, 1.0, int(np.ceil(way[may].max() / closely)) + 1)
    points = here[may] + parts[:, None, None] * (there[may] - here[may])
    return around_it.nearest_of(obstacle, points.reshape(-1, 3)).distance.min() < closely
