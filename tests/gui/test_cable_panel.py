# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of a cable, by its widgets."""

from unittest import mock

import FreeCAD
import FreeCADGui
from FreeCAD import Vector
from PySide import QtGui
from window import WindowTest

from freecad_cable.gui.live import live
from freecad_cable.gui.panels import panel as panel_module
from freecad_cable.gui.panels.verdicts import BAD, GOOD
from freecad_cable.gui.worker import worker


def lowest(points):
    return min(point[2] for point in points)


class CablePanelTest(WindowTest):
    def setUp(self):
        super().setUp()
        self.make_cable()
        self.line = self.cable.ViewObject.Proxy.line
        self.steps = self.document.UndoCount
        self.volume = self.cable.Shape.Volume

    def assertBefore(self):
        self.assertEqual(self.cable.Length.Value, 300)
        self.assertEqual(self.cable.SolvedLength.Value, 300)
        self.assertEqual(self.cable.Shape.Volume, self.volume)
        self.assertEqual(self.document.UndoCount, self.steps)
        self.assertFalse(self.line.shown)
        self.assertEqual(self.cable.State, ["Up-to-date"])

    def slide(self, step):
        """Move the slider of the length, still held, and wait for the line."""
        slider = self.widget("LengthSlider")
        before = self.line.points
        slider.setSliderDown(True)
        slider.setValue(step)
        self.wait_for(lambda: self.line.shown and self.line.points != before)
        return slider

    def test_the_line_follows_the_slider_and_the_solid_comes_on_release(self):
        self.open_panel(self.cable)
        slider = self.slide(500)
        half_way = lowest(self.line.points)
        self.slide(700)
        self.assertLess(lowest(self.line.points), half_way - 10)
        self.assertEqual(self.cable.SolvedLength.Value, 300)
        self.assertEqual(self.cable.Shape.Volume, self.volume)
        self.assertIn("Preview", self.widget("Said").text())
        wanted, previewed = self.cable.Length.Value, self.line.points
        slider.setSliderDown(False)
        self.rest()
        self.assertEqual(self.cable.SolvedLength.Value, wanted)
        self.assertGreater(self.cable.Shape.Volume, 1.2 * self.volume)
        self.assertFalse(self.line.shown)
        # The preview is the answer, to its tolerance of 1e-3 of the length.
        answer = lowest([1e3 * p for p in self.cable.NodePosition])
        self.assertAlmostEqual(lowest(previewed), answer, delta=1e-3 * wanted)
        self.ok()
        self.assertEqual(self.document.UndoCount, self.steps + 1)
        self.document.undo()
        self.document.recompute()
        self.assertBefore()

    def test_cancel_while_it_moves(self):
        self.open_panel(self.cable)
        self.slide(600)
        self.cancel()
        self.assertBefore()
        self.pump(0.5)
        self.assertBefore()

    def test_cancel_after_it_was_solved(self):
        self.open_panel(self.cable)
        self.slide(600).setSliderDown(False)
        self.rest()
        self.assertNotEqual(self.cable.SolvedLength.Value, 300)
        self.cancel()
        self.assertBefore()

    def test_a_number_typed(self):
        self.open_panel(self.cable)
        spin = self.widget("Length")
        spin.setProperty("rawValue", 320.0)
        self.rest()
        self.assertEqual(self.cable.SolvedLength.Value, 320)
        self.ok()
        self.assertEqual(self.cable.Length.Value, 320)

    def test_an_expression_is_shown_and_kept(self):
        self.cable.setExpression("Length", "2 * 160 mm")
        self.compute()
        given = self.cable.ExpressionEngine
        self.open_panel(self.cable)
        self.assertEqual(self.widget("Length").property("rawValue"), 320)
        self.assertFalse(self.widget("LengthSlider").isEnabled())
        self.ok()
        self.assertEqual(self.cable.ExpressionEngine, given)
        self.assertEqual(self.cable.SolvedLength.Value, 320)

    def test_the_verdict_says_what_is_wrong(self):
        self.open_panel(self.cable)
        self.assertIn(GOOD, self.widget("Verdicts").text())
        self.assertNotIn(BAD, self.widget("Verdicts").text())
        self.kind.MinBendRadius = "60 mm"
        self.compute()
        self.rest()
        self.wait_for(lambda: BAD in self.widget("Verdicts").text())
        self.assertIn("tighter than the 60 mm", self.widget("Said").text())

    def test_a_length_that_cannot_be(self):
        self.open_panel(self.cable)
        spin = self.widget("Length")
        spin.setProperty("rawValue", 150.0)
        self.wait_for(lambda: BAD in self.widget("Said").text())
        self.assertFalse(self.line.shown)
        self.rest()
        self.assertTrue(self.cable.Shape.isNull())
        self.assertIn("Invalid", self.cable.State)
        self.assertIn("Length", self.widget("Said").text())
        spin.setProperty("rawValue", 310.0)
        self.rest()
        self.assertTrue(self.cable.isValid(), self.cable.Status)
        self.assertEqual(self.cable.SolvedLength.Value, 310)
        spin.setProperty("rawValue", 150.0)
        self.rest()
        self.cancel()
        self.assertBefore()

    def test_opens_where_the_widgets_of_another_panel_were(self):
        box = QtGui.QWidget()
        deleted = FreeCADGui.UiLoader().createWidget("Gui::QuantitySpinBox")
        deleted.setParent(box)
        del box
        with self.assertRaises(RuntimeError):
            deleted.objectName()
        loader = FreeCADGui.UiLoader()
        given = mock.Mock(
            side_effect=[deleted, *(loader.createWidget("Gui::QuantitySpinBox") for _ in range(20))]
        )
        with mock.patch.object(FreeCADGui, "UiLoader", return_value=mock.Mock(createWidget=given)):
            self.open_panel(self.cable)
        self.assertEqual(self.widget("Length").property("rawValue"), 300)
        self.cancel()

    def test_modes(self):
        self.open_panel(self.cable)
        mode = self.widget("LengthMode")
        mode.setCurrentIndex(mode.findData("Slack"))
        self.wait_for(lambda: not self.widget("Length").isVisible())
        self.assertTrue(self.widget("Slack").isVisible())
        self.rest()
        self.assertAlmostEqual(self.cable.SolvedLength.Value, 220, delta=1e-6)
        mode.setCurrentIndex(mode.findData("Shortest"))
        self.wait_for(lambda: not self.widget("Slack").isVisible())
        # To look for the shortest length may take long; it need not be waited for.
        self.wait_for(lambda: not live.is_moving())
        worker.stop()
        self.rest()
        self.cancel()
        self.assertBefore()

    def test_a_part_that_is_moved_takes_the_line_along(self):
        self.open_panel(self.cable)
        with mock.patch.object(QtGui.QApplication, "mouseButtons", return_value=1):
            for y in (10, 20, 30):
                self.document.Right.Placement.Base = Vector(100, y, 0)
                self.wait_for(
                    lambda y=y: self.line.shown and abs(self.line.points[-1][1] - y - 5) < 1e-3
                )
            self.pump(0.5)
            self.assertEqual(self.end.Frame.Base.y, 35)
            self.assertLess(self.cable.Shape.BoundBox.YMax, 20)
        self.rest()
        self.assertGreater(self.cable.Shape.BoundBox.YMax, 35)
        self.cancel()
        self.assertBefore()
        self.assertEqual(self.document.Right.Placement.Base, Vector(100, 0, 0))

    def test_what_ok_writes_is_a_macro(self):
        self.open_panel(self.cable)
        self.widget("Length").setProperty("rawValue", 320.0)
        self.widget("Clearance").setProperty("rawValue", 2.0)
        written = []
        with mock.patch.object(panel_module.FreeCADGui, "doCommand", written.append):
            self.ok()
        place = "App.getDocument('Window').getObject('Cable')"
        self.assertEqual(written, [f"{place}.Clearance = 2.0", f"{place}.Length = 320.0"])

    def test_deleted_under_the_panel(self):
        self.open_panel(self.cable)
        self.slide(600)
        self.document.removeObject(self.cable.Name)
        self.wait_for(lambda: not self.is_open())

    def test_the_document_is_closed_under_the_panel(self):
        self.open_panel(self.cable)
        self.slide(600)
        FreeCAD.closeDocument(self.document.Name)
        self.wait_for(lambda: not self.is_open())
        self.pump(0.5)

    def test_the_panel_is_closed_without_the_buttons(self):
        """As by a macro; what is said afterwards goes to no widget that is gone."""
        self.open_panel(self.cable)
        panel = self.cable.ViewObject.Proxy.panel
        self.cable.Length = "310 mm"
        with mock.patch("sys.excepthook") as failed:
            FreeCADGui.Control.closeDialog()
            self.pump(0.5)
            self.rest()
        self.assertFalse(failed.called)
        self.assertFalse(panel.is_open)
        self.assertFalse(self.document.HasPendingTransaction)
        self.assertEqual(self.document.UndoCount, self.steps + 1)
        self.assertEqual(self.cable.SolvedLength.Value, 310)
        self.assertIsNone(FreeCADGui.ActiveDocument.getInEdit())

    def test_editing_is_ended_without_the_buttons(self):
        self.open_panel(self.cable)
        self.widget("Length").setProperty("rawValue", 320.0)
        FreeCADGui.activeDocument().resetEdit()
        self.wait_for(lambda: not self.is_open())
        self.assertEqual(self.cable.SolvedLength.Value, 320)
        self.assertEqual(self.document.UndoCount, self.steps + 1)
