# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD does not execute what depends on an object in error; what stays as it was must not look like an answer."""

import tempfile
from pathlib import Path

import FreeCAD
from FreeCAD import Vector
from scenes import TOP, DocumentTest

from freecad_cable.document import interference, make


class LeftBehindTest(DocumentTest):
    def setUp(self):
        super().setUp()
        self.cable_between_pins()
        self.end.Condition = "Swivel"
        self.route = make.route(self.doc, self.cable)
        self.compute()

    def assertLeftBehind(self, culprit, *objects):
        """They keep what they have, and say whose fault it is."""
        self.doc.recompute()
        self.assertIn("Invalid", culprit.State)
        for obj in objects or (self.cable, self.cable.Centreline, self.route):
            self.assertIn(f"Out of date: {culprit.Label} cannot be computed (", obj.Status)
            self.assertIn("are from before", obj.Status)
            self.assertNotIn("\n", obj.Status)
            self.assertFalse(obj.Shape.isNull())
        self.assertTrue(self.cable.OutOfDate)

    def assertCaughtUp(self):
        self.compute()
        self.assertFalse(self.cable.OutOfDate)
        self.assertIn("in equilibrium", self.cable.Status)
        for obj in (self.start, self.cable.Centreline, self.route):
            self.assertEqual(obj.Status, "")
        self.assertAlmostEqual(self.cable.SolvedLength.Value, self.cable.Length.Value)

    def test_a_part_in_error(self):
        self.left.Radius, self.cable.Length = 0, "330 mm"
        self.assertLeftBehind(self.left)
        self.assertIn("Radius of cylinder", self.cable.Status)
        self.assertLeftBehind(self.left, self.start)
        self.assertEqual(self.cable.SolvedLength.Value, 300)
        (row,) = interference.report(self.doc)
        self.assertEqual((row.cable, row.verdict), (self.cable.Label, self.cable.Status))
        self.left.Radius = 4
        self.assertCaughtUp()

    def test_a_recompute_of_something_else_changes_no_sentence(self):
        self.left.Radius = 0
        self.assertLeftBehind(self.left)
        said = self.cable.Status
        self.doc.recompute([self.right])
        self.assertEqual(self.cable.Status, said)

    def test_also_if_nothing_else_was_changed(self):
        self.left.Radius = 0
        self.assertLeftBehind(self.left)
        self.left.Radius = 3
        self.assertCaughtUp()

    def test_another_part_is_chosen(self):
        self.left.Radius = 0
        self.assertLeftBehind(self.left)
        self.start.Reference = (self.pin("Spare", (0, 10, 0)), TOP)
        self.doc.removeObject("Left")
        self.assertCaughtUp()

    def test_an_obstacle_in_error(self):
        box = self.doc.addObject("Part::Box", "Box")
        box.Placement.Base = Vector(60, 0, 150)
        self.cable.Obstacles = box
        self.compute()
        box.Length, self.cable.Length = 0, "310 mm"
        self.assertLeftBehind(box)
        box.Length = 5
        self.assertCaughtUp()

    def test_what_was_never_computed_has_no_shape(self):
        self.left.Radius = 0
        route = make.route(self.doc, self.cable)
        cable = make.cable(self.doc, start=self.start, end=self.end, length="320 mm")
        self.doc.recompute()
        for obj in (route, cable, cable.Centreline):
            self.assertTrue(obj.Shape.isNull())
            self.assertIn(f"No shape yet: {self.left.Label} cannot be computed (", obj.Status)
        self.left.Radius = 4
        self.assertCaughtUp()
        self.assertFalse(cable.Shape.isNull())

    def test_an_expression_in_error(self):
        self.cable.setExpression("Length", "1 / 0")
        self.assertLeftBehind(self.cable)
        self.assertIn("division by zero", self.cable.Status)
        self.cable.setExpression("Length", None)
        self.cable.Length = "340 mm"
        self.assertCaughtUp()

    def test_a_cable_that_waits_to_be_asked(self):
        self.cable.Update = "Manual"
        self.compute()
        self.left.Radius = 0
        self.assertLeftBehind(self.left)
        self.left.Radius = 4
        self.assertCaughtUp()

    def test_an_error_of_its_own_stays_what_is_said(self):
        self.cable.Length = "10 mm"
        said = self.assertFailed(self.cable, "Length")
        self.left.Radius = 0
        self.doc.recompute()
        self.assertEqual(self.cable.Status, said)
        self.left.Radius, self.cable.Length = 4, "300 mm"
        self.assertCaughtUp()

    def test_the_document_of_a_part_is_closed(self):
        folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        library = FreeCAD.newDocument("Library")
        pin = library.addObject("Part::Cylinder", "Pin")
        pin.Radius, pin.Height = 4, 10
        library.recompute()
        library.saveAs(str(folder / "library.FCStd"))
        self.doc.saveAs(str(folder / "user.FCStd"))
        loan = self.doc.addObject("App::Link", "Loan")
        loan.LinkedObject = pin
        self.doc.recompute()
        self.start.Reference = (loan, TOP)
        self.compute()
        pin.Radius = 0
        library.recompute()
        self.assertIn("Pin cannot be computed", self.cable.Status)
        self.doc.recompute()
        self.assertIn("Pin cannot be computed", self.cable.Status)
        pin.Radius = 4
        library.recompute()
        self.assertCaughtUp()
        FreeCAD.closeDocument("Library")
        self.cable.Length = "320 mm"
        self.assertLeftBehind(loan)
        FreeCAD.openDocument(str(folder / "library.FCStd"))
        self.addCleanup(FreeCAD.closeDocument, "library")
        self.assertCaughtUp()
