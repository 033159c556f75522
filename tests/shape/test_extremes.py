# SPDX-License-Identifier: LGPL-2.1-or-later
import unittest

import numpy as np
from known_curves import RADIUS, arc, changed, coil, picked, rod, sag, scaled, straight
from profiles import rectangle
from test_sweep_round import boolean_check

from freecad_cable.errors import DocumentError
from freecad_cable.shape.centreline import centreline
from freecad_cable.shape.sweep import sweep_profile, sweep_round


class TestExtremes(unittest.TestCase):
    def assert_tube(self, nodes, radius=RADIUS, tolerance=1e-5, length=None):
        solid = sweep_round(nodes, radius)
        self.assertTrue(solid.isValid() and solid.isClosed())
        volume = np.pi * (radius * 1e3) ** 2 * (length or nodes.arc_length[-1]) * 1e3
        self.assertAlmostEqual(solid.Volume / volume, 1, delta=tolerance)
        return solid

    def test_two_and_three_nodes(self):
        # Hermite's remainder for an arc of 1 rad and of 0.5 rad, in the frame; twice in the volume.
        for elements, tolerance in ((1, 2 / 46080 * 2), (2, 1e-5)):
            nodes = rod([arc(0.05, 1.0)], elements)
            self.assertEqual(boolean_check(self.assert_tube(nodes, tolerance=tolerance)), "")
            self.assertTrue(sweep_profile(nodes, rectangle(8, 1)).isValid())

    def test_from_a_millimetre_to_a_kilometre(self):
        for length in (1e-3, 1.0, 1000.0):
            factor = length / 0.73
            nodes = scaled(sag(), factor)
            self.assertEqual(boolean_check(self.assert_tube(nodes, RADIUS * factor)), "")
        # Thin: a thread of 4 mm radius and 1 km length.
        self.assert_tube(scaled(sag(), 1000 / 0.73), RADIUS)

    def test_shorter_than_thick(self):
        self.assert_tube(rod([straight(0.001)], 4), 0.05)
        self.assert_tube(rod([arc(0.1, 0.01)], 4), 0.05)

    def test_beyond_what_has_a_shape(self):
        for factor in (1e-9, 1e9):
            with self.assertRaises(DocumentError):
                sweep_round(scaled(sag(), factor), RADIUS)

    def test_as_light_with_four_hundred_nodes_as_with_fifty(self):
        few, many = (self.assert_tube(sag(count - 1)).Faces[0].Surface for count in (50, 400))
        self.assertLess(many.NbVPoles, 1.5 * few.NbVPoles)

    def test_nodes_that_all_but_coincide(self):
        near = np.sort(np.concatenate([np.arange(0, 1001, 20), np.arange(301, 321)]))
        fine = sag(1000)
        self.assert_tube(picked(fine, near))
        doubled = picked(sag(), np.repeat(np.arange(51), 2))
        self.assert_tube(doubled)

    def test_noise_in_the_positions(self):
        noise = np.random.default_rng(1).normal(size=(400, 3))
        for size in (1e-6, 1e-5):
            nodes = changed(sag(399), position=sag(399).position + size * noise)
            # Of the length: the noise adds (size / spacing)² to it; spacing 1.8 mm.
            self.assert_tube(nodes, tolerance=1e-5 + 10 * (size / 1.8e-3) ** 2)

    def test_a_stretched_rod(self):
        nodes = changed(sag(), position=1.2 * sag().position)
        self.assert_tube(nodes, length=1.2 * 0.73)

    def test_without_curvature(self):
        # Curvature of order 2 from 50 nodes: 3e-4 of 12/m, over pieces of 15 mm.
        self.assert_tube(changed(sag(), curvature=None), tolerance=1e-4)


class TestLoops(unittest.TestCase):
    def ring(self, turns):
        return rod([arc(0.05, 2 * np.pi * turns)], 40)

    def test_ends_that_meet(self):
        ring = self.ring(1)
        ring.position[-1], ring.quaternion[-1] = ring.position[0], -ring.quaternion[0]
        for solid, area in (
            (sweep_round(ring, RADIUS), np.pi * 16),
            (sweep_profile(ring, rectangle(8, 1)), 8),
        ):
            self.assertTrue(solid.isValid() and solid.isClosed())
            self.assertAlmostEqual(solid.Volume / (area * 100 * np.pi), 1, delta=1e-5)

    def test_ends_that_almost_meet(self):
        for turns in (0.9, 0.99, 0.9999):
            self.assertTrue(sweep_round(self.ring(turns), RADIUS).isValid())

    def test_a_cable_through_itself(self):
        with self.assertRaisesRegex(DocumentError, "passes through itself"):
            sweep_round(self.ring(1.1), RADIUS)
        self.assertGreater(centreline(self.ring(1.1)).length(), 345)

    def test_turns_of_a_coil_beside_each_other(self):
        for pitch in (0.0084, 0.02):
            solid = sweep_round(rod([coil(0.05, pitch, 3)], 90), RADIUS)
            self.assertEqual(boolean_check(solid), "")
        # Pressed together by 1 % of their diameter they count as touching, by more they do not.
        self.assertTrue(sweep_round(rod([coil(0.05, 0.00796, 3)], 90), RADIUS).isValid())
        for pitch in (0.0075, 0.004):
            with self.assertRaisesRegex(DocumentError, "points at .* mm apart"):
                sweep_round(rod([coil(0.05, pitch, 3)], 90), RADIUS)

    def test_an_end_that_pokes_into_the_side(self):
        def hook(rest):
            return rod([straight(0.1), arc(0.03, 1.5 * np.pi), straight(rest)], 100)

        # The end looks at the first straight part, whose axis is 30 mm away after the bend.
        self.assertEqual(boolean_check(sweep_round(hook(0.025), RADIUS)), "")
        with self.assertRaisesRegex(DocumentError, "passes through itself"):
            sweep_round(hook(0.027), RADIUS)
