# SPDX-License-Identifier: LGPL-2.1-or-later
"""Obstacles: solids that the cable must not enter.

An obstacle tells of points (m, 3) [m] its ``nearest`` features: a flat face, a round or sharp edge, a ball or corner.
The distance to a feature is smooth, and for a solid made of features it is the exact distance to the solid
wherever that feature is the nearest.
"""

from dataclasses import dataclass, field
from typing import ClassVar

import numpy as np

FLAT, LINE, POINT = 0, 1, 2


@dataclass(frozen=True, eq=False)
class Nearest:
    """Of m points: the distance to the solid and the feature that is nearest.

    The distance to a feature is n·(x − c) if flat, |(x − c) − (n·(x − c)) n| − ρ about a line, and
    |x − c| − ρ about a point.
    """

    distance: np.ndarray
    """(m,) [m] signed, negative inside"""
    normal: np.ndarray
    """(m, 3) unit, the direction in which the distance grows"""
    feature: np.ndarray
    """(m,) FLAT, LINE or POINT"""
    center: np.ndarray
    """(m, 3) [m] c: a point of the face, of the line, or the point"""
    direction: np.ndarray
    """(m, 3) n: outward normal of the face, unit direction of the line, zeros for a point"""
    radius: np.ndarray
    """(m,) [m] ρ: 0 for sharp edges and corners, and for faces"""


@dataclass(frozen=True, eq=False)
class Obstacle:
    """Common to all obstacles."""

    kind: ClassVar[str]
    place: str = field(default="obstacles", kw_only=True)
    """how error messages name it"""

    def nearest(self, points) -> Nearest:
        """Distance and nearest feature of points (m, 3) [m]."""
        raise NotImplementedError

    @property
    def bounds(self) -> np.ndarray:
        """(2, 3) [m] corners of a box around it, infinite where it is."""
        raise NotImplementedError
