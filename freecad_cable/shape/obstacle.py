# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids as obstacles: boxes around them and triangles on them, kept for as long as they do not change.

``MeshPart`` and not ``Shape.tessellate``: that cannot be told the angle between triangles and takes one so small
that it makes ten times as many in ten times as long.
"""

import math
from collections import OrderedDict
from dataclasses import dataclass
from functools import cached_property, lru_cache

import MeshPart
import numpy as np
import Part
from FreeCAD import Placement

from ..problem import Mesh
from .units import to_si

ANGLE = 0.5
"""[rad] Largest angle between neighbouring triangles of a round face."""

COARSEST = 1 / 20
"""Largest distance of the triangles from the surface, as a share of the radius of the cable …"""

FINEST = 1 / 2000
"""… and the least, as a share of the size of the solid: a sphere has ten thousand triangles then."""

MOST = 2000
"""Solids that are kept; the one that was not asked for longest goes."""


@dataclass(frozen=True, eq=False)
class _Solid:
    """A solid in its own coordinates [mm], without its placement."""

    shape: object
    corners: np.ndarray
    """(8, 3) of the box around it"""


_kept: OrderedDict[str, _Solid] = OrderedDict()
_last: OrderedDict[str, tuple] = OrderedDict()
"""Of each object that is one solid its shape when it had last changed, and what ``solids`` said of it."""


@dataclass(frozen=True, eq=False)
class Placed:
    """A solid where it stands."""

    solid: _Solid
    matrix: tuple
    """of its placement, row by row"""

    @cached_property
    def bounds(self) -> np.ndarray:
        """Corners (2, 3) [m] of a box around it, along the axes."""
        corners = _moved(self.solid.corners, self.matrix)
        return np.array([corners.min(axis=0), corners.max(axis=0)])

    def mesh(self, radius, place) -> Mesh:
        """It as an obstacle called ``place``, fine enough for a cable of ``radius`` [m]. Errors: ``ProblemError`` if
        its surface does not close."""
        return _mesh(self, _deflection(self.solid, radius), place)


def solids(name, shape) -> list[tuple[Part.Shape, Placed]]:
    """The solids of a shape, each with where it stands. ``name`` is always the same for the same object, wherever it
    stands."""
    known = _last.get(name)
    # One that has neither changed nor moved need not be taken apart again, which is most of reading it.
    if known is not None and known[0].isEqual(shape):
        return known[1]
    each = [(solid, placed(f"{name}.{i}", solid)) for i, solid in enumerate(shape.Solids)]
    # To a compound more can be added, which would be added to what is remembered of it, too.
    if each and shape.ShapeType == "Solid":
        _last[name] = Part.Shape(shape), each
        _used(_last, name)
    return each


def placed(name, shape) -> Placed:
    """The solid ``shape``. ``name`` as for ``solids``."""
    return _placed(_solid(name, shape), tuple(shape.Placement.Matrix.A))


def _solid(name, shape) -> _Solid:
    known = _kept.get(name)
    # Partners share their geometry, and may stand at different places and be inside out.
    if (
        known is None
        or not known.shape.isPartner(shape)
        or known.shape.Orientation != shape.Orientation
    ):
        own = Part.Shape(shape)
        own.Placement = Placement()
        box = own.BoundBox
        corners = np.array([tuple(box.getPoint(i)) for i in range(8)])
        _kept[name] = known = _Solid(own, corners)
    _used(_kept, name)
    return known


def _used(kept, name):
    kept.move_to_end(name)
    if len(kept) > MOST:
        kept.popitem(last=False)


@lru_cache(MOST)
def _deflection(solid, radius):
    """A power of two [mm], so that cables of about the same radius share the triangles."""
    size = float(np.linalg.norm(np.ptp(solid.corners, axis=0)))
    wanted = max(COARSEST * 1e3 * radius, FINEST * size)
    return 2.0 ** math.floor(math.log2(wanted))


@lru_cache(MOST)
def _placed(solid, matrix) -> Placed:
    return Placed(solid, matrix)


@lru_cache(MOST)
def _mesh(it, deflection, place) -> Mesh:
    points, triangles = _triangles(it.solid, deflection)
    return Mesh(_moved(points, it.matrix), triangles, place=place)


@lru_cache(MOST)
def _triangles(solid, deflection):
    """Points (n, 3) [mm] and triangles (m, 3)."""
    # A copy without the triangles of the window: they would be used if they are finer, or be thrown away.
    shape = solid.shape.copy(True, False)
    found = MeshPart.meshFromShape(
        Shape=shape, LinearDeflection=deflection, AngularDeflection=ANGLE
    )
    points, triangles = found.Topology
    return np.array([tuple(point) for point in points]), np.array(triangles, int)


def _moved(points, matrix):
    """Points (n, 3) [mm] in metres after the motion ``matrix`` (16 numbers, row by row) [mm]."""
    matrix = np.reshape(matrix, (4, 4))
    return to_si("length", points @ matrix[:3, :3].T + matrix[:3, 3])
