# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands about the whole document: the report on its cables, and an example."""

import os

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from ..document import report
from .command import Command
from .selection import has_proxy

translate = FreeCAD.Qt.translate

PICTURE = 1600, 1000
"""[px] of the window's picture in the report."""


class ReportCommand(Command):
    menu_text = "Report"
    tooltip = "Writes a page and a spreadsheet about all cables, the worst first"
    pixmap = "cable_report"

    folder = ""

    def lines(self, picks):
        document = FreeCAD.ActiveDocument
        if not any(has_proxy(obj, "Cable") for obj in document.Objects):
            return None
        picture = report.page_path(document, self.folder).with_suffix(".png")
        taken, shown = [], ""
        views = FreeCADGui.getDocument(document.Name).mdiViewsOfType("Gui::View3DInventor")
        if views and os.path.isdir(self.folder):  # what cannot be written is said by the report
            width, height = PICTURE
            view = "Gui.activeDocument().mdiViewsOfType('Gui::View3DInventor')[0]"
            taken = [f"{view}.saveImage({str(picture)!r}, {width}, {height}, 'White')"]
            shown = f", picture={str(picture)!r}"
        return [
            "from freecad_cable.document import report",
            *taken,
            f"report.write(App.ActiveDocument, {self.folder!r}{shown})",
        ]

    def Activated(self):
        self.folder = _folder(FreeCAD.ActiveDocument)
        if self.folder:
            super().Activated()

    def finish(self, document):
        super().finish(document)
        page = report.page_path(document, self.folder)
        FreeCAD.Console.PrintMessage(f"{self.menu_text}: {page}\n")
        QtGui.QDesktopServices.openUrl(QtCore.QUrl.fromLocalFile(str(page)))


class ExampleCommand(Command):
    menu_text = "Example"
    tooltip = "Opens an equipment panel with ten cables in a new document"
    pixmap = "cable_example"

    def lines(self, picks):
        return [
            "from freecad_cable.demo import example",
            "example.make_document()",
            "Gui.activeDocument().activeView().viewIsometric()",
            "Gui.activeDocument().activeView().fitAll()",
        ]

    def IsActive(self):
        return not FreeCADGui.Control.activeDialog()

    def Activated(self):
        # A document of its own: nothing to undo.
        for line in self.lines([]):
            FreeCADGui.doCommand(line)


def _folder(document):
    """That of the document; before it is saved, the one that the user chooses; empty if none."""
    if document.FileName:
        return os.path.dirname(document.FileName)
    window = FreeCADGui.getMainWindow()
    return QtGui.QFileDialog.getExistingDirectory(
        window, translate("Cable", "Folder for the report")
    )
