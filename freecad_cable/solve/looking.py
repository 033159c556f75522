# SPDX-License-Identifier: LGPL-2.1-or-later
"""A look at the obstacles around a shape: how near they come to its elements, and where."""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ..geometry.nearest import Nearest
from ..transcription.shape import Shape

CLOSER = 0.25
"""Distance between samples, in radii of the cable, where it may touch: of an edge 1/128 of a radius goes between."""
FEWEST, MOST_INSIDE = 4, 64
"""Samples of an element where it may touch: at least so many beside a node that is held, at most so many."""


@dataclass(frozen=True, eq=False)
class Near:
    """What is nearest of an obstacle, its number among those of the surroundings, to points with numbers ``where``."""

    obstacle: int
    where: np.ndarray
    what: Nearest

    def of(self, points) -> Nearest:
        """What is nearest to some of the points, by their numbers."""
        place = np.empty(self.where.max(initial=0) + 1, int)
        place[self.where] = np.arange(len(self.where))
        return self.what.taken(place[points])

    def at(self, where) -> "Near":
        """The same with other numbers of the points."""
        return Near(self.obstacle, where, self.what)

    def and_(self, other: "Near | None") -> "Near":
        """With what is nearest to more points."""
        if other is None:
            return self
        where = np.concatenate([self.where, other.where])
        return Near(self.obstacle, where, self.what.joined(other.what))


@dataclass(frozen=True, eq=False)
class Look:
    """Of a ``shape``. ``fine``: the same with samples inside the elements that may touch. ``begin`` (n+1,): the samples
    that are its nodes. ``found``: what is nearest of each obstacle that is near. ``gaps`` (obstacles, samples): what is
    left of the distance to keep, infinite where that does not matter. ``bound`` (n,): no gap inside an element is less,
    as far as is known from its nodes; where that is less than 0 it is looked at inside."""

    shape: Shape
    reach: float
    fine: Shape
    begin: np.ndarray
    found: list[Near]
    gaps: np.ndarray
    bound: np.ndarray

    @classmethod
    def at(cls, around_it, shape, reach) -> "Look":
        """At all that is nearer than ``reach`` to a node, and all that an element may touch."""
        held, radius, steps = around_it.held(shape), around_it.radius, shape.steps
        # Between two nodes no gap is less than at the nearer by more than half their distance; one that is held says
        # nothing of what is beside it.
        half, fewest = steps / 2, np.ones(len(steps))
        for node in held:
            both = slice(max(node - 1, 0), node + 1)
            half[both], fewest[both] = steps[both], FEWEST
        beside = np.maximum(np.append(half, 0.0), np.append(0.0, half))
        known = np.maximum(reach, beside)
        found = around_it.nearest(shape.position, known + around_it.keep, held)
        gaps = around_it.gaps(shape, found)
        least = np.minimum(gaps.min(axis=0, initial=np.inf), known)
        bound = np.minimum(least[:-1], least[1:]) - half
        look = cls(shape, reach, shape, np.arange(len(shape.arc_length)), found, gaps, bound)
        counts = np.ceil(steps / (CLOSER * radius)).clip(fewest, MOST_INSIDE)
        look = look._closer(around_it, np.where(bound < 0, counts, 1))
        if (steps <= MOST_INSIDE * CLOSER * radius).all():
            return look
        # Of a cable as thin as this, only what is nearest is looked at as closely as it is thin.
        apart, gaps = np.diff(look.fine.arc_length), look.gaps.min(axis=0, initial=np.inf)
        near = np.minimum(gaps[:-1], gaps[1:]) < apart / 2
        counts = np.ceil(apart / (CLOSER * radius)).clip(1, MOST_INSIDE)
        return look._closer(around_it, np.where(near, counts, 1))

    def _closer(self, around_it, counts) -> "Look":
        """With so many (samples − 1,) for each sample."""
        fine, places = sampled(self.shape, self.fine.arc_length, counts.astype(int))
        if len(fine.arc_length) == len(self.fine.arc_length):
            return self
        new = np.ones(len(fine.arc_length), bool)
        new[places] = False
        apart = np.diff(fine.arc_length, append=fine.arc_length[-1])
        within = np.where(new, np.maximum(2 * around_it.keep, around_it.keep + apart), -np.inf)
        closely = {near.obstacle: near for near in around_it.nearest(fine.position, within)}
        found = [
            near.at(places[near.where]).and_(closely.get(near.obstacle)) for near in self.found
        ]
        return replace(
            self,
            fine=fine,
            begin=places[self.begin],
            found=found,
            gaps=around_it.gaps(fine, found),
        )

    @cached_property
    def least(self) -> np.ndarray:
        """(n,) smallest gap over each element, its nodes included."""
        smallest = self.gaps.min(axis=0, initial=np.inf)
        least = np.minimum.reduceat(smallest[:-1], self.begin[:-1])
        return np.minimum(least, smallest[self.begin[1:]])


def unhindered(around_it, before, after):
    """Whether no obstacle is in or between two shapes: each place goes straight from one ball of free space into
    another."""
    # As one piece: supports that slide are elsewhere on the one than on the other.
    there = replace(before, joints=()).on(after.arc_length).position
    moved = np.linalg.norm(after.position - there, axis=1)
    moved = np.maximum(moved[:-1], moved[1:])
    room = around_it.look(after, moved.max()).least
    if room.min() <= 0:
        return False
    if (room > moved).all():
        return True
    same = np.array_equal(before.arc_length, after.arc_length)
    return same and bool((room + around_it.look(before, moved.max()).least.clip(0) > moved).all())


def sampled(shape, arc_length, counts) -> tuple[Shape, np.ndarray]:
    """A shape at ``arc_length`` (m+1,) and between, with so many samples (m,) for each but the last, and which of them
    these are (m+1,)."""
    begin = np.append(0, np.cumsum(counts))
    part = np.arange(begin[-1]) - np.repeat(begin[:-1], counts)
    start, apart = (
        np.repeat(each, counts) for each in (arc_length[:-1], np.diff(arc_length) / counts)
    )
    return shape.on(np.append(start + part * apart, arc_length[-1])), begin
