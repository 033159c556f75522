# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a person sees of a long solve, and how it is stopped."""

from unittest import mock

from beside import BesideTest, find
from PySide import QtGui

from freecad_cable.document import make
from freecad_cable.gui.worker import worker


class ProgressTest(BesideTest):
    def test_stopped_in_the_panel(self):
        self.open_panel(self.cable)
        self.widget("Length").setProperty("rawValue", 350.0)
        self.wait_for(lambda: worker.is_solving(self.cable))
        self.pump(0.3)
        self.assertOld()
        self.assertIn("Solving", self.widget("Said").text())
        self.assertTrue(self.widget("Stop").isVisible())
        self.widget("Stop").click()
        self.wait_for(lambda: not worker.jobs())
        self.assertOld()
        self.assertIn("stopped", self.cable.Status)
        self.wait_for(lambda: not self.widget("Stop").isVisible())
        self.slow.gate.set()
        self.widget("SolveNow").click()
        self.wait_for(lambda: not self.cable.OutOfDate)
        self.assertNew(350)
        self.cancel()
        self.rest()
        self.assertNew(300)

    def test_cancel_of_the_panel_meanwhile(self):
        self.open_panel(self.cable)
        self.widget("Length").setProperty("rawValue", 350.0)
        self.wait_for(lambda: worker.is_solving(self.cable))
        self.cancel()
        self.assertFalse(worker.jobs())
        self.assertNew(300)

    def test_ok_of_the_panel_meanwhile(self):
        self.open_panel(self.cable)
        self.widget("Length").setProperty("rawValue", 350.0)
        self.wait_for(lambda: worker.is_solving(self.cable))
        self.ok()
        self.assertOld()
        self.let_go()
        self.assertNew(350)

    def test_the_status_bar(self):
        progress = self.widget("CableProgress")
        self.edit()
        self.wait_for(progress.isVisible)
        text = progress.findChild(QtGui.QLabel).text()
        self.assertIn("Cable: Solving", text)
        self.assertIn("300 mm in 32 elements", text)
        self.widget("StopAll").click()
        self.wait_for(lambda: not progress.isVisible())
        self.assertOld()
        self.slow.gate.set()
        self.compute()
        self.assertNew(350)

    def test_a_slider_does_not_wait_for_another_cable(self):
        other = make.cable(
            self.document, start=self.start, end=self.end, cable_type=self.kind, length="310 mm"
        )
        self.document.recompute()
        self.wait_for(lambda: worker.is_solving(other) and self.slow.lengths == [310])
        self.open_panel(self.cable)
        line = self.cable.ViewObject.Proxy.line
        slider = self.widget("LengthSlider")
        slider.setSliderDown(True)
        with mock.patch("freecad_cable.document.preview.find_equilibrium", find):
            slider.setValue(500)
            self.wait_for(lambda: line.shown)
        self.assertTrue(worker.is_solving(other))
        self.cancel()
