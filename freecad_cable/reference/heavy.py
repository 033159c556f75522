# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cantilever under its own weight: no closed form, but a boundary value problem solved to rounding."""

import math

import numpy as np
from numpy.polynomial import chebyshev
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from ..result import Energy
from .state import RodState, in_plane, vectors

POINTS = 160


def heavy_cantilever(arc_length, weight, bending_stiffness=1.0) -> RodState:
    """Clamped along x at the origin, ``weight`` > 0 per length along −z, the other end free.

    The heavy elastica (Rohde, Quart. Appl. Math. 11 (1953) 337–338; Wang, Int. J. Mech. Sci. 28
    (1986) 549–559): with δ the angle of the rod from −z, σ = (L − s)/L and g = w L³/EI, δ'' = g σ
    sin δ, δ'(0) = 0, δ(1) = π/2. Chebyshev collocation of δ'' at 160 points, started from shooting.
    For g ≤ 10⁴ twice the points move no position by more than 1e-13 L, which is the error stated.
    """
    s = np.asarray(arc_length, float)
    length = s[-1]
    points = chebyshev.chebpts2(POINTS)
    integral = _integration(points)
    sigma = (1 + points) / 2
    delta, slope = _solve(weight * length**3 / bending_stiffness, sigma, integral)
    to_tip = integral[-1] - integral
    x, depth = to_tip @ np.sin(delta), to_tip @ np.cos(delta)
    series = chebyshev.chebfit(points, np.stack((delta, slope, x, depth), axis=1), POINTS - 1)
    delta_s, slope_s, x_s, depth_s = chebyshev.chebval(1 - 2 * s / length, series)
    bending = bending_stiffness / length * (integral[-1] @ slope**2) / 2
    return RodState(
        arc_length=s,
        position=length * vectors(x_s, 0.0, -depth_s, count=len(s)),
        quaternion=in_plane(delta_s - math.pi / 2),
        force=vectors(z=-weight * (length - s), count=len(s)),
        moment=vectors(y=bending_stiffness / length * slope_s, count=len(s)),
        energy=Energy(bending, 0.0, 0.0, -weight * length**2 * (integral[-1] @ depth)),
        error=1e-13 * length,
    )


def _integration(points):
    """The matrix that takes values at the points 2σ − 1 to those of their integral over σ from 0."""
    values = chebyshev.chebvander(points, len(points) - 1)
    integrals = chebyshev.chebval(points, chebyshev.chebint(np.eye(len(points)), lbnd=-1)).T / 2
    return np.linalg.solve(values.T, integrals.T).T


def _solve(load, sigma, integral):
    """δ and dδ/dσ at the points σ, by Newton's method in δ''."""
    twice = (integral - integral[-1]) @ integral
    second = load * sigma * np.sin(_shot(load, sigma))
    for _ in range(20):
        delta = math.pi / 2 + twice @ second
        residual = second - load * sigma * np.sin(delta)
        jacobian = np.eye(len(sigma)) - (load * sigma * np.cos(delta))[:, None] * twice
        step = np.linalg.solve(jacobian, residual)
        second = second - step
        if np.abs(step).max() <= 1e-12 * np.abs(second).max():
            break
    return math.pi / 2 + twice @ second, integral @ second


def _shot(load, sigma):
    """δ at the points σ to some five digits, from its value at the tip."""

    def path(log_tip, **options):
        return solve_ivp(
            lambda t, y: (y[1], load * t * math.sin(y[0])),
            (0, 1),
            (math.exp(log_tip), 0.0),
            rtol=1e-6,
            atol=1e-6 * math.exp(log_tip),
            **options,
        ).y[0]

    # Where δ is small it grows like an Airy function, by less than exp(2/3 √g + 2).
    low = -2 / 3 * math.sqrt(load) - 2
    while path(low + 1)[-1] < math.pi / 2:
        low += 1
    tip = brentq(lambda log_tip: path(log_tip)[-1] - math.pi / 2, low, low + 1, xtol=1e-9)
    return path(tip, t_eval=sigma)
