# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangle meshes with known surfaces, and distances from them found the long way."""

import numpy as np
import pytest
from numpy.linalg import norm


class Meshes:
    """Builders of (vertices (n, 3), triangles (t, 3)), counter-clockwise seen from outside."""

    @staticmethod
    def grid(corner, u, v, parts):
        """A flat piece from ``corner`` along u and v, of parts × parts × 2 triangles; its front is along u × v."""
        steps = np.linspace(0, 1, parts + 1)
        vertices = np.array([corner + a * u + b * v for a in steps for b in steps])
        first = np.array(
            [i * (parts + 1) + j for i in range(parts) for j in range(parts)], dtype=int
        )
        right, up = parts + 1, 1
        lower = np.stack([first, first + right, first + right + up], axis=1)
        upper = np.stack([first, first + right + up, first + up], axis=1)
        return vertices, np.concatenate([lower, upper])

    @staticmethod
    def joined(*meshes):
        """Meshes as one, with vertices at the same place made one."""
        starts = np.cumsum([0, *(len(vertices) for vertices, _ in meshes)])
        triangles = np.concatenate([t + s for (_, t), s in zip(meshes, starts, strict=False)])
        vertices = np.concatenate([vertices for vertices, _ in meshes])
        vertices, index = np.unique(vertices.round(12), axis=0, return_inverse=True)
        return vertices, index.reshape(-1)[triangles]

    @classmethod
    def box(cls, low, high, parts):
        low, size = np.asarray(low, float), np.subtract(high, low)
        edges = np.diag(size)
        faces = []
        for i in range(3):
            u, v = edges[(i + 1) % 3], edges[(i + 2) % 3]
            faces += [
                cls.grid(low, v, u, parts),
                cls.grid(low + edges[i], u, v, parts),
            ]
        return cls.joined(*faces)

    @classmethod
    def bracket(cls):
        """An L of the unit square less its upper right quarter, along z from 0 to 1."""
        corners = np.array([(0, 0), (1, 0), (1, 0.5), (0.5, 0.5), (0.5, 1), (0, 1)], float)
        bottom, top = np.insert(corners, 2, 0, axis=1), np.insert(corners, 2, 1, axis=1)
        cap = np.array([(0, 1, 2), (0, 2, 3), (0, 3, 5), (3, 4, 5)])
        walls = []
        for i in range(6):
            j = (i + 1) % 6
            walls += [(i, j, 6 + j), (i, 6 + j, 6 + i)]
        return np.concatenate([bottom, top]), np.concatenate([cap[:, ::-1], cap + 6, walls])

    @staticmethod
    def star(random, rings=9, sectors=14, roughness=0.3):
        """A ball with a rough surface: ridges, valleys, saddles."""
        polar = np.linspace(0, np.pi, rings + 2)[1:-1, None]
        round_ = np.linspace(0, 2 * np.pi, sectors, endpoint=False)[None]
        ball = np.stack(
            np.broadcast_arrays(
                np.sin(polar) * np.cos(round_), np.sin(polar) * np.sin(round_), np.cos(polar)
            ),
            axis=-1,
        ).reshape(-1, 3)
        vertices = np.concatenate([ball, [(0, 0, 1), (0, 0, -1)]])
        vertices *= random.uniform(1 - roughness, 1 + roughness, (len(vertices), 1))
        index = np.arange(rings * sectors).reshape(rings, sectors)
        a, b = index[:-1].ravel(), index[1:].ravel()
        c, d = np.roll(index, -1, axis=1)[:-1].ravel(), np.roll(index, -1, axis=1)[1:].ravel()
        north, south = len(ball), len(ball) + 1
        fans = [(north, index[0, j], index[0, (j + 1) % sectors]) for j in range(sectors)]
        fans += [(south, index[-1, (j + 1) % sectors], index[-1, j]) for j in range(sectors)]
        strips = [np.stack([a, b, d], axis=1), np.stack([a, d, c], axis=1)]
        return vertices, np.concatenate([*strips, fans])


def distance_the_long_way(points, vertices, triangles):
    """Unsigned distances (m,), by the closest of all triangles: a face where the foot of the perpendicular, in the
    coordinates of its two sides, lies on it; else one of its three sides."""
    best = np.full(len(points), np.inf)
    for a, b, c in vertices[triangles]:
        sides = np.stack([b - a, c - a], axis=1)
        part = (points - a) @ np.linalg.pinv(sides).T
        on_face = (part >= 0).all(axis=1) & (part.sum(axis=1) <= 1)
        best[on_face] = np.minimum(best, norm(points - a - part @ sides.T, axis=1))[on_face]
        for p, q in ((a, b), (b, c), (c, a)):
            t = np.clip((points - p) @ (q - p) / ((q - p) @ (q - p)), 0, 1)
            best = np.minimum(best, norm(points - p - t[:, None] * (q - p), axis=1))
    return best


def turns_around(points, vertices, triangles):
    """How often a closed surface goes around each point: its solid angle over 4π (van Oosterom, Strackee 1983)."""
    a, b, c = (vertices[triangles[:, i]] - points[:, None] for i in range(3))
    la, lb, lc = norm(a, axis=2), norm(b, axis=2), norm(c, axis=2)
    top = np.sum(a * np.cross(b, c), axis=2)
    dot_ab, dot_bc, dot_ca = np.sum(a * b, axis=2), np.sum(b * c, axis=2), np.sum(c * a, axis=2)
    bottom = la * lb * lc + dot_ab * lc + dot_bc * la + dot_ca * lb
    return np.arctan2(top, bottom).sum(axis=1) / (2 * np.pi)


def feature_distance(found, points):
    """Distance of points from the features in ``found``, as ``Nearest`` states it."""
    away = points - found.center
    along = np.sum(away * found.direction, axis=1)
    about_line = norm(away - along[:, None] * found.direction, axis=1) - found.radius
    to_point = norm(away, axis=1) - found.radius
    return np.choose(found.feature, (along, about_line, to_point))


@pytest.fixture
def meshes():
    return Meshes


@pytest.fixture
def the_long_way():
    return distance_the_long_way


@pytest.fixture
def winding():
    return turns_around


@pytest.fixture
def from_feature():
    return feature_distance


@pytest.fixture
def random():
    return np.random.default_rng(2022)
