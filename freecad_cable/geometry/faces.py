# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles by rows: of one surface, or of several that are asked at once."""

from dataclasses import dataclass, fields

import numpy as np

from .creases import COPLANAR, Creases
from .nearest import FLAT, ROUNDING, Nearest, measured
from .rotation import cross

FACE, EDGE, VERTEX = 0, 1, 4
"""Places on a triangle: its inside; EDGE + i, from vertex i to the next; VERTEX + i."""


@dataclass(frozen=True, eq=False)
class Faces:
    """t triangles, and of each of their 7 places what is nearest there: one of f features."""

    corners: np.ndarray
    """(t, 3, 3)"""
    sides: np.ndarray
    """(t, 3, 3) from each corner to the next"""
    normal: np.ndarray
    """(t, 3) outward, unit"""
    inward: np.ndarray
    """(t, 3, 3) across each side"""
    per_square: np.ndarray
    """(t, 3) one by the square of the length of each side"""
    feature: np.ndarray
    """(t, 7) which feature each place belongs to"""
    kind: np.ndarray
    """(f,) FLAT, LINE or POINT, of what is outside"""
    axis: np.ndarray
    """(f, 3) unit, of a LINE"""
    pseudo: np.ndarray
    """(f, 3) pseudo-normal, unit; zeros where there is none"""
    rim: np.ndarray
    """(f,) whether the surface ends there"""

    @classmethod
    def over(cls, vertices, triangles, normal, edges) -> "Faces":
        """Triangles (t, 3) over vertices (n, 3), with unit normals (t, 3)."""
        corners = vertices[triangles]
        sides = np.roll(corners, -1, axis=1) - corners
        creases = Creases(edges, vertices, triangles, normal)
        count, edge_count = len(triangles), len(edges.count)
        of_edges, of_vertices = count + edges.of, count + edge_count + triangles
        return cls(
            corners,
            sides,
            normal,
            cross(normal[:, None, :], sides),
            1 / np.einsum("tij,tij->ti", sides, sides),
            np.concatenate([np.arange(count)[:, None], of_edges, of_vertices], axis=1),
            np.concatenate([np.full(count, FLAT), creases.edge_kind, creases.vertex_kind]),
            np.concatenate([np.zeros((count, 3)), creases.edge_axis, creases.vertex_axis]),
            np.concatenate([normal, creases.edge_normal, creases.vertex_normal]),
            np.concatenate([np.zeros(count, bool), creases.edge_rim, creases.vertex_rim]),
        )

    def __len__(self):
        return len(self.normal)

    @classmethod
    def joined(cls, several) -> "Faces":
        """Those of several surfaces, one after the other."""
        if len(several) == 1:
            return several[0]
        rows = {row.name: [getattr(each, row.name) for each in several] for row in fields(cls)}
        before = np.cumsum([0] + [len(each.kind) for each in several[:-1]])
        rows["feature"] = [row + b for row, b in zip(rows["feature"], before, strict=True)]
        return cls(**{name: np.concatenate(row) for name, row in rows.items()})

    def closest(self, points, faces):
        """Squared distance (p,), nearest point (p, 3) and place (p,) on one face for each point."""
        sides, normal = self.sides[faces], self.normal[faces]
        away = points[:, None, :] - self.corners[faces]
        within = np.einsum("pij,pij->pi", away, self.inward[faces]) > 0
        within = within[:, 0] & within[:, 1] & within[:, 2]
        height = np.einsum("pi,pi->p", away[:, 0], normal)

        part = np.einsum("pij,pij->pi", away, sides) * self.per_square[faces]
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

    def nearest(self, points, face, squared, center, place) -> Nearest:
        """What is nearest to points (m, 3): places on one face for each, as of ``closest``."""
        feature, normal = self.feature[face, place], self.normal[face]
        kind, axis, pseudo, rim = (
            rows[feature] for rows in (self.kind, self.axis, self.pseudo, self.rim)
        )
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
