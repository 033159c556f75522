# SPDX-License-Identifier: LGPL-2.1-or-later
"""A look at the obstacles around a shape: how near they come to its elements, and where."""

from dataclasses import dataclass
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
        doubtful = bound < 0
        counts = np.ceil(steps / (CLOSER * radius)).clip(fewest, MOST_INSIDE)
        fine, begin = sampled(shape, np.where(doubtful, counts, 1).astype(int))
        if fine is not shape:
            inside = np.ones(len(fine.arc_length), bool)
            inside[begin] = False
            within = np.where(inside, 2 * around_it.keep, -np.inf)
            closely = {near.obstacle: near for near in around_it.nearest(fine.position, within)}
            found = [near.at(begin[near.where]).and_(closely.get(near.obstacle)) for near in found]
            gaps = around_it.gaps(fine, found)
        return cls(shape, reach, fine, begin, found, gaps, bound)

    @cached_property
    def least(self) -> np.ndarray:
        """(n,) smallest gap over each element, its nodes included."""
        return least_of(self.gaps.min(axis=0, initial=np.inf), self.begin)


def sampled(shape, counts) -> tuple[Shape, np.ndarray]:
    """A shape with samples between its nodes, so many (n,) for each element with its first node, and which of them are
    the nodes (n+1,)."""
    begin = np.append(0, np.cumsum(counts))
    part = np.arange(begin[-1]) - np.repeat(begin[:-1], counts)
    start, apart = (
        np.repeat(each, counts) for each in (shape.arc_length[:-1], shape.steps / counts)
    )
    return shape.on(np.append(start + part * apart, shape.arc_length[-1])), begin


def least_of(values, begin) -> np.ndarray:
    """(n,) smallest of the values (samples,) over each element, both of its nodes included."""
    return np.minimum(np.minimum.reduceat(values[:-1], begin[:-1]), values[begin[1:]])
