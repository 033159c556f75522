# SPDX-License-Identifier: LGPL-2.1-or-later
import unittest

import numpy as np

from freecad_cable.errors import DocumentError
from freecad_cable.shape import overlap
from freecad_cable.shape.spline import Quintic


def two_straight_spans(start, end):
    """Straight and of unit speed from the first to the second point of both, with a wide loop between."""
    loop = [(40, -15, 0), (60, 1, 0), (40, 17, 0)]
    directions = [(1, 0, 0), (0, 1, 0), (-1, 0, 0)]
    value = np.array([*start, *loop, *end], float)
    legs = [np.subtract(start[1], start[0]) / 20] * 2, [np.subtract(end[1], end[0]) / 20] * 2
    first = np.array([*legs[0], *directions, *legs[1]], float)
    parameter = np.array([0.0, 20, 45, 70, 95, 120, 140])
    return [Quintic(parameter, value, first, np.zeros((7, 3)))]


class TestOverlap(unittest.TestCase):
    def assert_overlaps(self, pieces, radius):
        with self.assertRaisesRegex(DocumentError, "passes through itself"):
            overlap.refuse_overlap(pieces, radius)

    def test_strands_side_by_side(self):
        beside = two_straight_spans([(0, 0, 0), (20, 0, 0)], [(20, 2, 0), (0, 2, 0)])
        # Touching, and pressed together by half a per cent.
        for radius in (0.5, 1.0, 1.005):
            overlap.refuse_overlap(beside, radius)
        self.assert_overlaps(beside, 1.02)

    def test_strands_that_cross(self):
        over = two_straight_spans([(-10, 0, 0), (10, 0, 0)], [(0, 10, 2), (0, -10, 2)])
        overlap.refuse_overlap(over, 1.0)
        self.assert_overlaps(over, 1.02)

    def test_strands_that_cross_in_a_point(self):
        # Nothing is rounded here, so the line between the two points has no direction.
        across = two_straight_spans([(-10, 0, 0), (10, 0, 0)], [(0, 10, 0), (0, -10, 0)])
        self.assert_overlaps(across, 1.0)

    def test_nearest_points_of_two_segments(self):
        random = np.random.default_rng(3)
        p, u, q, v = random.normal(size=(4, 200, 3))
        u[:20] = v[:20] * random.normal(size=(20, 1))
        share_p, share_q = overlap._closest(p, u, q, v)
        found = np.linalg.norm(p + share_p[:, None] * u - q - share_q[:, None] * v, axis=1)
        grid = np.linspace(0, 1, 101)
        first = p[:, None] + grid[:, None] * u[:, None]
        second = q[:, None] + grid[:, None] * v[:, None]
        searched = np.linalg.norm(first[:, :, None] - second[:, None], axis=-1).min(axis=(1, 2))
        for share in (share_p, share_q):
            self.assertTrue(((share >= 0) & (share <= 1)).all())
        # The grid's best is no better, and at most half a step on each segment (both below 4) worse.
        self.assertTrue((found <= searched + 1e-12).all())
        self.assertTrue((searched - found <= 2 * 0.005 * 4).all())
