# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which numbers of a document a study varies, and that what follows from them goes along and comes back."""

import math

from FreeCAD import Rotation, Units, Vector
from studies import StudyTest

from freecad_cable.document import make
from freecad_cable.errors import DocumentError


class TestVaried(StudyTest):
    def sheet(self, **cells):
        sheet = self.doc.addObject("Spreadsheet::Sheet", "Table")
        for cell, text in cells.items():
            sheet.set(cell, text)
        self.doc.recompute()
        return sheet

    def lengths(self, study):
        return [float(text) for text in self.column(study, "Length [")]

    def radius_alone(self):
        self.compute()
        return self.cable.SmallestBendRadius.Value

    def test_a_cell_with_a_whole_number_takes_any(self):
        sheet = self.sheet(B1="1")
        self.cable.setExpression("Length", "300 mm * Table.B1")
        self.compute()
        study = self.run_unchanged(self.study(sheet, "B1", start=1, stop=1.2, count=5))
        self.assertEqual(self.lengths(study), [300, 315, 330, 345, 360])
        self.assertEqual(list(study.JumpValues), [])

    def test_a_cell_with_a_unit_that_is_a_product(self):
        sheet = self.sheet(B1="=2 N")
        self.cable.setExpression("Length", "150 mm * Table.B1 / 1 N")
        self.compute()
        study = self.run_unchanged(self.study(sheet, "B1", start="2 N", stop="2.2 N", count=2))
        self.assertEqual(self.lengths(study), [300, 330])

    def test_a_sheet_between_the_number_and_the_cable_comes_back(self):
        table = self.sheet(A1="=10 mm")
        other = self.doc.addObject("Spreadsheet::Sheet", "Other")
        other.set("B1", "=Table.A1 * 30")
        self.doc.recompute()
        self.cable.setExpression("Length", "Other.B1")
        self.compute()
        study = self.run_unchanged(self.study(table, "A1", start="10 mm", stop="11 mm", count=3))
        self.assertEqual(self.lengths(study), [300, 315, 330])
        self.assertEqual(other.B1.Value, 300)

    def test_the_angle_of_a_placement_is_in_degrees(self):
        self.right.Placement.Rotation = Rotation(Vector(0, 1, 0), 20)
        self.compute()
        angle = (self.right, "Placement.Rotation.Angle")
        study = self.run_unchanged(self.study(*angle, start="20 deg", stop="50 deg", count=3))
        radii = [float(text) for text in self.column(study, "Smallest bend radius")]
        for degrees, radius in zip((20, 35, 50), radii, strict=True):
            self.right.Placement.Rotation = Rotation(Vector(0, 1, 0), degrees)
            self.assertAlmostEqual(self.radius_alone(), radius, delta=1e-3 * radius)
        self.assertIn("[deg]", str(study.Sheet.getContents("A1")))

    def test_whole_numbers_are_no_jumps(self):
        array = self.doc.addObject("App::FeaturePython", "Array")
        array.addProperty("App::PropertyInteger", "Count")
        self.cable.setExpression("Length", "300 mm + 50 mm * Array.Count")
        self.compute()
        study = self.run_unchanged(self.study(array, "Count", values=[0, 1, 2, 4]))
        self.assertEqual(self.lengths(study), [300, 350, 400, 500])
        self.assertEqual((list(study.JumpValues), list(study.Notes)), ([], []))

    def test_values_with_units(self):
        given = Units.Quantity("0.3 m"), "330 mm", 360
        study = make.study(self.doc, self.cable, varied="Length", values=given)
        self.assertEqual(list(study.Values), [300, 330, 360])
        with self.assertRaisesRegex(
            DocumentError, "start is -9.81 m/s.2, and Gravity.z is a plain"
        ):
            make.study(self.doc, self.cable, varied="Gravity.z", start="-9.81 m/s^2", stop=0)
        with self.assertRaisesRegex(DocumentError, "stop is 3 deg, and Length is .* unit mm"):
            make.study(self.doc, self.cable, varied="Length", start=1, stop="3 deg")
        with self.assertRaisesRegex(DocumentError, "start is True; it must be a number"):
            make.study(self.doc, self.cable, varied="Length", start=True, stop=3)

    def test_what_is_no_object_with_a_number(self):
        other = self.doc.Name + "Other"
        import FreeCAD

        away = FreeCAD.newDocument(other)
        try:
            box = away.addObject("Part::Box", "Box")
            count = len(self.doc.Objects)
            for varied in ((self.right,), (3, "Length"), (self.right, 3), (box, "Length")):
                with self.assertRaises(DocumentError):
                    make.study(self.doc, self.cable, varied=varied, start=1, stop=3)
            self.assertEqual(len(self.doc.Objects), count)
        finally:
            FreeCAD.closeDocument(away.Name)

    def test_the_stiffness_and_the_direction_of_gravity(self):
        study = self.run_unchanged(self.study(varied="StiffnessScale", start=0.5, stop=2, count=4))
        forces = [float(text) for text in self.column(study, "End force")]
        self.assertEqual(sorted(set(forces)), forces)
        study = self.study(varied="GravityTurn.y", start="0 deg", stop="90 deg", count=3)
        study = self.run_unchanged(study)
        radii = [float(text) for text in self.column(study, "Smallest bend radius")]
        gravity = self.cable.Gravity.z
        self.cable.Gravity = Vector(
            gravity * math.sin(math.pi / 4), 0, gravity * math.cos(math.pi / 4)
        )
        self.assertAlmostEqual(self.radius_alone(), radii[1], delta=1e-3 * radii[1])

    def test_rows_that_follow_in_another_way_are_old(self):
        sheet = self.sheet(A1="=120 mm")
        self.cable.setExpression("Length", "2.5 * Table.A1")
        self.compute()
        study = self.run_unchanged(self.study(sheet, "A1", start=120, stop=140, count=3))
        self.doc.recompute()
        self.assertFalse(study.OutOfDate)
        self.cable.setExpression("Length", "300 mm + 0 * Table.A1")
        self.compute()
        self.doc.recompute()
        self.assertTrue(study.OutOfDate)
