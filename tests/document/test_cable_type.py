# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cable types: built in, from values, from a material and its card."""

import math
import shutil
import tempfile
from pathlib import Path

import FreeCAD
from scenes import DocumentTest

from freecad_cable.document import make
from freecad_cable.document.cable_type import NOT_GIVEN
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

    def test_what_is_not_given_is_a_placeholder_until_it_is_set(self):
        kind = make.cable_type(self.doc, "Mine", outer_diameter="5 mm", mass_per_length="30 g/m")
        self.compute()
        self.assertIn("BendingStiffness, TorsionalStiffness: only a placeholder", kind.Status)
        kind.BendingStiffness = "2e-3 N*m^2"
        kind.TorsionalStiffness = "2e-3 N*m^2"
        self.compute()
        self.assertNotIn("Warning", kind.Status)
        given = {f"{name}: user, set in the document" for name in NOT_GIVEN}
        self.assertEqual(set(kind.Provenance), given)

    def test_a_number_that_is_changed_is_no_longer_from_where_it_was(self):
        kind = make.cable_type(self.doc, "Coax H123, 75 ohm")
        self.compute()
        (before,) = (s for s in kind.Provenance if s.startswith("MassPerLength: "))
        self.assertIn("datasheet, Belden", before)
        kind.MassPerLength = "31 g/m"
        self.assertNotIn(before, kind.Provenance)
        self.assertIn("MassPerLength: user, set in the document", kind.Provenance)
        self.assertTrue(any("datasheet, Belden" in said for said in kind.Provenance))

    def test_a_change_of_provenance_is_undone_with_the_number(self):
        self.doc.UndoMode = 1
        kind = make.cable_type(self.doc, "Coax H123, 75 ohm")
        before = kind.Provenance
        self.doc.openTransaction("mass")
        kind.MassPerLength = "31 g/m"
        self.doc.commitTransaction()
        self.doc.undo()
        self.assertEqual(kind.Provenance, before)
        self.doc.redo()
        self.assertIn("MassPerLength: user, set in the document", kind.Provenance)

    def test_provenance_by_keyword(self):
        for told, counts in (
            ("Example values", True),
            (["MassPerLength: measured, own scale"], True),
            (["BendingStiffness: placeholder, guessed"], False),
        ):
            kind = make.cable_type(
                self.doc,
                "Mine",
                outer_diameter="5 mm",
                mass_per_length="30 g/m",
                bending_stiffness="2e-3 N*m^2",
                torsional_stiffness="2e-3 N*m^2",
                provenance=told,
            )
            self.compute()
            self.assertIn(told if isinstance(told, str) else told[0], kind.Provenance)
            self.assertEqual("placeholder" in kind.Status, not counts)

    def test_the_limit_of_a_cable_that_moves(self):
        kind = make.cable_type(self.doc, "Mine", min_bend_radius="20 mm")
        limit = lambda: 1e3 * kind.Proxy.rod(kind, 1.0).min_bend_radius  # noqa: E731
        self.assertAlmostEqual(limit(), 23.5, delta=1e-9)
        kind.Moving = True
        self.compute()
        self.assertAlmostEqual(limit(), 23.5, delta=1e-9)
        self.assertIn("has no MinBendRadiusMoving", kind.Status)
        kind.MinBendRadiusMoving = "40 mm"
        self.compute()
        self.assertAlmostEqual(limit(), 43.5, delta=1e-9)
        self.assertNotIn("MinBendRadiusMoving", kind.Status)

    def test_a_stiffness_outside_of_its_bounds_is_named(self):
        kind = make.cable_type(self.doc, "Hook-up wire AWG 22, ETFE")
        self.compute()
        self.assertNotIn("Warning", kind.Status)
        kind.BendingStiffness = "1e-4 N*m^2"
        self.compute()
        self.assertIn("outside of SlipBendingStiffness", kind.Status)
        kind.SlipBendingStiffness = "0 N*m^2"
        kind.BendingStiffness = "1e-2 N*m^2"
        self.compute()
        self.assertIn("outside of SlipBendingStiffness", kind.Status)

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
            self.assertIn("YoungsModulus: user, material card Rubber", kind.Provenance)
            self.assertIn("BendingStiffness: derived, from the material", kind.Provenance)
            self.assertNotIn("placeholder", kind.Status)
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
