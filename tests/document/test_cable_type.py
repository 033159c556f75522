# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cable types: built in, from values, from a material and its card."""

import math
import shutil
import tempfile
from pathlib import Path

import FreeCAD
from scenes import DocumentTest

from freecad_cable.document import make
from freecad_cable.document.catalogue import catalogue
from freecad_cable.document.material_card import read_card
from freecad_cable.errors import DocumentError

OLD_CARD = """; a comment: Density = 1
[General]
Name = Rubber
[Mechanical]
Density = 1.2 g/cm^3
PoissonRatio = 0.45
YoungsModulus = 5.8 MPa
"""

NEW_CARD = """---
# File created by FreeCAD
General:
  UUID: "c6c64159-19c1-40b5-859c-10561f20f979"
  Name: "Rubber"
Models:
  LinearElastic:
    UUID: '7b561d1d-fb9b-44f6-9da9-56a4f74d7536'
    Density: "1200 kg/m^3"
    PoissonRatio: "0.45"
    YoungsModulus: "5.8 MPa"
"""


class CableTypeTest(DocumentTest):
    def value(self, kind, name, unit):
        return getattr(kind, name).getValueAs(unit).Value

    def test_every_built_in_one_has_a_source_and_no_doubts(self):
        self.assertGreaterEqual(len(catalogue()), 4)
        for name in catalogue():
            kind = make.cable_type(self.doc, name)
            self.compute()
            self.assertEqual(kind.Label, name)
            self.assertRegex(kind.Provenance, r"20\d\d|arXiv \d{4}")
            self.assertNotIn("Warning", kind.Status)

    def test_the_seed_papers_cable_is_a_homogeneous_rod(self):
        kind = make.cable_type(self.doc, "Multi-core cable 7 mm")
        r = 0.0035
        for name, unit, expected in (
            ("MassPerLength", "kg/m", 1160 * math.pi * r**2),
            ("BendingStiffness", "N*m^2", 10e6 * math.pi * r**4 / 4),
            ("TorsionalStiffness", "N*m^2", 20e6 * math.pi * r**4 / 2),
        ):
            self.assertAlmostEqual(self.value(kind, name, unit) / expected, 1, delta=1e-14)

    def test_values_by_keyword(self):
        kind = make.cable_type(
            self.doc,
            "Mine",
            outer_diameter="5 mm",
            mass_per_length="30 g/m",
            bending_stiffness="2e-3 N*m^2",
            torsional_stiffness=FreeCAD.Units.Quantity("1500 N*mm^2"),
            min_bend_radius=40,
            natural_curvature=(1, 0, 0),
            provenance="Measured",
        )
        self.compute()
        self.assertEqual(kind.Source, "Values")
        self.assertAlmostEqual(self.value(kind, "TorsionalStiffness", "N*m^2"), 1.5e-3, delta=1e-15)
        self.assertEqual(kind.MinBendRadius.Value, 40)
        self.assertEqual(kind.Status, "Diameter 5 mm, 30 g/m, EI 0.002 N m², GJ 0.0015 N m².")

    def test_a_material(self):
        kind = make.cable_type(
            self.doc,
            "Rod",
            outer_diameter="8 mm",
            youngs_modulus="100 MPa",
            shear_modulus="40 MPa",
            density="1500 kg/m^3",
        )
        kind.SecondBendingStiffness = "1 N*m^2"
        self.compute()
        self.assertEqual(kind.Source, "Material")
        d = 0.008
        for name, unit, expected in (
            ("MassPerLength", "kg/m", 1500 * math.pi * d**2 / 4),
            ("BendingStiffness", "N*m^2", 100e6 * math.pi * d**4 / 64),
            ("TorsionalStiffness", "N*m^2", 40e6 * math.pi * d**4 / 32),
        ):
            self.assertAlmostEqual(self.value(kind, name, unit) / expected, 1, delta=1e-14)
        self.assertEqual(kind.SecondBendingStiffness.Value, 0)

    def test_two_stiffnesses(self):
        kind = make.cable_type(self.doc, "Flat", second_bending_stiffness="0.1 N*m^2")
        self.assertEqual(kind.Proxy.rod(kind, 1.0).bending_stiffness.tolist(), [1.18e-3, 0.1])


class CardTest(DocumentTest):
    def setUp(self):
        super().setUp()
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def card(self, text):
        path = self.folder / "card.FCMat"
        path.write_text(text, encoding="utf-8")
        return str(path)

    def test_cards_of_old_and_new_freecad(self):
        for text in (OLD_CARD, NEW_CARD):
            kind = make.cable_type(self.doc, "Hose", card=self.card(text), outer_diameter="10 mm")
            self.compute()
            self.assertEqual(kind.Source, "Material")
            self.assertEqual(kind.Provenance, "Material card Rubber")
            for name, unit, expected in (
                ("YoungsModulus", "Pa", 5.8e6),
                ("ShearModulus", "Pa", 2e6),
                ("Density", "kg/m^3", 1200),
            ):
                value = getattr(kind, name).getValueAs(unit).Value
                self.assertAlmostEqual(value / expected, 1, delta=1e-14)
            self.assertAlmostEqual(
                kind.BendingStiffness.getValueAs("N*m^2").Value / (5.8e6 * math.pi * 0.01**4 / 64),
                1,
                delta=1e-14,
            )

    def test_a_shear_modulus_of_its_own_counts(self):
        card = read_card(self.card(OLD_CARD + "ShearModulus = 1.5 MPa\n"))
        self.assertEqual(card["ShearModulus"], "1500000.0 Pa")

    def test_a_card_that_freecad_ships(self):
        folders = [Path(FreeCAD.getHomePath()), Path(FreeCAD.getResourceDir())]
        cards = [p for f in folders for p in (f / "Mod" / "Material").rglob("PVC*.FCMat")]
        self.assertTrue(cards, "FreeCAD has no PVC card")
        self.assertEqual(read_card(cards[0])["YoungsModulus"], "2800000000.0 Pa")

    def test_what_a_card_lacks_is_named(self):
        for text, words in (
            (OLD_CARD.replace("Density = 1.2", "Weight = 1.2"), "has no Density"),
            (OLD_CARD.replace("PoissonRatio", "Poisson"), "has no PoissonRatio"),
            (OLD_CARD.replace("5.8 MPa", "soft"), "YoungsModulus: 'soft' is no number"),
            (OLD_CARD.replace("5.8 MPa", "5.8 mm"), "YoungsModulus: '5.8 mm' is no number"),
        ):
            with self.assertRaisesRegex(DocumentError, words):
                read_card(self.card(text))
        with self.assertRaisesRegex(DocumentError, "cannot be read"):
            read_card(self.folder / "none.FCMat")
