# SPDX-License-Identifier: LGPL-2.1-or-later
"""Polynomial curves of a given length between given tangents: the one with the lowest energy.

A candidate is r(u) = start + span H(u) + m T(u) + A B(u), 0 ≤ u ≤ 1: the cubic Hermite curve with
end derivatives of magnitude m, and a bump B that vanishes with its slope at both ends. Its length
is convex in m and in A, so one m* > 0 with A = 0 gives the length, and so does one A ≥ 0 for every
m ≤ m*: a candidate always exists.
"""

import math

import numpy as np

PARAMETER = (1 - np.cos(np.linspace(0, math.pi, 201))) / 2
"""Where the curve is sampled: dense at the ends, where a taut curve bends."""

FRACTIONS = (0.8, 0.6, 0.45, 1 / 3, 0.2, 0.1)
"""m / m* of the candidates with a bump, from all but none to a bump with tight ends."""

HEAVY = 500.0
"""The w L³/EI above which more weight shall not choose a tighter bend."""

ALIKE = 1e-9
"""Difference of energies, times length over EI, that may be rounding."""

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
    most one tangent may be None. A curve that folds is taken only if all do; of those that cost the
    same, mirror images of each other, the first.
    """
    found = [
        _candidates(span, tangents, length, bulge)
        for tangents in _tangent_choices(span, start_tangent, end_tangent, bulge)
    ]
    base, bumps, amplitude = (np.concatenate(part) for part in zip(*found, strict=True))
    energy = _energy(base + amplitude[:, None, None] * bumps, length, bulge)
    best = np.argmax(energy <= energy.min() + ALIKE / length)
    base, bump = base[best], bumps[best]
    if not bump.any():
        return base
    return base + _exactly(base, bump, length) * bump


def _candidates(span, tangents, length, bulge):
    """Of two tangents, for each candidate: the curve without its bump (k, 6, 3), the bump (k, 6, 3), and about how
    much of that gives the length (k,)."""
    line, hermite = (
        np.outer(_SPAN, span),
        np.outer(_START, tangents[0]) + np.outer(_END, tangents[1]),
    )
    largest = _exactly(line, hermite, length)
    plain, *tight = line + np.multiply.outer(largest * np.append(1.0, FRACTIONS), hermite)
    sides = _sides(span, *tangents, bulge)
    bumps = np.array([np.outer(shape, side) for side in sides for shape in (_EVEN, _ODD)])
    slopes = _along(_COARSE_SLOPES, np.array(tight)), _along(_COARSE_SLOPES, bumps)[:, None]
    amplitude = _root(*slopes, _COARSE_WEIGHTS, length, exact=1e-6)
    return (
        np.concatenate([plain[None], np.tile(tight, (len(bumps), 1, 1))]),
        np.concatenate([np.zeros((1, 6, 3)), np.repeat(bumps, len(tight), axis=0)]),
        np.append(0.0, amplitude),
    )


def _exactly(fixed, varied, length):
    """How much of the polynomial ``varied`` (6, 3) gives ``fixed`` (6, 3) the length."""
    return _root(_FINE_SLOPES @ fixed, _FINE_SLOPES @ varied, _FINE_WEIGHTS, length, exact=1e-14)


def _along(table, coefficients):
    """(k, n, 3) values of the polynomials (k, 6, 3) by a table (n, 6): one product for all."""
    return np.moveaxis(np.tensordot(table, coefficients, (1, 1)), 0, 1)


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


def _root(base, direction, weights, length, exact):
    """The largest x with Σ weights |base + x direction| = length; base and direction (..., n, 3);
    ``exact``: to this share of it.

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
        if (step <= exact * x).all():
            break
    return x


def _energy(coefficients, length, bulge):
    """Energy over EI (k,) of the candidates (k, 6, 3), from the angles between samples."""
    weight = bulge * min(1.0, HEAVY / max(float(np.linalg.norm(bulge)) * length**3, 1e-300))
    slope = _along(_COARSE_SLOPES, coefficients)
    speed = np.sqrt(np.einsum("kni,kni->kn", slope, slope))
    change = np.diff(slope / np.maximum(speed, 1e-300)[..., None], axis=1)
    # Between unit vectors, from the chord: as exact for small angles as for large ones.
    turning = 2 * np.arcsin(np.minimum(np.sqrt(np.einsum("kni,kni->kn", change, change)) / 2, 1.0))
    distance = (speed[:, 1:] + speed[:, :-1]) / 2 * np.diff(_COARSE)
    bending = (turning**2 / np.maximum(distance, 1e-9 * length)).sum(axis=-1) / 2
    height = (coefficients @ weight) @ _COARSE_POWERS.T * speed
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
