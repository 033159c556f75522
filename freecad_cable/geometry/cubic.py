# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cubic spline through the few nodes of a rod: SciPy looks at its arguments for longer than it solves for it."""

from functools import lru_cache

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.linalg.lapack import dgtsv


def slopes(x, y):
    """(n+1, k) derivatives at x (n+1,), increasing, of the cubic spline through y (n+1, k), not-a-knot: at the second
    place and the last but one its third derivative does not jump (de Boor, *A Practical Guide to Splines*, ch. IV)."""
    if len(x) < 4:
        return CubicSpline(x, y)(x, 1)
    h = x[1:] - x[:-1]
    two, chords = h[1:] + h[:-1], (y[1:] - y[:-1]) / h[:, None]
    right = np.empty_like(y)
    right[1:-1] = 3 * (h[1:, None] * chords[:-1] + h[:-1, None] * chords[1:])
    right[0] = _at_end(h[0], h[1], *chords[:2])
    right[-1] = _at_end(h[-1], h[-2], *chords[:-3:-1])
    above, below = np.append(two[0], h[:-1]), np.append(h[1:], two[-1])
    diagonal = np.concatenate([h[1:2], 2 * two, h[-2:-1]])
    return dgtsv(below, diagonal, above, right)[3]


def _at_end(h, beside, chord, next_chord):
    """Right side for the slope at an end, from the lengths of the two pieces there and their chords."""
    both = h + beside
    return ((h + 2 * both) * beside * chord + h**2 * next_chord) / both


def between(x, y, count):
    """(n · count + 1, k) values of that spline, ``count`` in each of its pieces from its beginning on, and the last."""
    h, slope = (x[1:] - x[:-1])[:, None], slopes(x, y)
    values = _basis(count) @ np.stack([y[:-1], h * slope[:-1], y[1:], h * slope[1:]], axis=1)
    return np.vstack([values.reshape(-1, y.shape[1]), y[-1:]])


@lru_cache
def _basis(count):
    """(count, 4) Hermite's cubics, of value and slope at the beginning and at the end."""
    u = np.arange(count)[:, None] / count
    left = (1 - u) ** 2
    return np.hstack([(1 + 2 * u) * left, u * left, u**2 * (3 - 2 * u), u**2 * (u - 1)])
