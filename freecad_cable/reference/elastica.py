# SPDX-License-Identifier: LGPL-2.1-or-later
"""The planar elastica without weight: Euler 1744; in Jacobi's functions as in Love, Mathematical
Theory of Elasticity, 4th ed., sections 262 and 263.

With ψ the angle of the tangent from the axis opposite to the force P on the end of the rod, EI ψ''
= −P sin ψ: sin(ψ/2) = k sn(u), ψ' = 2 k λ cn(u), u = λ s + u0, λ² = P/EI, m = k². All curves lie in
the x-z plane, start at the origin, and are unstretchable.
"""

import math

import numpy as np
from scipy.optimize import brentq
from scipy.special import ellipe, ellipj, ellipk, ellipkinc, elliprd, elliprf

from ..result import Energy
from .state import RodState, in_plane, vectors


def clamped_elastica(arc_length, chord, bending_stiffness=1.0) -> RodState:
    """Both ends clamped along x, the end at (chord, 0, 0), one hump towards +z.

    ``arc_length`` (m,) ends with the length L; −0.5 L < chord < L. The rod is one period, λ L = 4
    K: chord/L = 2 E/K − 1, P = 16 K² EI/L², rise k L/K at the middle.
    """
    m = _modulus(lambda m: 2 * ellipe(m) / ellipk(m) - 1 - chord / arc_length[-1])
    return _elastica(arc_length, 4 * ellipk(m) / arc_length[-1], 0.0, m, 0.0, bending_stiffness)


def pinned_elastica(arc_length, end_slope, bending_stiffness=1.0) -> RodState:
    """Both ends pinned, on the x axis, leaving at the angle ``end_slope`` (0, π) towards +z.

    Half a period, λ L = 2 K with k = sin(end_slope/2): P = 4 K² EI/L², chord/L = 2 E/K − 1.
    """
    m = math.sin(end_slope / 2) ** 2
    quarter = ellipk(m)
    return _elastica(arc_length, 2 * quarter / arc_length[-1], quarter, m, 0.0, bending_stiffness)


def cantilever(arc_length, tip_load, bending_stiffness=1.0) -> RodState:
    """Clamped along x at the origin, a dead load −``tip_load`` z (> 0) on the free end.

    Bisshopp and Drucker, Quart. Appl. Math. 3 (1945) 272–275: a quarter period less what the clamp
    cuts off, λ L = K − F(arcsin(1/(k √2))).
    """
    length = arc_length[-1]
    rate = math.sqrt(tip_load / bending_stiffness)

    def cut_off(m):
        return ellipkinc(math.asin(min(1.0, math.sqrt(0.5 / m))), m)

    m = _modulus(lambda m: ellipk(m) - cut_off(m) - rate * length, 0.5)
    first = 2 * ellipk(m) + cut_off(m)
    return _elastica(arc_length, rate, first, m, math.pi / 2, bending_stiffness)


def _modulus(function, lowest=0.0):
    """The root m in (lowest, 1) of ``function``; m is 1 − e^−t, so that long rods keep their digits."""
    t = brentq(
        lambda t: function(-math.expm1(-t)), -math.log1p(-lowest), 36.0, xtol=1e-15, rtol=1e-15
    )
    return -math.expm1(-t)


def _elastica(arc_length, rate, first, m, turn, stiffness):
    """The elastica with u = rate s + first, its axis turned by ``turn`` from x towards z."""
    s = np.asarray(arc_length, float)
    k = math.sqrt(m)
    u = rate * s + first
    sn, cn, _, _ = ellipj(u, m)
    # ellipj's own amplitude jumps where cn is zero. The true one keeps within a quarter turn of π
    # u/2K.
    amplitude = np.arctan2(sn, cn)
    mean = math.pi / 2 * u / ellipk(m)
    amplitude += 2 * math.pi * np.round((mean - amplitude) / (2 * math.pi))
    angle = turn + 2 * np.arcsin(k * sn)
    # ∫ cos ψ ds and ∫ sin ψ ds
    area = _second_kind(amplitude, m)
    ahead = 2 * (area - area[0]) / rate - s
    aside = 2 * k * (cn[0] - cn) / rate
    cos, sin = math.cos(turn), math.sin(turn)
    load = stiffness * rate**2
    bending = 2 * stiffness * rate * (area[-1] - area[0] - (1 - m) * rate * s[-1])
    return RodState(
        arc_length=s,
        position=vectors(cos * ahead - sin * aside, 0.0, sin * ahead + cos * aside, count=len(s)),
        quaternion=in_plane(angle),
        force=vectors(-load * cos, 0.0, -load * sin, count=len(s)),
        moment=vectors(y=-2 * stiffness * k * rate * cn, count=len(s)),
        energy=Energy(bending, 0.0, 0.0, 0.0),
    )


def _second_kind(amplitude, m):
    """E(φ, m) by Carlson's forms (DLMF 19.25.10)."""
    turns = np.round(amplitude / math.pi)
    phi = amplitude - turns * math.pi
    sine, cosine = np.sin(phi), np.cos(phi)
    arguments = cosine**2, 1 - m * sine**2, 1.0
    part = sine * elliprf(*arguments) - m / 3 * sine**3 * elliprd(*arguments)
    return part + 2 * turns * ellipe(m)
