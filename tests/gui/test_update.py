# SPDX-License-Identifier: LGPL-2.1-or-later
"""When a cable is solved: its property Update."""

from unittest import mock

from beside import BesideTest
from PySide import QtGui

from freecad_cable.document import interference, solving
from freecad_cable.gui.worker import worker


class UpdateTest(BesideTest):
    def test_manual(self):
        self.cable.Update = "Manual"
        self.cable.Length = 350
        self.document.recompute()
        self.assertFalse(worker.jobs())
        self.assertOld()
        self.assertIn("Manual", self.cable.Status)
        (row,) = (r for r in interference.report(self.document) if r.cable == self.cable.Label)
        self.assertIn("Out of date", row.verdict)
        solving.solve(self.cable)
        self.assertOld()
        self.cable.touch()
        self.document.recompute()
        self.let_go()
        self.assertNew(350)
        self.cable.Length = 360
        self.document.recompute()
        self.assertFalse(worker.jobs())
        self.assertTrue(self.cable.OutOfDate)

    def test_live(self):
        self.slow.gate.set()
        self.cable.Update = "Live"
        self.rest()
        line = self.cable.ViewObject.Proxy.line
        with mock.patch.object(QtGui.QApplication, "mouseButtons", return_value=1):
            for y in (10, 20):
                self.document.Right.Placement.Base.y = y
                self.wait_for(lambda y=y: line.shown and abs(line.points[-1][1] - y - 5) < 1e-3)
            self.assertLess(self.cable.Shape.BoundBox.YMax, 15)
        self.rest()
        self.assertGreater(self.cable.Shape.BoundBox.YMax, 25)
        self.assertFalse(line.shown)

    def test_on_recompute_it_does_not_follow_by_itself(self):
        self.document.Right.Placement.Base.y = 20
        self.pump(0.6)
        self.assertFalse(self.cable.ViewObject.Proxy.line.shown)
        self.assertLess(self.cable.Shape.BoundBox.YMax, 15)
        self.assertIn("Touched", self.cable.State)

    def test_the_context_menu(self):
        self.cable.Update = "Manual"
        self.cable.Length = 350
        self.document.recompute()
        menu = QtGui.QMenu()
        self.cable.ViewObject.Proxy.setupContextMenu(self.cable.ViewObject, menu)
        self.slow.gate.set()
        (action,) = (a for a in menu.actions() if a.text() == "Solve Now")
        action.trigger()
        self.wait_for(lambda: not self.cable.OutOfDate)
        self.assertNew(350)
