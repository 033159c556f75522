# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bend radius of a centreline, from the curvature at its nodes."""

import math

import numpy as np

from ..geometry import cubic

FINE = 16
"""Samples per element when looking for the tightest place."""


def smallest_bend_radius(arc_length, curvature, kinked=False):
    """(radius [m], arc length [m]) of the tightest place; (inf, start) for a straight cable.

    arc_length (n+1,), curvature (n+1, 3) in the material frame, of which κ1 and κ2 bend. Between the nodes
    they follow a cubic spline; ``kinked``, where the curvature is bounded, straight lines, for beside a kink a
    spline overshoots.
    """
    bends, samples = curvature[:, :2], 1
    if not kinked:
        bends, samples = cubic.between(arc_length, bends, FINE), FINE
    bend = np.sqrt((bends**2).sum(axis=1))
    k = int(np.argmax(bend))
    # A bend over less than a millionth of a turn in the whole length is rounding, not a bend.
    if bend[k] * (arc_length[-1] - arc_length[0]) < 1e-6:
        return math.inf, float(arc_length[0])
    place = np.interp(k / samples, np.arange(len(arc_length)), arc_length)
    return float(1 / bend[k]), float(place)
