# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a cable came through an obstacle: of one that is thinner than a step an iteration may not know."""

from dataclasses import replace

import numpy as np

from ..transcription.shape import Shape

LEAST = 2.0
"""Way, in distances to keep, below which nothing is passed through: from one side of a sheet to the other."""
THROUGH = 0.5
"""Share of the distance to keep, nearer than which what changes sides is taken to come through."""


def passed_through(around_it, before: Shape, after: Shape) -> bool:
    """Whether a place of the cable that goes straight from where it is ``before`` to where it is ``after`` comes
    through an obstacle to another side of it."""
    after = replace(after, joints=())  # supports that slide are elsewhere on it
    moved = np.linalg.norm(after.on(before.arc_length).position - before.position, axis=1).max()
    if moved <= LEAST * around_it.keep:
        return False
    # What touched the cable may be out of its reach now.
    around_it = around_it.whole
    look = around_it.look(before, moved)
    here = look.fine.position
    there = after.on(look.fine.arc_length).position
    way = np.linalg.norm(there - here, axis=1)
    for near, gap in zip(look.found, look.gaps, strict=True):
        may = (way > LEAST * around_it.keep) & (gap < way)
        some = near.where[may[near.where]]
        if not len(some):
            continue
        was, now = near.of(some), around_it.nearest_of(near.obstacle, there[some])
        some = some[np.einsum("mi,mi->m", was.normal, now.normal) < 0]
        if len(some) and _nearest_on_way(around_it, near.obstacle, here[some], there[some]) < (
            THROUGH * around_it.keep
        ):
            return True
    return False


def _nearest_on_way(around_it, obstacle, here, there):
    way = np.linalg.norm(there - here, axis=1).max()
    parts = np.linspace(0.0, 1.0, int(np.ceil(way / (THROUGH * around_it.keep))) + 1)
    points = here + parts[:, None, None] * (there - here)
    return around_it.nearest_of(obstacle, points.reshape(-1, 3)).distance.min()
