# SPDX-License-Identifier: LGPL-2.1-or-later
"""The family of Table 1 over the length, against a solve of each length alone, in SI units."""

import csv
import tempfile
import unittest
from pathlib import Path

import FreeCAD
import numpy as np

from freecad_cable.demo import table_1
from freecad_cable.demo.family import Family
from freecad_cable.document import studying
from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.options import SolveOptions
from freecad_cable.problem import Clamped, Rod, Scene, round_section

TOLERANCE = 1e-4
"""That of the cables of the demo, relative to the length."""
SINGLE = SolveOptions(tolerance=1e-6)


def alone(length):
    """The cable of Table 1, its length [m], solved from nothing but its scene."""
    scene = Scene(
        rod=Rod(length=length, **round_section(0.007, 10e6, 20e6, 1160.0)),
        start=Clamped((0, 0, 0), (0.7071, 0.7071, 0, 0), place="start"),
        end=Clamped((0.16, -0.235, 0.33), (0.5, 0.5, 0.5, 0.5)),
        options=SINGLE,
    )
    return find_equilibrium(scene).raise_for_status()


class FamilyTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.document = FreeCAD.newDocument()
        cls.addClassCleanup(FreeCAD.closeDocument, cls.document.Name)
        cables = [cable for cable, _ in table_1.build(cls.document)]
        cls.document.recompute()
        cls.study = table_1.family(cls.document, cables)
        studying.run(cls.study)
        cls.family = Family.of(cls.study)

    def test_it_goes_from_500_to_900_mm_without_a_jump(self):
        self.assertEqual(self.family.values, [500 + 10 * k for k in range(41)])
        self.assertEqual((self.family.jumps, list(self.study.Notes)), ([], []))
        self.assertEqual(set(self.family.columns["Stable"]), {"yes"})

    def test_it_agrees_with_single_solves(self):
        radii, energies = map(self.family.numbers, ("Smallest bend radius [mm]", "Energy [J]"))
        found = zip(self.study.DrawnValues, self.study.Shape.Wires, radii, energies, strict=True)
        for length, wire, radius, energy in found:
            single = alone(length / 1000)
            (edge,) = wire.Edges
            # The curve's parameter is the length along it.
            places = edge.FirstParameter + 1000 * single.arc_length
            places = np.clip(places, edge.FirstParameter, edge.LastParameter)
            drawn = np.array([edge.valueAt(place) for place in places.tolist()])
            off = np.linalg.norm(drawn - 1000 * single.position, axis=1).max()
            with self.subTest(length=length):
                # One within 1e-4 of the length, the other within 1e-6, the curve within as much.
                self.assertLess(off, (TOLERANCE + 2e-6) * length)
                # At an equilibrium energy changes with the square of an error. An error of 1e-4 L, a wave of half the
                # length, changes the curvature by 1e-4 (4π)²/L, a thousandth of the 18/L and more that it is here.
                self.assertAlmostEqual(energy / single.energy.total, 1, delta=TOLERANCE)
                self.assertAlmostEqual(radius / 1000 / single.min_bend_radius[0], 1, delta=1e-3)

    def test_its_file_has_a_row_for_each_value(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "family.csv"
            self.family.write_csv(path)
            with open(path, newline="", encoding="utf-8") as file:
                rows = list(csv.DictReader(file))
        self.assertEqual([float(row["Length [mm]"]) for row in rows], self.family.values)
        self.assertEqual(
            [float(row["Energy [J]"]) for row in rows], self.family.numbers("Energy [J]")
        )
