# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cables without bending stiffness under their own weight, in the x-z plane, z up, from the origin."""

import math

import numpy as np
from scipy.optimize import brentq, root

from ..result import Energy
from .state import RodState, in_plane, vectors


def catenary(arc_length, span, rise, weight, axial_stiffness=math.inf) -> RodState:
    """The cable from the origin to (span, 0, rise), ``weight`` per unstretched length, span > 0.

    Irvine, Cable Structures (1981), section 1.3: with the force (H, 0, V + w s) the position is its
    integral over EA plus that of its direction. Inextensible for infinite EA: then the length must
    exceed the chord.
    """
    s = np.asarray(arc_length, float)
    length = s[-1]
    horizontal, vertical = _thread(length, span, rise, weight)
    if math.isfinite(axial_stiffness):
        horizontal, vertical = _stretched(length, span, rise, weight, axial_stiffness)
    lift = vertical + weight * s
    position, tension = _shape(s, horizontal, vertical, weight, axial_stiffness)
    # ∫ T ds, ∫ T² ds and ∫ z ds in closed form
    areas = (lift * tension + horizontal**2 * np.arcsinh(lift / horizontal)) / (2 * weight)
    area = areas[-1] - areas[0]
    squares = horizontal**2 * length + (lift[-1] ** 3 - lift[0] ** 3) / (3 * weight)
    stretched = (vertical * length**2 / 2 + weight * length**3 / 6) / axial_stiffness
    gravity = weight * stretched + area - tension[0] * length
    return RodState(
        arc_length=s,
        position=position,
        quaternion=in_plane(np.arctan2(lift, horizontal)),
        force=vectors(horizontal, 0.0, lift, count=len(s)),
        moment=np.zeros((len(s), 3)),
        energy=Energy(0.0, 0.0, squares / (2 * axial_stiffness), gravity),
    )


def hanging_rod(arc_length, weight, axial_stiffness) -> RodState:
    """A rod hanging straight down from the origin: it stretches by w L²/2EA."""
    s = np.asarray(arc_length, float)
    length = s[-1]
    stretch = weight / axial_stiffness * (length * s - s**2 / 2)
    return RodState(
        arc_length=s,
        position=vectors(z=-s - stretch, count=len(s)),
        quaternion=in_plane(np.full(len(s), -math.pi / 2)),
        force=vectors(z=-weight * (length - s), count=len(s)),
        moment=np.zeros((len(s), 3)),
        energy=Energy(
            0.0,
            0.0,
            weight**2 * length**3 / (6 * axial_stiffness),
            -weight * length**2 / 2 - weight**2 * length**3 / (3 * axial_stiffness),
        ),
    )


def _shape(s, horizontal, vertical, weight, axial_stiffness):
    """Position (m, 3) and tension (m,) for the force (horizontal, 0, vertical) at the start."""
    lift = vertical + weight * s
    tension = np.hypot(horizontal, lift)
    start = math.hypot(horizontal, vertical)
    turned = np.arcsinh(lift / horizontal) - math.asinh(vertical / horizontal)
    x = horizontal * (s / axial_stiffness + turned / weight)
    z = (vertical * s + weight * s**2 / 2) / axial_stiffness + (tension - start) / weight
    return vectors(x, 0.0, z, count=len(s)), tension


def _thread(length, span, rise, weight):
    """Force at the start of the inextensible cable; of a taut one that is too short, a first guess."""
    excess = max(length**2 - rise**2, span**2 * (1 + 1e-6))
    ratio = math.sqrt(excess) / span
    half = brentq(lambda x: math.sinh(x) / x - ratio, 1e-5, 700.0, xtol=1e-15, rtol=1e-15)
    horizontal = weight * span / (2 * half)
    middle = math.asinh(rise / math.sqrt(excess))
    return horizontal, horizontal * math.sinh(middle - half)


def _stretched(length, span, rise, weight, axial_stiffness):
    """The same of the elastic cable, by Newton's method in (log H, V/w L)."""
    ends = np.array([0.0, length])

    def miss(unknown):
        horizontal, vertical = math.exp(unknown[0]), unknown[1] * weight * length
        reached = _shape(ends, horizontal, vertical, weight, axial_stiffness)[0][-1]
        return (reached - (span, 0.0, rise))[::2] / length

    horizontal, vertical = _thread(length, span, rise, weight)
    guess = [math.log(horizontal), vertical / (weight * length)]
    found = root(miss, guess, tol=1e-14)
    if np.abs(miss(found.x)).max() > 1e-12:
        raise ValueError(f"no elastic catenary of length {length:g} over a span of {span:g} found")
    return math.exp(found.x[0]), found.x[1] * weight * length
