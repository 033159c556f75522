# SPDX-License-Identifier: LGPL-2.1-or-later
"""A route, and how far its length is off."""

from dataclasses import dataclass

import numpy as np

from ..geometry.curves import Curve


@dataclass(frozen=True, eq=False)
class Route:
    """A comparison curve through the terminals of a scene, SI units, world frame."""

    method: str
    """Spline, Catenary or Chord"""
    arc_length: np.ndarray
    """(m,) of the samples [m]"""
    position: np.ndarray
    """(m, 3) [m]; of a Chord the corners and nothing between them"""
    tangent: np.ndarray
    """(m, 3) unit tangents; at a corner that of the stretch that begins there"""
    smallest_bend_radius: float
    """[m]; infinite if straight, 0 at a corner"""
    smallest_bend_radius_at: float
    """arc length [m]"""

    @classmethod
    def of_curve(cls, method: str, curve: Curve) -> "Route":
        return cls(
            method, curve.arc_length, curve.position, curve.tangent, *curve.smallest_bend_radius()
        )

    @property
    def length(self) -> float:
        return float(self.arc_length[-1])


@dataclass(frozen=True)
class LengthDifference:
    """How much longer a route is than the cable (negative: shorter)."""

    absolute: float
    """[m]"""
    relative: float
    """``absolute`` over ``base``"""
    base: float
    """the length of the cable [m]"""


def compare(route_length: float, cable_length: float) -> LengthDifference:
    """The length of a route against the solved length of the cable [m], the base."""
    absolute = route_length - cable_length
    return LengthDifference(absolute, absolute / cable_length, cable_length)
