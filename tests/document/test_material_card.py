# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cable types from material cards, and the library as such cards."""

import importlib
import math
import runpy
import shutil
import tempfile
from pathlib import Path

import FreeCAD
from scenes import DocumentTest

from freecad_cable.document import make
from freecad_cable.document.catalogue import BUILT_IN, NUMBERS, catalogue
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


class CableCardTest(DocumentTest):
    """The library as material cards."""

    CARDS = BUILT_IN.parent / "material_cards"

    def test_the_cards_are_those_of_the_table(self):
        made = runpy.run_path(str(BUILT_IN.with_name("make_material_cards.py")))
        written = {p.name: p.read_text(encoding="utf-8") for p in self.CARDS.glob("*.FCMat")}
        self.assertEqual(dict(made["cards"]()), written)
        self.assertEqual(len(written), len(catalogue()))
        model = BUILT_IN.with_name("material_models") / "Cable.yml"
        self.assertIn(made["MODEL"], model.read_text(encoding="utf-8"))
        for _, (prop, _, _) in NUMBERS.items():
            self.assertIn(f"\n  {prop}:\n", model.read_text(encoding="utf-8"))

    def assertSameType(self, kind, card):
        for name, (prop, _, unit) in NUMBERS.items():
            one, other = (getattr(each, prop).getValueAs(unit).Value for each in (kind, card))
            self.assertAlmostEqual(one, other, delta=1e-12 * one, msg=name)
        self.assertEqual(sorted(kind.Provenance), sorted(card.Provenance))
        self.assertEqual(kind.BendRadiusConvention, card.BendRadiusConvention)
        self.assertEqual(card.Source, "Values")

    def test_a_card_says_what_the_table_says(self):
        for name in catalogue():
            path = next(
                p for p in self.CARDS.glob("*") if f'Name: "{name}"' in p.read_text("utf-8")
            )
            kind = make.cable_type(self.doc, name)
            self.assertSameType(kind, make.cable_type(self.doc, "From the card", card=path))

    def test_a_card_that_was_edited_says_so(self):
        text = (self.CARDS / "Coax H123, 75 ohm.FCMat").read_text(encoding="utf-8")
        folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        path = folder / "mine.FCMat"
        path.write_text(text.split("    Provenance")[0].replace("29 g/m", "0.031 kg/m"), "utf-8")
        kind = make.cable_type(self.doc, "Mine", card=path)
        self.assertAlmostEqual(kind.MassPerLength.getValueAs("g/m").Value, 31, delta=1e-9)
        self.assertIn("MassPerLength: user, material card Coax H123, 75 ohm", kind.Provenance)
        path.write_text(text.replace("29 g/m", "heavy"), "utf-8")
        with self.assertRaisesRegex(DocumentError, "MassPerLength: 'heavy' is no number in g/m"):
            make.cable_type(self.doc, "Mine", card=path)
        path.write_text(text.replace('"Inside"', '"Outside"'), "utf-8")
        with self.assertRaisesRegex(DocumentError, "must be Inside or Centreline"):
            make.cable_type(self.doc, "Mine", card=path)

    def test_they_are_in_freecads_own_library(self):
        if int(FreeCAD.Version()[0]) < 1:
            with self.assertRaises(ImportError):
                importlib.import_module("Materials")  # which there is from 1.0 on
            return
        manager = importlib.import_module("Materials").MaterialManager()
        made = runpy.run_path(str(BUILT_IN.with_name("make_material_cards.py")))
        found = manager.materialsWithModel(made["MODEL"])
        self.assertEqual(len(found), len(catalogue()))
        for name in catalogue():
            (material,) = (m for m in found.values() if m.Name == name.translate(made["IN_A_FILE"]))
            kind = make.cable_type(self.doc, name)
            self.assertSameType(kind, make.cable_type(self.doc, "Native", card=material))
            diameter = material.getPhysicalValue("OuterDiameter").getValueAs("mm").Value
            self.assertAlmostEqual(diameter, kind.OuterDiameter.Value, delta=1e-9)
