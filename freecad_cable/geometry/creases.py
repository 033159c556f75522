# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges of a triangulated surface, and where it is creased: which edges and vertices are nearest to points outside."""

import numpy as np

from .nearest import FLAT, LINE, POINT
from .rotation import cross

COPLANAR = 1e-5
"""[rad] Below this angle two faces are one and two edges are one line. Distances are off by its square."""


class Edges:
    """The e edges of triangles (t, 3)."""

    def __init__(self, triangles):
        start, end = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
        first, last = np.minimum(start, end), np.maximum(start, end)
        key = first * (last.max() + 1) + last
        _, self.example, of, self.count = np.unique(
            key, return_index=True, return_inverse=True, return_counts=True
        )
        self.of = of.reshape(-1, 3)
        """(t, 3) the edge from each vertex of a triangle to the next"""
        self.ends = np.stack([start, end], axis=1)[self.example]
        """(e, 2) the vertices of each edge"""
        forward = np.bincount(of, start < end, len(self.count))
        self.balance = np.where(self.count > 1, 2 * forward - self.count, 0)
        """(e,) how many more triangles run along an edge one way than the other; 0 if the surface has two sides"""


class Creases:
    """What a point outside is nearest to when it is nearest to an edge (e,) or vertex (n,) of a surface.

    ``kind`` is FLAT where the surface is flat or hollow, ``axis`` the unit direction of a LINE (zeros for others),
    ``normal`` the unit pseudo-normal (Bærentzen, Aanæs 2005), ``rim`` whether the surface ends there.
    """

    def __init__(self, edges, vertices, triangles, normals):
        """``normals`` (t, 3): unit, of the triangles (t, 3) over ``vertices`` (n, 3)."""
        self.edges = edges
        along = np.diff(vertices[edges.ends], axis=1)[:, 0]
        along /= np.linalg.norm(along, axis=1, keepdims=True)
        creased = _creased(edges, along, normals)
        self.edge_kind = np.where(creased, LINE, FLAT)
        self.edge_axis = np.where(creased[:, None], along, 0.0)
        self.edge_rim = edges.count == 1
        self.edge_normal = _sums(edges.of, normals[:, None, :], len(edges.count))

        count = len(vertices)
        angles = _angles(vertices[triangles])
        self.vertex_normal = _sums(triangles, angles[:, :, None] * normals[:, None, :], count)
        self.vertex_rim = np.zeros(count, bool)
        self.vertex_rim[edges.ends[self.edge_rim]] = True
        # A vertex in the middle of a straight crease is no corner: what leaves it sums to zero.
        ends, along = edges.ends[creased], along[creased]
        creases = np.bincount(ends.ravel(), minlength=count)
        leaving = _sum(ends, np.stack([along, -along], axis=1), count)
        straight = (creases == 2) & (np.linalg.norm(leaving, axis=1) < COPLANAR)
        self.vertex_kind = np.where(straight, LINE, np.where(creases > 0, POINT, FLAT))
        self.vertex_axis = np.zeros((count, 3))
        self.vertex_axis[ends] = along[:, None, :]
        self.vertex_axis[~straight] = 0.0


def _creased(edges, along, normals):
    """Whether each edge is sharp seen from outside: convex, a rim, or where more than two faces meet."""
    pairs = np.flatnonzero(edges.count == 2)
    order = np.argsort(edges.of, axis=None, kind="stable")
    second = order[np.cumsum(edges.count)[pairs] - 1] // 3
    here, there = normals[edges.example[pairs] // 3], normals[second]
    sine = np.einsum("ei,ei->e", cross(here, there), along[pairs])
    angle = np.arctan2(sine, np.einsum("ei,ei->e", here, there))
    creased = np.ones(len(along), bool)
    # An angle of half a turn is that of a blade, whichever its sign.
    creased[pairs] = (angle > COPLANAR) | (angle < COPLANAR - np.pi)
    return creased


def _angles(corners):
    """Angles (t, 3) at the corners (t, 3, 3) of triangles [rad]."""
    onward, back = np.roll(corners, -1, axis=1) - corners, np.roll(corners, 1, axis=1) - corners
    sine = np.linalg.norm(cross(onward, back), axis=2)
    return np.arctan2(sine, np.einsum("tij,tij->ti", onward, back))


def _sum(index, vectors, count):
    """Sums (count, 3) of vectors that broadcast to (\\*index.shape, 3) over equal indices."""
    vectors = np.broadcast_to(vectors, (*index.shape, 3))
    columns = [np.bincount(index.ravel(), vectors[..., i].ravel(), count) for i in range(3)]
    return np.stack(columns, axis=1)


def _sums(index, vectors, count):
    """As ``_sum``, made unit. Where they cancel, as on both sides of a leaf without thickness, zeros."""
    total = _sum(index, vectors, count)
    length = np.linalg.norm(total, axis=1, keepdims=True)
    return np.where(length > 1e-12, total / np.maximum(length, 1e-300), 0.0)
