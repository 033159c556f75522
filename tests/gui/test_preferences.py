# SPDX-License-Identifier: LGPL-2.1-or-later
"""The preferences: the page as a person uses it, and what new cables make of it."""

import os
from unittest import mock

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui
from window import WindowTest

from freecad_cable.document import make
from freecad_cable.document.solving import UPDATES
from freecad_cable.document.terminal import CONDITIONS
from freecad_cable.gui import preferences


class PreferencesTest(WindowTest):
    def setUp(self):
        super().setUp()
        self.forget()
        self.addCleanup(self.forget)

    def forget(self):
        FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod").RemGroup("Cable")

    def on_the_page(self, act):
        """Open the dialog, do ``act(page)`` on our page, and press OK."""
        seen = []

        def use():
            dialog = QtGui.QApplication.activeModalWidget()
            if dialog is None:  # not yet
                QtCore.QTimer.singleShot(100, use)
                return
            pages = dialog.findChildren(QtGui.QWidget, "CablePreferences")
            seen.extend(pages)
            try:
                act(pages[0])
            finally:
                box = dialog.findChildren(QtGui.QDialogButtonBox)[-1]
                box.button(QtGui.QDialogButtonBox.Ok).click()

        QtCore.QTimer.singleShot(500, use)
        FreeCADGui.runCommand("Std_DlgPreferences")
        self.assertEqual(len(seen), 1)

    def shown(self, page):
        kinds = {
            "cable_type": QtGui.QLineEdit,
            "slack": QtGui.QDoubleSpinBox,
            "tolerance": QtGui.QDoubleSpinBox,
            "update": QtGui.QComboBox,
            "condition": QtGui.QComboBox,
        }
        return {name: page.findChild(kind, name) for name, kind in kinds.items()}

    def test_the_page_starts_with_what_make_does(self):
        def look(page):
            shown = self.shown(page)
            self.values = {
                "slack": shown["slack"].value(),
                "tolerance": shown["tolerance"].value(),
                "update": shown["update"].currentIndex(),
                "condition": shown["condition"].currentIndex(),
                "cable_type": shown["cable_type"].text(),
            }
            self.counts = shown["update"].count(), shown["condition"].count()
            self.colour = page.findChild(QtGui.QPushButton, "colour").property("color").getRgb()
            if "CABLE_PICTURES" in os.environ:
                page.grab().save(f"{os.environ['CABLE_PICTURES']}/preferences.png")

        self.on_the_page(look)
        expected = {
            "slack": preferences.SLACK,
            "tolerance": preferences.TOLERANCE,
            "update": preferences.UPDATE,
            "condition": 0,
            "cable_type": "",
        }
        self.assertEqual(self.values, expected)
        self.assertEqual(self.counts, (len(UPDATES), len(CONDITIONS)))
        given = tuple(round(255 * part) for part in preferences.cable_colour())
        self.assertEqual(self.colour[:3], given)
        # Whoever presses OK without a change gets what was there before.
        self.assertEqual(preferences.cable_arguments(self.document), "")
        self.assertEqual(preferences.terminal_arguments(), "")
        cable = self.make_cable(slack=None, length=None)
        self.assertEqual(100 * cable.Slack, preferences.SLACK)
        self.assertEqual(100 * cable.Tolerance, preferences.TOLERANCE)
        self.assertEqual(cable.Update, UPDATES[preferences.UPDATE])

    def test_a_cable_after_a_visit_to_the_page(self):
        def change(page):
            shown = self.shown(page)
            shown["slack"].setValue(25)
            shown["tolerance"].setValue(0.05)
            shown["update"].setCurrentIndex(UPDATES.index("Live"))
            shown["condition"].setCurrentIndex(CONDITIONS.index("Swivel"))
            shown["cable_type"].setText("White wire")
            page.findChild(QtGui.QPushButton, "colour").setProperty(
                "color", QtGui.QColor(200, 100, 50)
            )

        self.on_the_page(change)
        for _ in range(2):
            FreeCADGui.Selection.clearSelection()
            for name, face in (("Left", "Face2"), ("Right", "Face1")):
                FreeCADGui.Selection.addSelection(self.name, name, face)
            FreeCADGui.runCommand("Cable_Cable")
            self.pump(0.05)
            self.ok()
        cables = self.document.findObjects("Part::FeaturePython", "^Cable")
        self.assertEqual(len(cables), 2)
        for cable in cables:
            self.assertEqual((cable.Slack, cable.Tolerance, cable.Update), (0.25, 5e-4, "Live"))
            self.assertEqual((cable.Start.Condition, cable.End.Condition), ("Swivel", "Swivel"))
            colour = [round(255 * part) for part in cable.ViewObject.ShapeColor[:3]]
            self.assertEqual(colour, [200, 100, 50])
        # The second takes the type that the first one brought.
        self.assertEqual(cables[0].CableType.Label, "White wire")
        self.assertIs(cables[1].CableType, cables[0].CableType)

    def test_what_is_stored_wrongly_does_no_harm(self):
        stored = FreeCAD.ParamGet(preferences.GROUP)
        stored.SetInt("Update", 17)
        stored.SetInt("Condition", -1)
        self.assertEqual(preferences.cable_arguments(self.document), ", update='Live'")
        self.assertEqual(preferences.terminal_arguments(), "")
        stored.SetFloat("Slack", -5)
        self.assertIn("slack=-0.05", preferences.cable_arguments(self.document))

    def test_macros_do_not_read_them(self):
        FreeCAD.ParamGet(preferences.GROUP).SetFloat("Slack", 25)
        with mock.patch.object(preferences, "cable_arguments", side_effect=AssertionError):
            cable = self.make_cable(length=None)
        self.assertEqual(cable.Slack, 0.1)
        self.assertEqual(make.terminal(self.document, None).Condition, "Clamped")
