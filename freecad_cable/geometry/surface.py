# SPDX-License-Identifier: LGPL-2.1-or-later
"""Distance to a triangulated surface, and its nearest feature."""

from functools import cached_property

import numpy as np

from .box_tree import ALONE, BoxTree
from .creases import Edges
from .faces import Faces
from .nearest import Nearest
from .rotation import cross


class Surface:
    """Triangles (t, 3), t at least 1, over vertices (n, 3), counter-clockwise seen from outside.

    No triangle may be degenerate, and no two vertices may be at the same place.
    """

    def __init__(self, vertices, triangles):
        self.vertices, self._triangles = vertices, triangles
        self._corners = vertices[triangles]
        normal = cross(
            self._corners[:, 1] - self._corners[:, 0], self._corners[:, 2] - self._corners[:, 1]
        )
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
        (found,) = nearest_of_each([self], [points])
        return found

    def _by_tree(self, points) -> Nearest:
        face = self._tree.nearest(points, lambda some, faces: self.faces.closest(some, faces)[0])
        return self.faces.nearest(points, face, *self.faces.closest(points, face))

    @cached_property
    def faces(self) -> Faces:
        return Faces.over(self.vertices, self._triangles, self._normal, self.edges)

    @cached_property
    def _tree(self):
        return BoxTree(self._corners, self._normal)


def nearest_of_each(surfaces, points) -> list[Nearest]:
    """What is nearest on each of several surfaces to points (m, 3) of its own, as ``Surface.nearest``. Those of few
    faces are asked at once: of one alone most of the time is that of the calls."""
    few = [k for k, each in enumerate(surfaces) if len(each.faces) <= ALONE]
    known = _of_few([surfaces[k].faces for k in few], [points[k] for k in few]) if few else []
    found = dict(zip(few, known, strict=True))
    return [found[k] if k in found else each._by_tree(points[k]) for k, each in enumerate(surfaces)]


def _of_few(several, points):
    """Of surfaces by their faces: by asking each face."""
    faces, counts = Faces.joined(several), [len(each) for each in points]
    most, given = max(map(len, several)), np.concatenate(points)
    begin = np.cumsum([0, *map(len, several)])[:-1]
    tried = [b + np.resize(np.arange(len(e)), most) for b, e in zip(begin, several, strict=True)]
    tried = np.repeat(tried, counts, axis=0)
    every = faces.closest(np.repeat(given, most, axis=0), tried.ravel())
    best = every[0].reshape(tried.shape).argmin(axis=1)
    row = np.arange(len(given))
    closest = (each[row * most + best] for each in every)
    found = faces.nearest(given, tried[row, best], *closest)
    end = np.cumsum(counts)
    return [found.taken(slice(e - n, e)) for n, e in zip(counts, end, strict=True)]
