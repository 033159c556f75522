# SPDX-License-Identifier: LGPL-2.1-or-later
"""The list of supports in the task panel of a cable, by its widgets."""

from unittest import mock

import FreeCADGui
import Part
from FreeCAD import Vector
from PySide import QtGui
from window import WindowTest

from freecad_cable.document import make
from freecad_cable.gui.panels import panel as panel_module
from freecad_cable.gui.panels.verdicts import BAD


class CableSupportsTest(WindowTest):
    """A cable that hangs through two rings, and a third ring in the document."""

    def setUp(self):
        super().setUp()
        self.first, self.second, self.third = (
            self.ring(name, x) for name, x in (("First", -40), ("Second", 40), ("Third", 0))
        )
        self.make_cable(supports=[self.first, self.second])
        self.steps = self.document.UndoCount
        self.line = self.cable.ViewObject.Proxy.line
        self.shape = self.cable.Shape.Volume, self.cable.Shape.CenterOfMass

    def ring(self, name, x):
        plate = self.document.addObject("Part::Feature", f"{name}Plate")
        hole = Part.makeCylinder(8, 4, Vector(-2, 0, 0), Vector(1, 0, 0))
        plate.Shape = Part.makeBox(2, 40, 40, Vector(-1, -20, -20)).cut(hole)
        plate.Placement.Base = Vector(x, 5, -20)
        edges = enumerate(plate.Shape.Edges, 1)
        edge = next(f"Edge{i}" for i, edge in edges if isinstance(edge.Curve, Part.Circle))
        ring = make.ring(self.document, (plate, edge))
        ring.Label = name
        return ring

    def labels(self):
        shown = self.widget("Supports", QtGui.QListWidget)
        return [shown.item(row).text() for row in range(shown.count())]

    def press_on(self, row, button):
        self.widget("Supports", QtGui.QListWidget).setCurrentRow(row)
        self.assertTrue(self.widget(button).isEnabled())
        self.widget(button).click()

    def select(self, *objects):
        FreeCADGui.Selection.clearSelection()
        for obj in objects:
            FreeCADGui.Selection.addSelection(self.document.Name, obj.Name)

    def assertBefore(self):
        self.assertEqual(self.cable.Supports, [self.first, self.second])
        self.assertEqual(self.document.UndoCount, self.steps)
        self.assertIn("Up-to-date", self.cable.State)
        volume, centre = self.shape
        self.assertEqual(self.cable.Shape.Volume, volume)
        self.assertEqual(self.cable.Shape.CenterOfMass, centre)

    def test_one_is_added_where_it_is_along_the_cable_and_the_line_follows(self):
        self.open_panel(self.cable)
        self.assertEqual(self.labels(), ["First", "Second"])
        self.select(self.third, self.first, self.document.Left)
        with mock.patch.object(QtGui.QApplication, "mouseButtons", return_value=1):
            self.widget("SupportAdd").click()
            self.assertEqual(self.cable.Supports, [self.first, self.third, self.second])
            self.assertEqual(self.labels(), ["First", "Third", "Second"])
            self.wait_for(lambda: self.line.shown)
        self.rest()
        self.assertTrue(self.cable.isValid(), self.cable.Status)
        self.assertEqual(len(self.cable.SupportForces), 3)
        self.ok()
        self.assertEqual(self.document.UndoCount, self.steps + 1)
        self.document.undo()
        self.document.recompute()
        self.assertBefore()

    def test_the_order_is_changed_and_cancelled(self):
        self.open_panel(self.cable)
        self.press_on(0, "SupportDown")
        self.assertEqual(self.cable.Supports, [self.second, self.first])
        self.assertEqual(self.labels(), ["Second", "First"])
        self.assertEqual(self.widget("Supports", QtGui.QListWidget).currentRow(), 1)
        self.assertFalse(self.widget("SupportDown").isEnabled())
        self.rest()
        # Forth, back and forth again is longer than the cable.
        self.assertIn(BAD, self.widget("Said").text())
        self.assertIn("the way through its supports", self.widget("Said").text())
        self.press_on(1, "SupportUp")
        self.assertEqual(self.labels(), ["First", "Second"])
        self.assertFalse(self.widget("SupportUp").isEnabled())
        self.rest()
        self.assertTrue(self.cable.isValid(), self.cable.Status)
        self.press_on(1, "SupportUp")
        self.rest()
        self.cancel()
        self.assertBefore()

    def test_one_is_removed(self):
        self.open_panel(self.cable)
        self.press_on(0, "SupportRemove")
        self.assertEqual(self.labels(), ["Second"])
        self.rest()
        self.assertTrue(self.cable.isValid(), self.cable.Status)
        self.assertEqual(len(self.cable.SupportForces), 1)
        self.press_on(0, "SupportRemove")
        self.assertEqual(self.labels(), [])
        self.assertFalse(self.widget("SupportRemove").isEnabled())
        self.rest()
        self.assertIsNotNone(self.document.getObject(self.first.Name))
        self.cancel()
        self.assertBefore()

    def test_what_somebody_else_changes_is_shown(self):
        self.open_panel(self.cable)
        self.cable.Supports = [self.second]
        self.second.Label = "Hole"
        self.wait_for(lambda: self.labels() == ["Hole"])
        self.rest()
        self.cancel()

    def test_what_ok_writes_is_a_macro(self):
        self.open_panel(self.cable)
        self.press_on(1, "SupportRemove")
        self.rest()
        written = []
        with mock.patch.object(panel_module.FreeCADGui, "doCommand", written.append):
            self.ok()
        place = "App.getDocument('Window')"
        self.assertEqual(
            written, [f"{place}.getObject('Cable').Supports = [{place}.getObject('Ring')]"]
        )
