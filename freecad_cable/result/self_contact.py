# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a cable runs through itself."""

import numpy as np
from scipy.interpolate import CubicHermiteSpline
from scipy.spatial import cKDTree

from ..geometry import rotation

SPACING = 0.25
"""Of the samples, in radii: two straight parts that cross are then seen within 0.4 % of a radius of their distance."""
TIGHTEST = np.pi
"""Arc length, in radii, between parts that can touch: half a turn of a cable folded upon itself."""
MOST = 20000


def self_penetration(arc_length, position, quaternion, radius):
    """(depth [m], arc length [m], other arc length [m]) of the place where the cable is deepest in itself; None if it
    nowhere is. Nodes (n+1,) [m], (n+1, 3) [m], (n+1, 4)."""
    curve = CubicHermiteSpline(arc_length, position, rotation.tangent(quaternion))
    count = int(min(MOST, np.ceil(arc_length[-1] / (SPACING * radius)))) + 1
    s = np.linspace(0, arc_length[-1], count)
    places = curve(s)
    pairs = cKDTree(places).query_pairs(2 * radius, output_type="ndarray")
    pairs = pairs[np.abs(s[pairs[:, 1]] - s[pairs[:, 0]]) > TIGHTEST * radius]
    if not len(pairs):
        return None
    apart = np.linalg.norm(places[pairs[:, 1]] - places[pairs[:, 0]], axis=1)
    nearest = int(np.argmin(apart))
    a, b = s[pairs[nearest]]
    return float(2 * radius - apart[nearest]), float(min(a, b)), float(max(a, b))
