# SPDX-License-Identifier: LGPL-2.1-or-later
"""Obstacles made of many pieces: a triangle mesh, and a tube along a polyline."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..errors import ProblemError
from ..geometry.box_tree import BoxTree
from ..geometry.nearest import LINE, POINT, Nearest, measured, perpendicular
from ..geometry.rotation import cross
from ..geometry.surface import Surface, nearest_of_each
from .checked import index_table, number, table
from .obstacles import EVERYWHERE, Obstacle

THINNEST = 1e-9
"""Height of a triangle relative to its longest side below which it has no normal and is dropped."""


@dataclass(frozen=True, eq=False)
class Mesh(Obstacle):
    """A solid by its surface: ``triangles`` (t, 3), indices from 0 into ``vertices`` (n, 3) [m], counter-clockwise seen
    from outside. Triangles without area are dropped, and vertices at the same place count as one.

    An open mesh is a sheet, the front of what is behind it: a point over its front is outside, one under its back is
    inside at any depth, one beyond its rim outside.
    """

    kind = "mesh"
    vertices: np.ndarray
    triangles: np.ndarray

    def __post_init__(self):
        self._keep(table, "vertices", least=3)
        self._keep(index_table, "triangles", count=len(self.vertices), things="vertices")
        surface = self._surface
        unbalanced = np.flatnonzero(surface.edges.balance)
        if len(unbalanced):
            a, b = (_shown(p) for p in surface.vertices[surface.edges.ends[unbalanced[0]]])
            raise ProblemError(
                f"{self.place}.triangles",
                f"do not part inside from outside at the edge from {a} to {b}: the triangles there do not all have the "
                "same side out, or one is missing; turn or add triangles",
            )
        if surface.closed and not surface.volume > 0:
            raise ProblemError(
                f"{self.place}.triangles",
                f"enclose {surface.volume:.6g} m³, which must be positive: they are clockwise seen from outside, or a "
                "sheet that is there twice; reverse each of them, or leave one layer out",
            )

    @property
    def closed(self) -> bool:
        """Whether the surface has no rim."""
        return self._surface.closed

    def nearest(self, points) -> Nearest:
        return self._surface.nearest(points)

    @cached_property
    def bounds(self):
        if not self.closed:
            return EVERYWHERE  # inside at any depth
        used = self.vertices[np.unique(self.triangles)]
        return np.array([used.min(axis=0), used.max(axis=0)])

    @cached_property
    def _surface(self):
        vertices, triangles = _welded(self.vertices, self.triangles)
        corners = vertices[triangles]
        sides = np.roll(corners, -1, axis=1) - corners
        longest = np.einsum("tij,tij->ti", sides, sides).max(axis=1)
        double_area = np.linalg.norm(cross(sides[:, 0], sides[:, 1]), axis=1)
        good = double_area > THINNEST * longest
        if not good.any():
            raise ProblemError(
                f"{self.place}.triangles",
                f"are {len(good)}, but none has an area: all corners of each are on one line or at one point",
            )
        return Surface(vertices, triangles[good])


@dataclass(frozen=True, eq=False)
class Tube(Obstacle):
    """All within ``radius`` [m] of the polyline through ``points`` (k, 3) [m]: another cable. Not in scene files.

    Inside, the distance is that to the line less the radius.
    """

    kind = "tube"
    points: np.ndarray
    radius: float

    def __post_init__(self):
        self._keep(table, "points", least=2)
        self._keep(number, "radius", above=0, unit="m")
        if (self.points == self.points[0]).all():
            raise ProblemError(
                f"{self.place}.points",
                f"are all {self.points[0].tolist()}; at least two must differ",
            )

    def nearest(self, points) -> Nearest:
        start, span = self._segments
        length = np.linalg.norm(span, axis=1)
        segment = self._tree.nearest(points, lambda p, s: _from_segments(p, start[s], span[s])[0])
        squared, center = _from_segments(points, start[segment], span[segment])
        axis = span[segment] / length[segment, None]
        # At a joint that is straight, rounding does not make a ball of the line.
        ahead = np.abs(np.einsum("mi,mi->m", points - center, axis))
        line = ahead <= 1e-6 * np.sqrt(squared)
        return measured(
            points,
            np.where(line, LINE, POINT),
            center,
            np.where(line[:, None], axis, 0.0),
            self.radius,
            perpendicular(axis),
        )

    @property
    def bounds(self):
        low, high = self.points.min(axis=0), self.points.max(axis=0)
        return np.array([low - self.radius, high + self.radius])

    @cached_property
    def _segments(self):
        span = np.diff(self.points, axis=0)
        real = span.any(axis=1)
        return self.points[:-1][real], span[real]

    @cached_property
    def _tree(self):
        start, span = self._segments
        axes = span / np.linalg.norm(span, axis=1, keepdims=True)
        return BoxTree(np.stack([start, start + span], axis=1), axes)


def nearest_each(obstacles, points) -> list[Nearest]:
    """What is nearest of each of several obstacles to points (m, 3) [m] of its own; of meshes all at once."""
    meshes = [k for k, each in enumerate(obstacles) if isinstance(each, Mesh)]
    known = nearest_of_each([obstacles[k]._surface for k in meshes], [points[k] for k in meshes])
    found = dict(zip(meshes, known, strict=True))
    return [found[k] if k in found else each.nearest(points[k]) for k, each in enumerate(obstacles)]


def _welded(vertices, triangles):
    """The same triangles over vertices (n, 3) of which no two are at the same place."""
    order = np.lexsort(vertices.T)
    new = np.diff(vertices[order], axis=0, prepend=np.inf).any(axis=1)
    number_of = np.empty(len(vertices), int)
    number_of[order] = np.cumsum(new) - 1
    return vertices[order[new]], number_of[triangles]


def _from_segments(points, start, span):
    """Squared distance (p,) and nearest point (p, 3) of one segment each."""
    away = points - start
    part = np.einsum("pi,pi->p", away, span) / np.einsum("pi,pi->p", span, span)
    center = start + np.clip(part, 0.0, 1.0)[:, None] * span
    rest = points - center
    return np.einsum("pi,pi->p", rest, rest), center


def _shown(point) -> str:
    return "(" + ", ".join(f"{x:.6g}" for x in point) + ")"
