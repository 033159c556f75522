# SPDX-License-Identifier: LGPL-2.1-or-later
"""Polynomial curves of a given length between given tangents: the one with the lowest energy.

A candidate is r(u) = start + span H(u) + m T(u) + A B(u), 0 ≤ u ≤ 1: the cubic Hermite curve with
end derivatives of magnitude m, and a bump B that vanishes with its slope at both ends. Its length
is convex in m and in A, so one m* > 0 with A = 0 gives the length, and so does one A ≥ 0 for every
m ≤ m*: a candidate always exists.
"""

import math

import numpy as np

PARAMETER = (1 - np.cos(np.linspace(0, math.pi, 401))) / 2
"""Where the curve is sampled: dense at the ends, where a taut curve bends."""

FRACTIONS = (0.8, 0.6, 0.45, 1 / 3, 0.2, 0.1)
"""m / m* of the candidates with a bump, from all but none to a bump with tight ends."""

HEAVY = 500.0
"""The w L³/EI above which more weight shall not choose a tighter bend."""

_GAUSS = np.polynomial.legendre.leggauss(5)

_POWERS = np.arange(6)
_SPAN = np.array([0, 0, 3, -2, 0, 0.0])
_START = np.array([0, 1, -2, 1, 0, 0.0])
_END = np.array([0, 0, -1, 1, 0, 0.0])
_EVEN = 16 * np.array([0, 0, 1, -2, 1, 0.0])
_ODD = 25 * math.sqrt(5) * np.array([0, 0, 1, -4, 5, -2.0])
"""Coefficients of u⁰…u⁵: of the span, of the end derivatives, and of two bumps with height one."""


def gauss(parameter):
    """Five Gauss points (m−1, 5) between the parameters (m,) and their weights."""
    half = np.diff(parameter)[:, None] / 2
    return parameter[:-1, None] + half * (1 + _GAUSS[0]), half * _GAUSS[1]


def perpendicular(direction):
    """Any unit vector (3,) perpendicular to ``direction`` (3,), which must not vanish."""
    other = np.cross(direction, np.eye(3)[np.argmin(np.abs(direction))])
    return other / np.linalg.norm(other)


def lowest_candidate(span, start_tangent, end_tangent, length, bulge):
    """The candidate with the lowest energy: coefficients (6, 3) of u⁰…u⁵ of r(u) − start.

    ``span`` (3,) is the end minus the start, shorter than ``length``; ``bulge`` (3,) is w/EI. At
    most one tangent may be None. A curve that folds is taken only if all do.
    """
    base, bumps = [], []
    for tangents in _tangent_choices(span, start_tangent, end_tangent, bulge):
        hermite = np.outer(_START, tangents[0]) + np.outer(_END, tangents[1])
        line = np.outer(_SPAN, span)
        largest = _root(_FINE_SLOPES @ line, _FINE_SLOPES @ hermite, _FINE_WEIGHTS, length)
        base.append(line + largest * hermite)
        bumps.append(np.zeros((6, 3)))
        for side in _sides(span, *tangents, bulge):
            for shape in (_EVEN, _ODD):
                base += [line + fraction * largest * hermite for fraction in FRACTIONS]
                bumps += [np.outer(shape, side)] * len(FRACTIONS)
    base, bumps = np.array(base), np.array(bumps)
    bumped = bumps.any(axis=(1, 2))
    amplitude = np.zeros(len(base))
    amplitude[bumped] = _root(
        _COARSE_SLOPES @ base[bumped], _COARSE_SLOPES @ bumps[bumped], _COARSE_WEIGHTS, length
    )
    best = np.argmin(_energy(base + amplitude[:, None, None] * bumps, length, bulge))
    if not bumped[best]:
        return base[best]
    base, bump = base[best], bumps[best]
    return base + bump * _root(_FINE_SLOPES @ base, _FINE_SLOPES @ bump, _FINE_WEIGHTS, length)


def values(coefficients, u):
    """The polynomial (6, 3) at u (...): (..., 3)."""
    return _powers(np.asarray(u, float)) @ coefficients


def slopes(coefficients, u):
    """Its derivative at u (...): (..., 3)."""
    return _slopes(np.asarray(u, float)) @ coefficients


def _powers(u):
    return np.power.outer(u, _POWERS)


def _slopes(u):
    return np.power.outer(u, np.maximum(_POWERS - 1, 0)) * _POWERS


_COARSE = (1 - np.cos(np.linspace(0, math.pi, 49))) / 2
_COARSE_WEIGHTS = np.convolve(np.diff(_COARSE), [0.5, 0.5])
_COARSE_POWERS, _COARSE_SLOPES = _powers(_COARSE), _slopes(_COARSE)
_FINE_PLACES, _FINE_WEIGHTS = (array.ravel() for array in gauss(PARAMETER))
_FINE_SLOPES = _slopes(_FINE_PLACES)


def _root(base, direction, weights, length):
    """The largest x with Σ weights |base + x direction| = length; base and direction (..., n, 3).

    The sum is convex in x, so Newton's method started on the far side runs down to the root without
    overshooting.
    """
    # |base + x direction|² = before + 2 x mixed + x² along
    before, mixed, along = (
        np.einsum("...i,...i->...", *pair)
        for pair in ((base, base), (base, direction), (direction, direction))
    )
    x = np.asarray((length + np.sqrt(before) @ weights) / (np.sqrt(along) @ weights))
    for _ in range(100):
        change = mixed + x[..., None] * along
        speed = np.sqrt(np.maximum(before + x[..., None] * (mixed + change), 1e-300))
        growth = (change / speed) @ weights
        step = (speed @ weights - length) / np.maximum(growth, 1e-300)
        x = np.maximum(x - np.maximum(step, 0), 0)
        if (step <= 1e-14 * x).all():
            break
    return x


def _energy(coefficients, length, bulge):
    """Energy over EI (k,) of the candidates (k, 6, 3), from the angles between samples."""
    weight = bulge * min(1.0, HEAVY / max(float(np.linalg.norm(bulge)) * length**3, 1e-300))
    slope = _COARSE_SLOPES @ coefficients
    speed = np.linalg.norm(slope, axis=-1)
    before, after = slope[:, :-1], slope[:, 1:]
    turning = np.arctan2(
        np.linalg.norm(np.cross(before, after), axis=-1), (before * after).sum(axis=-1)
    )
    distance = (speed[:, 1:] + speed[:, :-1]) / 2 * np.diff(_COARSE)
    bending = (turning**2 / np.maximum(distance, 1e-9 * length)).sum(axis=-1) / 2
    height = (_COARSE_POWERS @ coefficients @ weight) * speed
    folded = turning.max(axis=-1) > math.pi / 2
    return bending - height @ _COARSE_WEIGHTS + np.where(folded, 1e12 / length, 0)


def _axis(span, tangent):
    chord = np.linalg.norm(span)
    return span / chord if chord > 0 else tangent


def _sides(span, start_tangent, end_tangent, bulge):
    """Unit directions for the bump, the preferred one first."""
    axis = _axis(span, start_tangent)
    for preferred in (bulge, end_tangent - start_tangent, end_tangent + start_tangent):
        side = preferred - (preferred @ axis) * axis
        if np.linalg.norm(side) > 1e-6 * max(np.linalg.norm(preferred), 1e-300):
            side = side / np.linalg.norm(side)
            break
    else:
        side = perpendicular(axis)
    other = np.cross(axis, side)
    sides = [side, -side, other, -other]
    if bulge.any():
        sides.append(bulge / np.linalg.norm(bulge))
    return sides


def _tangent_choices(span, start_tangent, end_tangent, bulge):
    """The pairs of tangents to try: the given ones, or several for the free one."""
    if start_tangent is not None and end_tangent is not None:
        return [(np.asarray(start_tangent, float), np.asarray(end_tangent, float))]
    given = np.asarray(end_tangent if start_tangent is None else start_tangent, float)
    axis = _axis(span, given)
    as_an_arc = 2 * (given @ axis) * axis - given
    side = _sides(span, given, as_an_arc, bulge)[0]
    choices = [as_an_arc, given, axis, -axis, side, -side]
    if start_tangent is None:
        return [(choice, given) for choice in choices]
    return [(given, choice) for choice in choices]
