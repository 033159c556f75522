# SPDX-License-Identifier: LGPL-2.1-or-later
import math
import unittest

import FreeCAD
import numpy as np
from FreeCAD import Units

from freecad_cable.geometry import rotation
from freecad_cable.shape import units

ONE = {
    "length": "1 m",
    "curvature": "1 1/m",
    "acceleration": "1 m/s^2",
    "mass_per_length": "1 kg/m",
    "density": "1 kg/m^3",
    "pressure": "1 Pa",
    "force": "1 N",
    "moment": "1 N*m",
    "energy": "1 J",
    "stiffness": "1 N*m^2",
}


class TestUnits(unittest.TestCase):
    def test_every_kind_is_what_freecad_makes_of_one_si_unit(self):
        self.assertEqual(set(units.FREECAD_PER_SI), set(ONE))
        for kind, text in ONE.items():
            with self.subTest(kind):
                quantity = Units.Quantity(text)
                # The two sides round differently; anything but rounding is a wrong factor.
                self.assertAlmostEqual(units.to_si(kind, quantity), 1, delta=1e-15)
                self.assertAlmostEqual(units.from_si(kind, 1.0) / quantity.Value, 1, delta=1e-15)

    def test_arrays_go_both_ways(self):
        array = np.array([[1.0, -2.0, 3.5]])
        np.testing.assert_array_equal(units.from_si("length", array), [[1000, -2000, 3500]])
        np.testing.assert_allclose(units.to_si("force", units.from_si("force", array)), array)

    def test_vectors(self):
        vector = FreeCAD.Vector(1, -2, 3)
        np.testing.assert_allclose(units.vector_to_si(vector), [1e-3, -2e-3, 3e-3])
        self.assertEqual(units.vector_from_si([1, -2, 3]), FreeCAD.Vector(1000, -2000, 3000))
        self.assertEqual(units.vector_from_si([1, 0, 0], "force"), FreeCAD.Vector(1000, 0, 0))
        self.assertEqual(
            units.vectors_from_si([[1, 2, 3], [0, 0, 1]]),
            [FreeCAD.Vector(1000, 2000, 3000), FreeCAD.Vector(0, 0, 1000)],
        )

    def test_a_placement_turns_as_its_quaternion(self):
        placement = FreeCAD.Placement(
            FreeCAD.Vector(10, 20, 30), FreeCAD.Rotation(FreeCAD.Vector(1, 2, 3), 77)
        )
        position, quaternion = units.placement_to_si(placement)
        point = np.array([0.4, -0.5, 0.6])
        there = units.vector_to_si(placement.multVec(units.vector_from_si(point)))
        np.testing.assert_allclose(position + rotation.rotate(quaternion, point), there, atol=1e-15)
        back = units.placement_from_si(position, quaternion)
        np.testing.assert_allclose(back.toMatrix().A, placement.toMatrix().A, atol=1e-12)

    def test_scalar_first(self):
        half = math.sqrt(0.5)
        placement = units.placement_from_si([0, 0, 0], [half, 0, 0, half])
        self.assertLess(
            (placement.Rotation.multVec(FreeCAD.Vector(1, 0, 0)) - FreeCAD.Vector(0, 1, 0)).Length,
            1e-15,
        )


class SentenceTest(unittest.TestCase):
    def check(self, before, after, leave=()):
        self.assertEqual(units.sentence_from_si(before, leave), after)

    def test_lengths_are_in_millimetres(self):
        self.check("is 0.123456 m, but 1.5e-05 m is", "is 123.456 mm, but 0.015 mm is")
        self.check("is 1 m; at (0.25 m) or −0.3 m.", "is 1000 mm; at (250 mm) or -300 mm.")
        self.check("0.120000001 m", "120.000001 mm")

    def test_what_is_no_length_stays(self):
        for sentence in (
            "9.81 m/s²",
            "1e-9 m³",
            "0.2 N m",
            "5 mm",
            "12 m² m",
            "2 metres",
            "v1.2 mm",
        ):
            self.check(sentence, sentence)

    def test_names_stay(self):
        self.check("Tube 2 m: 2 m", "Tube 2 m: 2000 mm", ["Tube 2 m", "Tube", "2"])
        self.check("A 1 m B at 1 m", "A 1 m B at 1000 mm", ["A 1 m", "A 1 m B"])
