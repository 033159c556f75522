# SPDX-License-Identifier: LGPL-2.1-or-later
"""Loads at which a straight rod loses its stability."""

import math

import numpy as np
from scipy.optimize import brentq
from scipy.special import jv


def self_weight(length=1.0, bending_stiffness=1.0) -> float:
    """Weight per length at which an upright clamped column buckles: w L³/EI = (9/4) j², j the first
    zero of J₋₁/₃.

    Greenhill, Proc. Cambridge Phil. Soc. 4 (1881) 65–73.
    """
    zero = brentq(lambda x: jv(-1 / 3, x), 1.5, 2.5, xtol=1e-15, rtol=1e-15)
    return 9 / 4 * zero**2 * bending_stiffness / length**3


def twist(tension=0.0, length=1.0, bending_stiffness=1.0) -> float:
    """Torque at which a straight rod buckles whose ends are clamped, one free to move along the
    axis.

    Greenhill, Proc. Inst. Mech. Eng. (1883) 182–209; Love, section 272. With s from the middle, the
    deflection as a complex number is c0 + i c1 s + c2 exp(i a1 s) + c3 exp(i a2 s), a1 and a2 the
    roots of EI a² − M a + T = 0; the real constants must make it and its slope vanish at the end.
    ``tension`` ≥ 0.
    """
    pull = tension * length**2 / bending_stiffness

    def shortfall(a):
        """(cos(a/2) − sin(a/2)/(a/2)) / a"""
        if abs(a) < 1e-2:
            return a * (-1 / 12 + a**2 * (1 / 480 - a**2 / 53760))
        return (math.cos(a / 2) - 2 * math.sin(a / 2) / a) / a

    def determinant(torque):
        root = math.sqrt(max(0.0, torque**2 - 4 * pull))
        a = (torque + root) / 2
        b = pull / a
        return a * shortfall(a) * np.sinc(b / (2 * math.pi)) / 2 - math.sin(a / 2) * shortfall(b)

    # Between 2 √T, where both roots coincide, and the torque with a1 = a2 + 3π one zero is crossed.
    lowest = 2 * math.sqrt(pull)
    highest = math.sqrt(lowest**2 + (3 * math.pi) ** 2)
    torque = brentq(determinant, lowest * (1 + 1e-6) + 1e-3, highest, xtol=1e-14, rtol=1e-15)
    return torque * bending_stiffness / length
