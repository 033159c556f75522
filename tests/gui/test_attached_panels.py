# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panels of terminals and supports, by their widgets."""

import FreeCADGui
import Part
from FreeCAD import Vector
from PySide import QtGui
from window import WindowTest

from freecad_cable.document import make
from freecad_cable.gui.panels.verdicts import BAD


class TerminalPanelTest(WindowTest):
    def setUp(self):
        super().setUp()
        self.make_cable()
        self.line = self.cable.ViewObject.Proxy.line
        self.volume, self.twist = self.cable.Shape.Volume, self.cable.EndMoment.x

    def test_the_cable_follows_what_is_changed(self):
        self.open_panel(self.end)
        self.widget("Offset.Base.z").setProperty("rawValue", 15.0)
        self.rest()
        self.assertFalse(self.line.shown)
        # The terminal looks along -x; 15 mm out of its plate.
        self.assertLess(self.end.Frame.Base.distanceToPoint(Vector(85, 5, 5)), 1e-9)
        self.assertAlmostEqual(self.cable.NodePosition[-1].x, 0.085, delta=1e-9)
        self.widget("Roll").setProperty("rawValue", 90.0)
        self.rest()
        self.assertEqual(self.end.Roll.Value, 90)
        self.assertGreater(abs(self.cable.EndMoment.x - self.twist), 1e-4)
        self.assertIn("N m", self.widget("Verdicts").text())
        self.cancel()
        self.assertEqual(self.end.Offset.Base, Vector())
        self.assertEqual(self.end.Roll.Value, 0)
        self.assertEqual(self.cable.Shape.Volume, self.volume)
        self.assertEqual(self.cable.EndMoment.x, self.twist)

    def test_the_slider_of_the_roll(self):
        self.open_panel(self.end)
        slider = self.widget("RollSlider")
        slider.setSliderDown(True)
        slider.setValue(750)
        self.wait_for(lambda: self.line.shown)
        self.assertEqual(self.end.Roll.Value, 90)
        self.assertEqual(self.cable.EndMoment.x, self.twist)
        slider.setSliderDown(False)
        self.rest()
        self.assertNotEqual(self.cable.EndMoment.x, self.twist)
        self.ok()
        self.document.undo()
        self.assertEqual(self.end.Roll.Value, 0)

    def test_another_place(self):
        self.open_panel(self.end)
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(self.document.Name, "Right", "Face6")
        self.widget("TakeSelection").click()
        self.rest()
        self.assertLess(self.end.Frame.Base.distanceToPoint(Vector(105, 5, 10)), 1e-9)
        self.assertTrue(self.cable.isValid(), self.cable.Status)
        self.ok()

    def test_what_it_holds(self):
        self.open_panel(self.end)
        held = self.widget("Condition")
        held.setCurrentIndex(held.findData("Swivel"))
        self.rest()
        self.assertAlmostEqual(self.cable.EndMoment.x, 0, delta=1e-9)
        held.setCurrentIndex(held.findData("Free"))
        self.rest()
        self.assertEqual(self.cable.EndForce.Length, 0)
        self.ok()

    def test_without_a_cable(self):
        terminal = make.terminal(self.document, (self.document.Left, "Face6"))
        self.document.recompute()
        self.open_panel(terminal)
        self.widget("Roll").setProperty("rawValue", 30.0)
        self.ok()
        self.assertEqual(terminal.Roll.Value, 30)
        self.assertEqual(terminal.State, ["Up-to-date"])

    def test_what_is_wrong(self):
        self.open_panel(self.end)
        self.document.removeObject("Right")
        self.document.recompute()
        self.rest()
        self.wait_for(lambda: BAD in self.widget("Said").text())
        self.assertIn("Reference", self.widget("Said").text())
        self.cancel()
        self.assertTrue(self.cable.isValid(), self.cable.Status)


class SupportPanelTest(WindowTest):
    def setUp(self):
        super().setUp()
        plate = self.document.addObject("Part::Feature", "Plate")
        hole = Part.makeCylinder(9, 4, Vector(-2, 0, 0), Vector(1, 0, 0))
        plate.Shape = Part.makeBox(2, 60, 60, Vector(-1, -30, -30)).cut(hole)
        plate.Placement.Base = Vector(0, 5, -20)
        edges = enumerate(plate.Shape.Edges, 1)
        self.hole = plate, next(f"Edge{i}" for i, e in edges if isinstance(e.Curve, Part.Circle))

    def test_a_clip_is_moved_along_the_cable(self):
        clip = make.clip(self.document, self.hole, position="140 mm")
        self.make_cable(supports=[clip])
        line = self.cable.ViewObject.Proxy.line
        self.open_panel(clip)
        slider = self.widget("PositionSlider")
        slider.setSliderDown(True)
        slider.setValue(slider.value() + 30)
        self.wait_for(lambda: line.shown)
        slider.setSliderDown(False)
        self.rest()
        self.assertAlmostEqual(clip.Position.Value, 149, delta=0.5)
        (node,) = self.cable.NodeOfSupport
        self.assertAlmostEqual(
            1e3 * self.cable.NodeArcLength[node], clip.Position.Value, delta=1e-6
        )
        self.assertIn("Force on the cable", self.widget("Verdicts").text())
        self.widget("Slides").click()
        self.wait_for(lambda: not self.widget("Position").isVisible())
        self.rest()
        self.assertTrue(self.cable.isValid(), self.cable.Status)
        self.cancel()
        self.assertEqual((clip.Position.Value, clip.Slides), (140, False))
        self.assertAlmostEqual(1e3 * self.cable.NodeArcLength[node], 140, delta=1e-6)

    def test_each_kind_has_its_inputs(self):
        expected = {
            "clamp": {"Slides", "Position", "Reverse", "Roll"},
            "clip": {"Slides", "Position", "Reverse"},
            "sleeve": {"Slides", "Position", "Reverse"},
            "ring": {"Slides", "Position", "Radius", "Clearance"},
        }
        every = set().union(*expected.values())
        for kind, names in expected.items():
            with self.subTest(kind):
                support = getattr(make, kind)(self.document, self.hole, position="100 mm")
                self.document.recompute()
                self.open_panel(support)
                window = FreeCADGui.getMainWindow()
                found = {name for name in every if window.findChildren(QtGui.QWidget, name)}
                self.assertEqual(found, names)
                self.cancel()
                self.pump(0.1)
