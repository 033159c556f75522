# SPDX-License-Identifier: LGPL-2.1-or-later
"""Studies in a document: what they find, and that they leave everything as it was."""

import re
import xml.etree.ElementTree as ET
from pathlib import Path
from unittest import mock

import FreeCAD
from FreeCAD import Placement, Rotation, Vector
from scenes import DocumentTest

from freecad_cable.document import make, studying
from freecad_cable.errors import DocumentError


def state(document):
    """What a user could see change: every property that can be read as text, and whether it is to be recomputed."""
    found = {}
    for obj in document.Objects:
        if obj.Name.startswith("Study"):
            continue
        found[obj.Name] = tuple(obj.State), tuple(obj.ExpressionEngine)
        for name in obj.PropertiesList:
            if name in ("Shape", "Proxy", "ExpressionEngine", "cells"):
                continue
            # Without addresses, which FreeCAD 1.0 and later write into some.
            found[obj.Name, name] = re.sub(r"0x[0-9a-f]+", "", repr(getattr(obj, name)))
        if hasattr(obj, "Shape"):
            found[obj.Name, "Volume"] = obj.Shape.Volume, obj.Shape.Length
        if obj.TypeId == "Spreadsheet::Sheet":
            found[obj.Name, "cells"] = {
                cell: obj.getContents(cell) for cell in ("A1", "A2", "B1") if obj.getContents(cell)
            }
    return found


class StudyTest(DocumentTest):
    def setUp(self):
        super().setUp()
        self.cable_between_pins(length="300 mm")
        self.compute()

    def study(self, *varied, **arguments):
        made = make.study(
            self.doc, self.cable, **({"varied": varied} if len(varied) > 1 else {}) | arguments
        )
        return made

    def run_unchanged(self, study):
        before = state(self.doc)
        studying.run(study)
        self.assertEqual(state(self.doc), before)
        return study

    def column(self, study, head):
        sheet = study.Sheet
        for letter in "ABCDEFGHIJKLMNOPQRSTUVWXYZ":
            if head in str(sheet.getContents(f"{letter}1")):
                contents = (sheet.getContents(f"{letter}{k}") for k in range(2, 200))
                return [text.lstrip("'=") for text in contents if text]
        raise AssertionError(head)


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

    def test_no_tolerance_is_none(self):
        study = self.study(kind="Random", length_tolerance=False)
        with self.assertRaisesRegex(DocumentError, "no other tolerance"):
            studying.run(study)


class TestTrouble(StudyTest):
    def refused(self, study, sentence):
        before = state(self.doc)
        with self.assertRaisesRegex(DocumentError, sentence):
            studying.run(study)
        self.assertEqual(state(self.doc), before)
        self.assertTrue(study.Shape.isNull())
        self.assertRegex(study.Status, sentence)

    def test_what_cannot_be_varied(self):
        self.refused(self.study(varied="Lenght", start=1, stop=2), "no number")
        self.refused(self.study(self.right, "Label", start=1, stop=2), "no number")
        self.refused(self.study(self.right, "Placement.Base", start=1, stop=2), "no number")

    def test_what_does_not_matter(self):
        self.refused(self.study(varied="Slack", start=0.1, stop=0.2), "does not change the cable")

    def test_no_range(self):
        self.refused(self.study(varied="Length", start=300, stop=300), "so is From")
        self.refused(self.study(varied="Length", start=300, stop=400, count=1), "at least 2")

    def test_nothing_can_be_solved(self):
        self.refused(self.study(varied="Length", start=10, stop=20), "shortest possible length")

    def test_an_abort_in_the_middle(self):
        study = self.study(self.right, "Placement.Base.x", start=100, stop=140, count=9)
        self.interrupted(study, FreeCAD.Base.FreeCADAbort("stop"), "was stopped")

    def test_an_error_in_the_middle(self):
        study = self.study(self.right, "Placement.Base.x", start=100, stop=140, count=9)
        before = state(self.doc)
        with (
            self.after_three(RuntimeError("broken")),
            self.assertRaisesRegex(RuntimeError, "broken"),
        ):
            studying.run(study)
        self.assertEqual(state(self.doc), before)

    def interrupted(self, study, error, sentence):
        with self.after_three(error):
            self.refused(study, sentence)

    def after_three(self, error):
        real, calls = studying.Family.scene, []

        def scene(family, value):
            calls.append(value)
            if len(calls) > 6:
                raise error
            return real(family, value)

        return mock.patch.object(studying.Family, "scene", scene)

    def test_a_cable_that_is_not_solved(self):
        study = self.study(varied="Length", start=300, stop=400)
        self.cable.Length = 10
        self.doc.recompute()
        with self.assertRaisesRegex(DocumentError, "shortest possible length"):
            studying.run(study)

    def test_it_says_when_it_is_out_of_date(self):
        study = self.study(varied="Length", start=280, stop=320, count=3)
        self.doc.recompute()
        self.assertTrue(study.OutOfDate)
        studying.run(study)
        self.doc.recompute()
        self.assertFalse(study.OutOfDate)
        self.right.Placement = Placement(Vector(125, 0, -10), Rotation())
        self.doc.recompute()
        self.assertTrue(study.OutOfDate)
        self.assertEqual(len(study.Shape.Wires), 3)
        self.assertIn("Out of date", study.Status)

    def test_what_is_no_study(self):
        with self.assertRaisesRegex(DocumentError, "must be a cable"):
            make.study(self.doc, self.right)
        with self.assertRaisesRegex(DocumentError, "must be a number with its unit"):
            make.study(self.doc, self.cable, varied="Length", start="wide", stop=3)
        self.assertEqual([o for o in self.doc.Objects if o.Name.startswith("Study")], [])

    def test_a_deleted_cable(self):
        study = self.study(varied="Length", start=280, stop=320, count=3)
        self.doc.removeObject(self.cable.Name)
        with self.assertRaisesRegex(DocumentError, "was deleted"):
            studying.run(study)
