# SPDX-License-Identifier: LGPL-2.1-or-later
"""How points of a cable leave an obstacle that they are inside of: along a direction that their whole run agrees on.
Left to itself each would take the nearest side, and fold the cable around the obstacle."""

import numpy as np

from ..geometry.nearest import HOLE
from ..geometry.runs import runs


def leave(rows, near, points, around_it):
    """Faces for the ``points`` (n, 3) of a cable inside an obstacle, across the direction in which each run of them
    leaves, put in place of their ``rows`` (n, 12). Those that are not ``near`` may be inside."""
    distance, normal = np.full(len(points), np.inf), np.zeros((len(points), 3))
    distance[near.where], normal[near.where] = near.what.distance, near.what.normal
    inside = distance < 0
    inside[near.where[near.what.feature == HOLE]] = False
    for a, b in runs(inside):
        run = slice(a, b)
        depth = -distance[run]
        out = (depth[:, None] * normal[run]).sum(axis=0)
        if np.linalg.norm(out) < 0.1 * depth.sum():
            out = normal[run][np.argmin(depth)]
        out = out / np.linalg.norm(out)
        place = points[run].copy()
        for _ in range(30):
            left = around_it.nearest_of(near.obstacle, place).distance
            if (left >= 0).all():
                break
            place += np.outer(np.maximum(-left, 0) + 1e-4 * (left < 0), out)
        rows[run] = 0.0
        rows[run, :3], rows[run, 3:6], rows[run, 11] = place, out, around_it.keep
