# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a cable runs through itself."""

import numpy as np
from scipy.interpolate import CubicHermiteSpline
from scipy.spatial import cKDTree

from . import rotation

SPACING = 0.25
"""Of the samples, in radii: two straight parts that cross are then seen within 0.4 % of a radius of their distance."""
TIGHTEST = np.pi
"""Arc length, in radii, between parts that can touch: half a turn of a cable folded upon itself."""
MOST = 20000
APART = 10.0
"""Arc length, in radii, from which two places where it does count as two."""


def self_penetrations(arc_length, position, quaternion, radius, held=()):
    """Places where a cable is in itself, deepest first: (depth [m], arc length [m], other arc length [m]), the first
    the smaller. Nodes (n+1,) [m], (n+1, 3) [m], (n+1, 4).

    ``held``: nodes that are held. Where two of them are nearer than a diameter nothing keeps the cable out of itself
    there, and what is beside them is left out."""
    curve = CubicHermiteSpline(arc_length, position, rotation.tangent(quaternion))
    count = int(min(MOST, np.ceil(arc_length[-1] / (SPACING * radius)))) + 1
    s = np.linspace(0, arc_length[-1], count)
    places = curve(s)
    pairs = cKDTree(places).query_pairs(2 * radius, output_type="ndarray")
    pairs = pairs[np.abs(s[pairs[:, 1]] - s[pairs[:, 0]]) > TIGHTEST * radius]
    if not len(pairs):
        return []
    pairs.sort(axis=1)
    a, b = s[pairs].T
    depth = 2 * radius - np.linalg.norm(places[pairs[:, 1]] - places[pairs[:, 0]], axis=1)
    found = []
    excused = excused_by(arc_length[list(held)], position[list(held)], radius)
    left = ~excused(a, b)
    while left.any():
        worst = np.flatnonzero(left)[np.argmax(depth[left])]
        found.append((float(depth[worst]), float(a[worst]), float(b[worst])))
        left &= np.maximum(np.abs(a - a[worst]), np.abs(b - b[worst])) > APART * radius
    return found


def excused_by(arc_length, position, radius):
    """Function (arc lengths, larger arc lengths) → whether two parts are beside held places (k,), (k, 3) that are
    nearer to each other than a diameter: within twice what is missing there."""
    apart = np.linalg.norm(position[:, None] - position[None], axis=2)
    missing = np.triu(2 * radius - apart, 1)
    cases = [(arc_length[h], arc_length[k], missing[h, k]) for h, k in np.argwhere(missing > 0)]

    def excused(a, b):
        result = np.zeros(np.shape(a), bool)
        for first, second, lacking in cases:
            result |= np.abs(a - first) + np.abs(b - second) <= 2 * lacking
        return result

    return excused
