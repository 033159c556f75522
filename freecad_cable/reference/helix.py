# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rods with the same strain everywhere: helix, circle, twisted straight rod, and no weight."""

import math

import numpy as np

from ..geometry import rotation
from ..result import Energy
from .state import RodState, vectors


def helix(
    arc_length, radius, rate, twist, bending_stiffness=1.0, torsional_stiffness=1.0
) -> RodState:
    """A helix about z through (radius, 0, 0), turning by ``rate`` [rad per arc length] and rising.

    ``twist`` is the third component of the material curvature. Needs radius · rate ≤ 1. The force
    is axial, rate (GJ twist − EI rate h) with h the rise per arc length, and the moment EI t × t' +
    GJ twist t (Kirchhoff 1859; Love, section 270).
    """
    s = np.asarray(arc_length, float)
    rise = math.sqrt(max(0.0, 1 - (radius * rate) ** 2))
    turned = rate * s
    cos, sin = np.cos(turned), np.sin(turned)
    tangent = vectors(-radius * rate * sin, radius * rate * cos, rise, count=len(s))
    slope = vectors(-radius * rate**2 * cos, -radius * rate**2 * sin, count=len(s))
    moment = bending_stiffness * np.cross(tangent, slope) + torsional_stiffness * twist * tangent
    curvature = radius * rate**2
    # About z with the helix, d3 from z to the first tangent, and about d3 what twist adds to
    # torsion.
    tilt = math.atan2(radius * rate, rise)
    start = [math.cos(tilt / 2), -math.sin(tilt / 2), 0.0, 0.0]
    quaternion = rotation.multiply(
        rotation.multiply(_about_z(turned), start), _about_z((twist - rise * rate) * s)
    )
    return RodState(
        arc_length=s,
        position=vectors(radius * cos, radius * sin, rise * s, count=len(s)),
        quaternion=quaternion,
        force=vectors(
            z=rate * (torsional_stiffness * twist - bending_stiffness * rise * rate), count=len(s)
        ),
        moment=moment,
        energy=Energy(
            bending_stiffness * curvature**2 * s[-1] / 2,
            torsional_stiffness * twist**2 * s[-1] / 2,
            0.0,
            0.0,
        ),
    )


def roll_up(arc_length, bending_stiffness=1.0) -> RodState:
    """A cantilever rolled up to a full circle by an end couple 2π EI/L."""
    length = arc_length[-1]
    return helix(arc_length, length / (2 * math.pi), 2 * math.pi / length, 0.0, bending_stiffness)


def twisted_rod(arc_length, angle, torsional_stiffness=1.0) -> RodState:
    """Straight along z, its end turned by ``angle``: moment GJ φ/L, energy GJ φ²/2L (Coulomb 1784)."""
    return helix(arc_length, 0.0, 0.0, angle / arc_length[-1], 1.0, torsional_stiffness)


def _about_z(angle):
    return rotation.exponential(vectors(z=angle, count=len(angle)))
