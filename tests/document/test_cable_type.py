# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cable types: from values, from a material."""

import math

import FreeCAD
from scenes import DocumentTest

from freecad_cable.document import make
from freecad_cable.document.cable_type import NOT_GIVEN


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
