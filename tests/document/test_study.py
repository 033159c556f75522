# SPDX-License-Identifier: LGPL-2.1-or-later
"""Studies in a document: what they find, and that they leave everything as it was."""

import xml.etree.ElementTree as ET
from pathlib import Path

from studies import StudyTest

from freecad_cable.document import make, studying
from freecad_cable.errors import DocumentError


class TestValues(StudyTest):
    def test_a_family_over_the_length(self):
        study = self.study(varied="Length", start="250 mm", stop="400 mm", count=4)
        self.run_unchanged(study)
        self.assertEqual(list(study.DrawnValues), [250, 300, 350, 400])
        self.assertEqual(len(study.Shape.Wires), 4)
        for wire, length in zip(study.Shape.Wires, study.DrawnValues, strict=True):
            self.assertAlmostEqual(wire.Length, length, delta=1e-3 * length)
        self.assertEqual(self.column(study, "Length ["), ["250", "300", "350", "400"])
        self.assertEqual(study.Status, "")
        self.assertFalse(study.OutOfDate)

    def test_its_rows_are_those_of_the_cable(self):
        study = self.study(varied="Length", start="300 mm", stop="360 mm", count=3)
        self.run_unchanged(study)
        radii = [float(text) for text in self.column(study, "Smallest bend radius")]
        for length, radius in zip((300, 330, 360), radii, strict=True):
            self.cable.Length = length
            self.compute()
            self.assertAlmostEqual(self.cable.SmallestBendRadius.Value, radius, delta=1e-3 * radius)

    def test_a_part_that_moves(self):
        study = self.study(
            self.right, "Placement.Base.x", start=100, stop=140, count=5, draw="Solids"
        )
        self.run_unchanged(study)
        self.assertEqual(len(study.Shape.Solids), 5)
        ends = sorted(solid.BoundBox.XMax for solid in study.Shape.Solids)
        self.assertAlmostEqual(ends[-1] - ends[0], 40, delta=8)
        self.assertGreater(study.SmallestBendRadius.Value, 0)
        self.assertIn(study.LargestEndForceValue, study.DrawnValues)

    def test_a_roll_of_a_terminal(self):
        study = self.study(self.end, "Roll", start=0, stop=90, count=4)
        self.run_unchanged(study)
        self.assertEqual(len(set(self.column(study, "Energy"))), 4)

    def test_a_roll_beyond_a_turn(self):
        study = self.study(self.end, "Roll", start=330, stop=420, count=4)
        self.run_unchanged(study)
        self.assertEqual(list(study.DrawnValues), [330, 360, 390, 420])
        self.assertEqual(len(set(self.column(study, "Energy"))), 4)

    def test_a_value_that_the_property_does_not_take_is_a_row(self):
        study = self.study(self.right, "Height", values=[10, -5, 12])
        self.run_unchanged(study)
        self.assertEqual(list(study.DrawnValues), [10, 12])
        self.assertIn("Height of Right became 0 where -5 was set", study.Notes[0])

    def test_a_whole_number_between_two_is_a_row(self):
        array = self.doc.addObject("App::FeaturePython", "Array")
        array.addProperty("App::PropertyInteger", "Count")
        self.cable.setExpression("Length", "300 mm + 10 mm * Array.Count")
        self.compute()
        study = self.study(array, "Count", start=0, stop=2, count=5)
        self.run_unchanged(study)
        self.assertEqual(list(study.DrawnValues), [0, 1, 2])
        self.assertIn("Count of Array became 0 where 0.5 was set", study.Notes[0])

    def test_a_cell_of_a_sheet_that_drives_a_part_and_the_cable(self):
        sheet = self.doc.addObject("Spreadsheet::Sheet", "Table")
        sheet.set("A1", "=120 mm")
        sheet.setAlias("A1", "apart")
        self.doc.recompute()
        self.right.setExpression("Placement.Base.x", "Table.apart")
        self.cable.setExpression("Length", "2.5 * Table.apart")
        self.compute()
        study = self.study(sheet, "apart", start=100, stop=140, count=3)
        self.run_unchanged(study)
        self.assertEqual(self.column(study, "Length ["), ["250", "300", "350"])

    def test_a_number_that_an_expression_gives(self):
        self.right.setExpression("Placement.Base.x", "100 mm + 20 mm")
        self.compute()
        study = self.study(self.right, "Placement.Base.x", start=110, stop=130, count=3)
        self.run_unchanged(study)
        self.assertEqual(list(study.DrawnValues), [110, 120, 130])

    def test_a_list_of_values_in_their_order(self):
        study = self.study(varied="Length", values=[320, 280, 300])
        self.run_unchanged(study)
        self.assertEqual(self.column(study, "Length ["), ["320", "280", "300"])

    def test_a_value_that_cannot_be_solved_is_a_row(self):
        study = self.study(varied="Length", values=[300, 50, 310])
        self.run_unchanged(study)
        self.assertEqual(list(study.DrawnValues), [300, 310])
        self.assertIn("shortest possible length", study.Notes[0])

    def test_a_last_value_at_which_something_cannot_be_computed(self):
        self.end.Condition = "Swivel"
        ring = make.ring(self.doc, self.plate("Plate", (60, 20, 60), (1, 0, 0)))
        self.cable.Length, self.cable.Supports = 305, [ring]
        self.compute()
        for varied, broken in (((ring, "Clearance"), 20), ((self.left, "Radius"), 0)):
            study = self.study(*varied, values=[4, 0.5, broken])
            self.run_unchanged(study)
            self.assertEqual(list(study.DrawnValues), [4, 0.5])
            self.compute()
        self.run_unchanged(self.study(varied="Length", values=[305, 310]))

    def test_a_number_of_the_cable_type(self):
        self.run_unchanged(self.study(self.type, "BendingStiffness", start=1e6, stop=2e6, count=3))

    def test_the_plot_is_a_drawing(self):
        study = self.study(varied="Length", start=280, stop=320, count=3)
        self.run_unchanged(study)
        root = ET.fromstring(Path(study.Plot).read_text(encoding="utf-8"))
        self.assertEqual(root.tag, "{http://www.w3.org/2000/svg}svg")
        self.assertEqual(len(root.findall("{http://www.w3.org/2000/svg}polyline")), 3)

    def test_an_envelope_leaves_no_gaps(self):
        study = self.study(
            self.right, "Placement.Base.y", start=0, stop=20, count=2, draw="Envelope"
        )
        self.run_unchanged(study)
        # Right end moves by 20 mm; the radius is 3.5 mm.
        self.assertGreaterEqual(len(study.Shape.Solids), 7)

    def test_the_length_that_all_positions_need(self):
        self.type.MinBendRadius = "30 mm"
        self.compute()
        study = self.study(
            self.right, "Placement.Base.x", values=[100, 130], find_needed_length=True
        )
        self.run_unchanged(study)
        needed = []
        self.cable.LengthMode = "Shortest"
        for there in (100, 130):
            self.right.Placement.Base.x = there
            self.compute()
            needed.append((self.cable.ShortestLength.Value, there))
        length, there = max(needed)
        self.assertEqual(study.NeededLengthValue, there)
        self.assertAlmostEqual(study.NeededLength.Value, length, delta=1e-3 * length)


class TestTolerance(StudyTest):
    def test_random_cases(self):
        study = self.study(
            kind="Random",
            cases=12,
            position_tolerance="1 mm",
            angle_tolerance="2 deg",
            stiffness_factor=1.5,
        )
        self.run_unchanged(study)
        self.assertEqual(study.Share, 1.0)
        self.assertTrue(1 <= study.WorstCase <= 12)
        self.assertEqual(len(study.Shape.Wires), 2)
        self.assertEqual(len(self.column(study, "Length [")), 12)
        again = self.column(study, "Smallest bend radius")
        studying.run(study)
        self.assertEqual(self.column(study, "Smallest bend radius"), again)

    def test_corners(self):
        study = self.study(kind="Corners", stiffness_factor=2.0)
        self.run_unchanged(study)
        self.assertEqual(len(self.column(study, "Length [")), 4)
        self.assertEqual(sorted(set(self.column(study, "Length ["))), ["300", "325"])

    def test_a_cable_is_made_as_long_as_was_found(self):
        self.type.MinBendRadius = "30 mm"
        self.cable.LengthMode = "Shortest"
        self.compute()
        study = self.run_unchanged(self.study(kind="Corners"))
        found = self.cable.SolvedLength.Value
        for text, length in zip(self.column(study, "Length ["), (found, found + 50), strict=True):
            self.assertAlmostEqual(float(text), length, delta=2e-3)

    def test_no_tolerance_is_none(self):
        study = self.study(kind="Random", length_tolerance=False)
        with self.assertRaisesRegex(DocumentError, "no other tolerance"):
            studying.run(study)
