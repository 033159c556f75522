# SPDX-License-Identifier: LGPL-2.1-or-later
"""A hand drags the arm of a mechanism in the window, and the cable follows."""

import sys
from pathlib import Path

import FreeCADGui
from FreeCAD import Placement, Rotation, Vector
from mouse import LEFT, Mouse
from PySide import QtCore
from window import WindowTest

from freecad_cable.document import make

sys.path.append(str(Path(__file__).parents[1] / "document"))
from mechanisms import ASSEMBLIES, TIP, Mechanism
from scenes import TOP

STEPS = 20
DOWN = QtCore.QPointF(3, 3)
"""[pixels] of a step of the mouse; the view is axonometric, so this is downwards."""


class DragTest(WindowTest):
    """An arm that slides up and down beside its base, held by a joint where FreeCAD has some."""

    def setUp(self):
        super().setUp()
        for name in ("Left", "Right"):
            self.document.removeObject(name)
        pins = [self.pin("Base", 0), self.pin("Arm", 120)]
        self.mechanism = Mechanism(self.document, *pins)
        self.mechanism.place(Placement(Vector(120, 0, 0), Rotation()))
        self.document.recompute()
        if ASSEMBLIES:
            self.mechanism.joint.JointType = "Slider"
        self.arm = self.mechanism.arm
        self.ends = [
            make.terminal(self.document, (pin, TOP), inside=self.mechanism.assembly) for pin in pins
        ]
        self.cable = make.cable(
            self.document, start=self.ends[0], end=self.ends[1], length="300 mm"
        )
        self.cable.Update = "Live"
        self.compute()
        self.line = self.cable.ViewObject.Proxy.line
        FreeCADGui.activeView().viewAxonometric()
        FreeCADGui.activeView().fitAll()
        self.pump(1)  # the camera flies

    def pin(self, name, x):
        pin = self.document.addObject("Part::Cylinder", name)
        pin.Radius, pin.Height = 8, 10
        pin.Placement.Base = Vector(x, 0, -10)
        return pin

    def tip(self):
        return (self.arm.Placement * TIP).Base

    def drag(self, point, at_each_step):
        """Take hold at a point of the document, and let go after some steps."""
        gui = FreeCADGui.getDocument(self.name)
        if not ASSEMBLIES:
            for _ in range(STEPS):
                self.arm.Placement.Base += Vector(0, 0, -1)
                self.arm.purgeTouched()
                self.pump(0.05)
                at_each_step()
            return
        gui.setEdit(self.mechanism.assembly.Name)
        try:
            self.drag_with_a_mouse(point, at_each_step)
        finally:
            gui.resetEdit()

    def drag_with_a_mouse(self, point, at_each_step):
        mouse = Mouse()
        place = mouse.at(point)
        mouse.move(place)
        self.pump(0.2)
        mouse.press(place)
        for _ in range(STEPS):
            place += DOWN
            mouse.move(place, held=LEFT)
            self.pump(0.05)
            at_each_step()
        mouse.release(place)
        self.rest()

    def test_the_line_follows_the_hand_and_the_solid_when_it_lets_go(self):
        before, ends = self.tip(), []

        def look():
            if self.line.shown:
                ends.append(Vector(*self.line.points[-1]))

        self.drag(self.arm.Placement * Vector(8, 0, 5), look)
        moved = self.tip() - before
        self.assertLess(moved.z, -10)
        # A line on the way, at least, besides those at either end.
        self.assertGreater(len({end.z for end in ends}), 2)
        self.assertLess(ends[-1].z, before.z - 5)
        self.rest()
        self.assertEqual(self.cable.State, ["Up-to-date"])
        self.assertFalse(self.line.shown)
        self.assertLess((self.cable.NodePosition[-1] * 1e3 - self.tip()).Length, 1e-6)
        self.assertAlmostEqual(self.cable.Shape.BoundBox.ZMin, self.tip().z, delta=1e-3)

    def test_a_hand_on_the_cable_moves_nothing(self):
        middle = self.cable.NodePosition[len(self.cable.NodePosition) // 2] * 1e3
        before = self.tip()

        def look():
            for obj in (self.cable, self.cable.Centreline):
                self.assertEqual(obj.Placement, Placement())

        if not ASSEMBLIES:
            self.cable.Placement.Base = Vector(5, 5, 5)
            look()
            return
        self.drag(middle, look)
        self.assertLess((self.tip() - before).Length, 1e-6)
        self.assertLess((self.cable.NodePosition[-1] * 1e3 - before).Length, 1e-6)
