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
FEW = 256
"""Nodes up to which comparing all elements with each other takes less than the samples do."""
APART = 10.0
"""Arc length, in radii, from which two places where it does count as two."""


def self_penetrations(arc_length, position, quaternion, radius, held=()):
    """Places where a cable is in itself, deepest first: (depth [m], arc length [m], other arc length [m]), the first
    the smaller. Nodes (n+1,) [m], (n+1, 3) [m], (n+1, 4).

    ``held``: nodes that are held. Where two of them are nearer than a diameter nothing keeps the cable out of itself
    there, and what is beside them is left out."""
    tangents = rotation.tangent(quaternion)
    if len(position) <= FEW and not _comes_back(arc_length, position, tangents, radius):
        return []
    curve = CubicHermiteSpline(arc_length, position, tangents)
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


def _comes_back(arc_length, position, tangents, radius) -> bool:
    """Whether the cubics through the nodes may come within a diameter of each other, ``TIGHTEST`` apart or more; False
    is exact.

    Derivatives lie between three vectors of each element (those of its Bézier form). Where these turn from one to the
    next by 2 θ in all, none is more than θ from the direction in their middle, along which the curve then advances by
    its slowest speed times cos θ."""
    steps = np.diff(arc_length)
    chords = np.diff(position, axis=0) / steps[:, None]
    legs = np.empty((2 * len(steps) + 1, 3))
    legs[::2] = tangents
    legs[1::2] = 3 * chords - tangents[1:] - tangents[:-1]
    speed = np.maximum(np.linalg.norm(legs, axis=1), 1e-300)
    legs /= speed[:, None]
    cosines = np.einsum("ki,ki->k", legs[1:], legs[:-1])
    turns = np.arccos(np.minimum(np.maximum(cosines, -1.0), 1.0))
    turned = np.append(0.0, np.cumsum(turns))[::2]
    straight = 2 * np.arccos(min(1.0, 2 / (TIGHTEST * speed.min())))
    a, b = np.nonzero(turned[1:] - turned[:-1, None] > straight)
    # Balls about the elements.
    middles = (position[1:] + position[:-1] - steps[:, None] / 4 * np.diff(tangents, axis=0)) / 2
    reach = speed.max() * steps / 2 + radius
    return bool((np.linalg.norm(middles[a] - middles[b], axis=1) <= reach[a] + reach[b]).any())


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
