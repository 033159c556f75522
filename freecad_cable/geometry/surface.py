# SPDX-License-Identifier: LGPL-2.1-or-later
"""Distance to a triangulated surface, and its nearest feature."""

from functools import cached_property

import numpy as np

from .box_tree import BoxTree
from .creases import COPLANAR, Creases, Edges
from .nearest import FLAT, ROUNDING, Nearest, measured
from .rotation import cross

FACE, EDGE, VERTEX = 0, 1, 4
"""Places on a triangle: its inside; EDGE + i, from vertex i to the next; VERTEX + i."""


class Surface:
    """Triangles (t, 3), t at least 1, over vertices (n, 3), counter-clockwise seen from outside.

    No triangle may be degenerate, and no two vertices may be at the same place.
    """

    def __init__(self, vertices, triangles):
        self.vertices, self._triangles = vertices, triangles
        self._corners = vertices[triangles]
        self._sides = np.roll(self._corners, -1, axis=1) - self._corners
        normal = cross(self._sides[:, 0], self._sides[:, 1])
        self._normal = normal / np.linalg.norm(normal, axis=1, keepdims=True)

    @cached_property
    def edges(self) -> Edges:
        return Edges(self._triangles)

    @property
    def closed(self) -> bool:
        """Whether there is a triangle on the other side of every edge."""
        return bool((self.edges.count > 1).all())

    @property
    def volume(self) -> float:
        """Of a closed surface; negative if its triangles are clockwise seen from outside."""
        a, b, c = np.moveaxis(self._corners - self._corners[0, 0], 1, 0)
        return float(np.sum(a * cross(b, c)) / 6)

    def nearest(self, points) -> Nearest:
        """Distance and nearest feature of points (m, 3).

        Inside, the feature is flat: the nearest face, or at a re-entrant edge or corner the plane through it and
        square to the way out. The surface is the boundary of what is behind it, and the sign by the angle-weighted
        pseudo-normal: Bærentzen, Aanæs, "Signed distance computation using the angle weighted pseudonormal", IEEE
        TVCG 11, 2005. An open surface has a front and a back, but beyond its rim a point is outside on either side.
        """
        face = self._tree.nearest(points, lambda some, faces: self._closest(some, faces)[0])
        squared, center, place = self._closest(points, face)
        kind, axis, pseudo, rim = self._features(face, place)
        normal = self._normal[face]
        pseudo = np.where(pseudo.any(axis=1)[:, None], pseudo, normal)

        away, length = points - center, np.sqrt(squared)
        scale = np.maximum(np.abs(points).max(axis=1), np.abs(center).max(axis=1))
        touching = length <= ROUNDING * scale
        # A point straight over a face belongs to it even if rounding, or a crack between faces, says edge or vertex.
        height = np.abs(np.einsum("mi,mi->m", away, normal))
        over = (place == FACE) | (height >= (1 - COPLANAR**2 / 2) * length) & ~touching
        behind = (np.einsum("mi,mi->m", away, pseudo) < 0) & ~rim & ~touching
        kind = np.where(over | behind, FLAT, kind)
        direction = np.where((kind == FLAT)[:, None], normal, axis)
        deep = behind & ~over
        direction[deep] = -away[deep] / length[deep, None]
        return measured(points, kind, center, direction, 0.0, pseudo)

    def _features(self, face, place):
        """Kind, axis, pseudo-normal and whether it is a rim, of places on faces."""
        creases = self._creases
        kind, axis = np.full(len(face), FLAT), np.zeros((len(face), 3))
        pseudo, rim = self._normal[face], np.zeros(len(face), bool)
        on_edge, on_vertex = (place >= EDGE) & (place < VERTEX), place >= VERTEX
        edge = creases.edges.of[face[on_edge], place[on_edge] - EDGE]
        kind[on_edge], axis[on_edge] = creases.edge_kind[edge], creases.edge_axis[edge]
        pseudo[on_edge], rim[on_edge] = creases.edge_normal[edge], creases.edge_rim[edge]
        vertex = self._triangles[face[on_vertex], place[on_vertex] - VERTEX]
        kind[on_vertex], axis[on_vertex] = creases.vertex_kind[vertex], creases.vertex_axis[vertex]
        pseudo[on_vertex], rim[on_vertex] = (
            creases.vertex_normal[vertex],
            creases.vertex_rim[vertex],
        )
        return kind, axis, pseudo, rim

    def _closest(self, points, faces):
        """Squared distance (p,), nearest point (p, 3) and place (p,) on one face for each point."""
        sides, normal = self._sides[faces], self._normal[faces]
        away = points[:, None, :] - self._corners[faces]
        within = np.einsum("pij,pij->pi", away, self._inward[faces]) > 0
        within = within[:, 0] & within[:, 1] & within[:, 2]
        height = np.einsum("pi,pi->p", away[:, 0], normal)

        part = np.einsum("pij,pij->pi", away, sides) * self._per_square[faces]
        part = np.minimum(np.maximum(part, 0.0), 1.0)
        rest = away - part[:, :, None] * sides
        squared = np.einsum("pij,pij->pi", rest, rest)
        side = squared.argmin(axis=1)
        row = np.arange(len(points))
        part = part[row, side]
        place = np.where(
            part == 0, VERTEX + side, np.where(part == 1, VERTEX + (side + 1) % 3, EDGE + side)
        )

        rest = np.where(within[:, None], height[:, None] * normal, rest[row, side])
        squared = np.where(within, height**2, squared[row, side])
        return squared, points - rest, np.where(within, FACE, place)

    @cached_property
    def _inward(self):
        return cross(self._normal[:, None, :], self._sides)

    @cached_property
    def _per_square(self):
        return 1 / np.einsum("tij,tij->ti", self._sides, self._sides)

    @cached_property
    def _creases(self):
        return Creases(self.edges, self.vertices, self._triangles, self._normal)

    @cached_property
    def _tree(self):
        return BoxTree(self._corners, self._normal)
