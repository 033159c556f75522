# SPDX-License-Identifier: LGPL-2.1-or-later
"""Smooth curves: between two points with a given length (Hermite, catenary), or a spline.

All lengths are in one unit, whichever the caller uses; all vectors in one frame.
"""

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.interpolate import CubicHermiteSpline, CubicSpline
from scipy.optimize import brentq

from ..errors import ProblemError
from . import guess

STRAIGHT = 1e-12
"""Relative slack below which a curve is its chord: rounding of lengths from coordinates."""


@dataclass(frozen=True, eq=False)
class Curve:
    """A curve as dense samples: arc length (m,), position (m, 3), unit tangent (m, 3)."""

    arc_length: np.ndarray
    position: np.ndarray
    tangent: np.ndarray

    @property
    def length(self) -> float:
        return float(self.arc_length[-1])

    def at(self, arc_length):
        """Position (..., 3) and unit tangent (..., 3) at arc lengths (...), from cubics."""
        tangent = self._cubic(arc_length, 1)
        return self._cubic(arc_length), tangent / np.linalg.norm(tangent, axis=-1, keepdims=True)

    @cached_property
    def _cubic(self):
        return CubicHermiteSpline(self.arc_length, self.position, self.tangent)

    @cached_property
    def curvature(self) -> np.ndarray:
        """(m,) curvature at the samples, from a spline through the tangents."""
        derivative = CubicSpline(self.arc_length, self.tangent)(self.arc_length, 1)
        return np.linalg.norm(derivative, axis=1)

    def smallest_bend_radius(self) -> tuple[float, float]:
        """Smallest bend radius and the arc length of its sample; (inf, 0) if straight."""
        tightest = int(np.argmax(self.curvature))
        if self.curvature[tightest] * self.length < 1e-6:
            return math.inf, 0.0
        return float(1 / self.curvature[tightest]), float(self.arc_length[tightest])


def hermite(start, start_tangent, end, end_tangent, length, bulge=None) -> Curve:
    """A smooth curve of given length from ``start`` to ``end`` (3,) with given unit tangents.

    A tangent None is chosen freely; with both None the curve is an arc of a circle. Otherwise it is
    the cubic Hermite curve whose end derivatives have the one magnitude that gives the length, or,
    where that folds (tangents along the chord, closed or very slack curves), one with shorter
    derivatives and a sideways bump. ``bulge`` (3,) says where the slack goes: weight per length
    over bending stiffness, w/EI [1/length³]; of all these curves the one with the lowest elastic
    and gravity energy is taken. Where the ends leave the side open, its direction alone matters;
    None leaves the side to the function.

    A curve without slack is straight and ignores the tangents. Errors: ``ProblemError`` if the
    length is not positive or shorter than the chord.
    """
    start, end = np.asarray(start, float), np.asarray(end, float)
    if _is_straight(start, end, length):
        return _straight(start, end, length)
    bulge = np.zeros(3) if bulge is None else np.asarray(bulge, float)
    if start_tangent is None and end_tangent is None:
        return _arc(start, end, length, bulge)
    coefficients = guess.lowest_candidate(end - start, start_tangent, end_tangent, length, bulge)
    return _sampled(
        lambda u: start + guess.values(coefficients, u),
        lambda u: guess.slopes(coefficients, u),
        guess.PARAMETER,
    )


def catenary(start, end, length, gravity) -> Curve:
    """The inextensible catenary of the given length hanging from ``start`` and ``end`` (3,).

    ``gravity`` (3,) may have any direction and any magnitude but zero. y = c cosh(x/c), with c from
    √(L² − V²) = 2 c sinh(X/2c) for a horizontal distance X and a rise V (Irvine, Cable Structures,
    1981, 1.2). With no horizontal distance it hangs down and up again; without slack it is
    straight. Errors: ``ProblemError`` if there is no gravity, or the length is not positive or
    shorter than the chord.
    """
    start, end, gravity = (np.asarray(value, float) for value in (start, end, gravity))
    if not gravity.any():
        raise ProblemError("gravity", "is zero; a catenary needs a direction to hang in")
    if _is_straight(start, end, length):
        return _straight(start, end, length)
    chain = Chain(end - start, length, gravity)
    c, first, last = chain.size, chain.first, chain.last
    even = np.linspace(first, last, 301)
    turning = c * np.tan(np.linspace(math.atan(first / c), math.atan(last / c), 301)[1:-1])
    s = np.unique(np.concatenate((even, turning)))
    s = s[np.concatenate(([True], np.diff(s) > 1e-12 * length))]
    s[-1] = last
    x = c * (np.arcsinh(s / c) - math.asinh(first / c))
    y = (s - first) * (s + first) / (np.hypot(c, s) + math.hypot(c, first))
    position = start + x[:, None] * chain.across + y[:, None] * chain.up
    arc_length = (s - first) * (length / (last - first))
    position += (arc_length / length)[:, None] * (end - position[-1])
    return Curve(arc_length, position, chain.tangent(s))


class Chain:
    """Where a catenary hangs: ``size`` c, and arc lengths ``first`` and ``last`` of its ends from its lowest point."""

    def __init__(self, span, length, gravity):
        """``span`` (3,) from its start to its end, shorter than ``length``."""
        self.up = -gravity / np.linalg.norm(gravity)
        rise = float(span @ self.up)
        across = span - rise * self.up
        # A horizontal distance of a millionth of the length stands for none, so that the fold at the
        # bottom keeps a tangent everywhere.
        distance = float(np.linalg.norm(across))
        if distance < 1e-6 * length:
            distance, across = 1e-6 * length, guess.perpendicular(self.up)
        self.across = across / np.linalg.norm(across)
        chord = np.linalg.norm(span)
        excess = (length - chord) * (length + chord)
        half = _sinh_ratio(excess / distance**2)
        self.size = distance / (2 * half)
        middle = math.asinh(rise / math.sqrt(excess + distance**2))
        self.first = self.size * math.sinh(middle - half)
        self.last = self.size * math.sinh(middle + half)

    def tangent(self, s):
        """Unit tangents (..., 3) at arc lengths (...) from the lowest point."""
        slope = np.asarray(s)[..., None] / self.size
        return (self.across + slope * self.up) / np.hypot(1, slope)


def spline(points, start_tangent=None, end_tangent=None) -> Curve:
    """The interpolating cubic spline through ``points`` (n ≥ 2, 3) with unit tangents at its ends.

    As CAD draws it: C², parametrised by chord length, the end derivatives of magnitude one (chord
    length runs like arc length, so one is the natural speed); without a tangent the second
    derivative is zero there. Its length is an outcome (relative error 1e-9). Errors:
    ``ProblemError`` if two points in a row coincide.
    """
    points = np.asarray(points, float)
    chords = np.linalg.norm(np.diff(points, axis=0), axis=1)
    if len(points) < 2 or not (chords > 0).all():
        raise ProblemError(
            "points", "a spline needs two points or more, each apart from the one before"
        )
    knots = np.concatenate(([0.0], np.cumsum(chords)))
    ends = [
        (2, np.zeros(3)) if tangent is None else (1, np.asarray(tangent, float))
        for tangent in (start_tangent, end_tangent)
    ]
    cubic = CubicSpline(knots, points, bc_type=tuple(ends))
    pieces = max(8, math.ceil(200 / len(chords)))
    curve = None
    for _ in range(8):
        parameter = np.interp(
            np.arange(pieces * len(chords) + 1) / pieces, np.arange(len(knots)), knots
        )
        coarse, curve = curve, _sampled(cubic, cubic.derivative(), parameter)
        if coarse is not None and abs(curve.length - coarse.length) < 1e-10 * curve.length:
            break
        pieces *= 2
    return curve


def _is_straight(start, end, length):
    """Whether a curve of this length has no slack; ``ProblemError`` if there is no such curve."""
    chord = float(np.linalg.norm(end - start))
    if not (math.isfinite(length) and length > 0):
        raise ProblemError("length", f"is {length:g}; it must be greater than 0")
    if length < chord * (1 - 1e-9):
        raise ProblemError(
            "length",
            f"is {length:.9g}, but the points are {chord:.9g} apart; make it at least that",
        )
    return length <= chord * (1 + STRAIGHT)


def _straight(start, end, length):
    fraction = np.linspace(0, 1, 101)
    tangent = (end - start) / np.linalg.norm(end - start)
    return Curve(
        fraction * length,
        start + fraction[:, None] * (end - start),
        np.tile(tangent, (len(fraction), 1)),
    )


def _arc(start, end, length, bulge):
    """The arc of a circle of the given length between two points, on the side of ``bulge``."""
    span = end - start
    chord = np.linalg.norm(span)
    if chord > 1e-12 * length:
        along = span / chord
    elif bulge.any():
        along = guess.perpendicular(bulge)
    else:
        along = np.array([1.0, 0, 0])
    side = bulge - (bulge @ along) * along
    if np.linalg.norm(side) > 1e-6 * np.linalg.norm(bulge):
        side = side / np.linalg.norm(side)
    else:
        side = guess.perpendicular(along)
    half = brentq(lambda angle: length * np.sinc(angle / math.pi) - chord, 0, 3.2, xtol=1e-15)
    radius = length / (2 * half)
    angle = np.linspace(-half, half, 401)
    cos, sin = np.cos(angle)[:, None], np.sin(angle)[:, None]
    position = start + radius * ((sin - sin[0]) * along + (cos - cos[0]) * side)
    arc_length = radius * (angle + half)
    position += (arc_length / length)[:, None] * (end - position[-1])
    return Curve(arc_length, position, cos * along - sin * side)


def _sinh_ratio(excess):
    """The x > 0 with (sinh x / x)² − 1 = excess > 0, however small."""

    def difference(log_x):
        square = math.exp(2 * log_x)
        if square < 0.01:
            value = square / 3 * (1 + square * (2 / 15 + square * (1 / 105 + square * 2 / 4725)))
        else:
            value = math.sinh(math.exp(log_x)) ** 2 / square - 1
        return math.log(value) - math.log(excess)

    return math.exp(brentq(difference, -60.0, math.log(60.0), xtol=1e-15, rtol=1e-15))


def _sampled(position, derivative, parameter):
    """The curve at the parameters (m,), its arc length by five Gauss points between them."""
    inside, weights = guess.gauss(parameter)
    speed = np.linalg.norm(derivative(inside), axis=-1)
    arc_length = np.concatenate(([0.0], np.cumsum((speed * weights).sum(axis=1))))
    tangent = derivative(parameter)
    tangent = tangent / np.linalg.norm(tangent, axis=1, keepdims=True)
    return Curve(arc_length, position(parameter), tangent)
