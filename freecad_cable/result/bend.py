# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bend radius of a centreline, from the curvature at its nodes."""

import math

import numpy as np
from scipy.interpolate import CubicSpline

FINE = 16
"""Samples per element when looking for the tightest place."""


def smallest_bend_radius(arc_length, curvature, kinked=False):
    """(radius [m], arc length [m]) of the tightest place; (inf, start) for a straight cable.

    arc_length (n+1,), curvature (n+1, 3) in the material frame, of which κ1 and κ2 bend. Between the nodes
    they follow a cubic spline; ``kinked``, where the curvature is bounded, straight lines, for beside a kink a
    spline overshoots.
    """
    if kinked:
        bend = np.linalg.norm(curvature[:, :2], axis=1)
        return _radius(bend, arc_length)
    share = np.arange(FINE) / FINE
    s = np.append(
        (arc_length[:-1, None] + np.diff(arc_length)[:, None] * share).ravel(), arc_length[-1]
    )
    bend = np.linalg.norm(CubicSpline(arc_length, curvature[:, :2])(s), axis=1)
    return _radius(bend, s)


def _radius(bend, s):
    k = int(np.argmax(bend))
    # A bend over less than a millionth of a turn in the whole length is rounding, not a bend.
    if bend[k] * (s[-1] - s[0]) < 1e-6:
        return math.inf, float(s[0])
    return float(1 / bend[k]), float(s[k])
