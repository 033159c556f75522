# SPDX-License-Identifier: LGPL-2.1-or-later
import unittest

import FreeCAD
import numpy as np
import Part

from freecad_cable.shape.spline import DEGREE, Quintic, joined

POLYNOMIALS = np.array([[1, -2, 0.5, 3, -1, 0.7], [0, 1, 4, -2, 2, -1], [2, 0, -1, 1, 0.5, 0.3]])
UNEVEN = np.array([0.0, 0.1, 0.5, 0.6, 1.4])


def sampled(polynomials, parameter):
    value, first, second = (
        np.array([np.polyval(np.polyder(p, order), parameter) for p in polynomials]).T
        for order in range(3)
    )
    return Quintic(parameter, value, first, second)


def curve(pieces, continuity):
    knots, multiplicities, poles = joined(pieces, continuity)
    result = Part.BSplineCurve()
    result.buildFromPolesMultsKnots(
        [FreeCAD.Vector(*pole) for pole in poles.tolist()], multiplicities, knots, False, DEGREE
    )
    return result


class TestQuintic(unittest.TestCase):
    def test_a_polynomial_of_degree_five_is_met_between_the_knots(self):
        share = np.array([0.0, 0.3, 0.8, 1.0])
        value, first = sampled(POLYNOMIALS, UNEVEN).at(share)
        place = UNEVEN[:-1, None] + share * np.diff(UNEVEN)[:, None]
        for d, polynomial in enumerate(POLYNOMIALS):
            # Rounding of numbers below 40.
            np.testing.assert_allclose(value[..., d], np.polyval(polynomial, place), atol=1e-13)
            slope = np.polyval(np.polyder(polynomial), place)
            np.testing.assert_allclose(first[..., d], slope, atol=1e-12)

    def test_the_b_spline_is_the_same_function(self):
        random = np.random.default_rng(1)
        quintic = Quintic(UNEVEN, *random.normal(size=(3, len(UNEVEN), 3)))
        spline = curve([quintic], continuity=0)
        share = np.linspace(0, 1, 5)
        value, first = quintic.at(share)
        for k in range(len(UNEVEN) - 1):
            for m, u in enumerate(UNEVEN[k] + share * quintic.step[k]):
                np.testing.assert_allclose(spline.value(u), value[k, m], atol=1e-13)
                np.testing.assert_allclose(spline.tangent(u)[0], unit(first[k, m]), atol=1e-12)
        self.assertEqual(spline.Continuity, "C2")

    def test_thinning_keeps_the_tolerance_and_drops_knots(self):
        parameter = np.linspace(0, 1, 401)
        value = np.stack([np.sin(9 * parameter), np.cos(9 * parameter)], axis=1)
        turned = np.stack([value[:, 1], -value[:, 0]], axis=1)
        fine = Quintic(parameter, value, 9 * turned, -81 * value)
        for tolerance in (1e-4, 1e-8):
            coarse = fine.thinned(tolerance)
            share = (parameter[:, None] - coarse.parameter[:-1]) / coarse.step
            span = np.clip(np.sum(share >= 0, axis=1) - 1, 0, len(coarse.step) - 1)
            rows = np.arange(len(parameter))
            met = np.array([coarse.at([share[k, span[k]]])[0][span[k], 0] for k in rows])
            self.assertLessEqual(np.abs(met - value).max(), tolerance)
            # Hermite's remainder of a span h is (9h)⁶/46080; halving makes at most twice the spans needed.
            needed = 9 / (46080 * tolerance) ** (1 / 6)
            self.assertLessEqual(len(coarse.step), 2 * needed)

    def test_pieces_join_with_a_corner_or_a_common_tangent(self):
        left = sampled(POLYNOMIALS, np.array([0.0, 0.5, 1.0]))
        right = sampled(POLYNOMIALS, np.array([1.0, 1.5]))
        bent = Quintic(right.parameter, right.value, right.first, right.second + 5)
        smooth = curve([left, bent], continuity=1)
        self.assertEqual(smooth.Continuity, "C1")
        for u, quintic, k, share in ((0.7, left, 1, 0.4), (1.2, bent, 0, 0.4)):
            np.testing.assert_allclose(smooth.value(u), quintic.at([share])[0][k, 0], atol=1e-13)
        turned = Quintic(right.parameter, right.value, -right.first, right.second)
        sharp = curve([left, turned], continuity=0)
        self.assertEqual(sharp.Continuity, "C0")
        np.testing.assert_allclose(sharp.value(1.2), turned.at([0.4])[0][0, 0], atol=1e-13)

    def test_cut_into_pieces_that_are_not_much_longer_than_their_shortest_span(self):
        for steps, lengths in (
            ([1, 1, 1, 1, 1], [5]),
            ([10, 1, 1, 10, 10, 10], [10, 2, 30]),
            ([40], [40]),
            ([1, 4, 1, 5], [6, 5]),
        ):
            parameter = np.cumsum([0.0, *steps])
            quintic = sampled(POLYNOMIALS, parameter)
            pieces = quintic.cut(6)
            self.assertEqual(
                [piece.parameter[-1] - piece.parameter[0] for piece in pieces], lengths
            )
            np.testing.assert_array_equal(
                np.concatenate([piece.value[:-1] for piece in pieces]), quintic.value[:-1]
            )


def unit(vector):
    return vector / np.linalg.norm(vector)
