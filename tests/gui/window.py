# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the tests of this room share: a small assembly, and a window that lives while a test waits."""

import time
import unittest

import FreeCAD
import FreeCADGui
from FreeCAD import Vector
from PySide import QtGui
from task_panel import buttons, press

from freecad_cable.document import make, solving
from freecad_cable.gui.live import live
from freecad_cable.gui.worker import worker

LONG = 20.0
"""[s] After which something that should happen has not happened."""


class WindowTest(unittest.TestCase):
    """Two plates, 200 mm apart, and a cable between them."""

    def setUp(self):
        FreeCADGui.activateWorkbench("CableWorkbench")
        self.document = FreeCAD.newDocument("Window")
        self.document.UndoMode = 1
        self.name = self.document.Name
        for name, x in (("Left", -110), ("Right", 100)):
            plate = self.document.addObject("Part::Box", name)
            plate.Placement.Base = Vector(x, 0, 0)
        self.document.recompute()
        FreeCADGui.Selection.clearSelection()

    def tearDown(self):
        if self.is_open():
            FreeCADGui.Control.closeDialog()
        if self.name in FreeCAD.listDocuments():
            FreeCAD.closeDocument(self.name)
        self.pump(0.05)
        worker.forget()

    def make_cable(self, **properties):
        self.start = make.terminal(self.document, (self.document.Left, "Face2"))
        self.end = make.terminal(self.document, (self.document.Right, "Face1"))
        self.kind = make.cable_type(self.document, "Multi-core cable 7 mm", min_bend_radius="20 mm")
        given = {"length": "300 mm"} | properties
        self.cable = make.cable(
            self.document, start=self.start, end=self.end, cable_type=self.kind, **given
        )
        self.compute()
        return self.cable

    def compute(self):
        """Recompute, and wait for what is solved beside the window."""
        self.document.recompute()
        solving.wait(self.document)

    def pump(self, seconds=LONG, until=lambda: False):
        """Let the window live; whether ``until`` came true in time."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            QtGui.QApplication.processEvents()
            if until():
                return True
            time.sleep(1e-3)
        return False

    def wait_for(self, until):
        self.assertTrue(self.pump(until=until), "did not happen")

    def rest(self):
        """Until nothing moves and nothing is solved."""
        self.wait_for(lambda: not (live.is_moving() or worker.jobs()))

    def is_open(self):
        return bool(FreeCADGui.Control.activeDialog())

    def open_panel(self, obj):
        self.wait_for(lambda: not self.is_open())
        self.assertTrue(obj.ViewObject.doubleClicked())
        self.wait_for(lambda: self.is_open() and buttons())
        self.pump(0.05)

    def widget(self, name, kind=QtGui.QWidget):
        (found,) = FreeCADGui.getMainWindow().findChildren(kind, name)
        return found

    def press(self, button):
        """OK or Cancel of the panel."""
        self.wait_for(buttons)
        press(button)
        self.pump(0.05)
        self.assertFalse(self.is_open())

    def ok(self):
        self.press(QtGui.QDialogButtonBox.Ok)

    def cancel(self):
        self.press(QtGui.QDialogButtonBox.Cancel)
