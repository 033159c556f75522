# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands about the whole document, in a window."""

import os
import re
import shutil
import sys
import tempfile
from pathlib import Path
from unittest import mock

import FreeCAD
import FreeCADGui
from PySide import QtGui
from window import WindowTest

from freecad_cable.document import solving
from freecad_cable.gui import report_commands

MATPLOTLIB = "matplotlib", "matplotlib.pyplot"


class ReportCommandTest(WindowTest):
    def setUp(self):
        super().setUp()
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        opened = mock.patch.object(QtGui.QDesktopServices, "openUrl")
        self.opened = opened.start()
        self.addCleanup(opened.stop)

    def run_report(self):
        FreeCADGui.runCommand("Cable_Report")
        self.pump(0.05)

    def test_without_a_cable_there_is_nothing_to_report(self):
        self.assertFalse(FreeCADGui.Command.get("Cable_Report").isActive())
        self.make_cable()
        self.assertTrue(FreeCADGui.Command.get("Cable_Report").isActive())

    def test_beside_the_file_with_a_picture_of_the_window(self):
        self.make_cable()
        FreeCADGui.activeView().fitAll()
        self.document.saveAs(os.path.join(self.folder, "unit 7.FCStd"))
        self.run_report()
        page = Path(self.folder) / "unit-7-cables.html"
        text = page.read_text(encoding="utf-8")
        self.assertIn("300.0", text)
        self.assertIn("data:image/png;base64,", text)
        (url,) = self.opened.call_args.args
        self.assertEqual(Path(url.toLocalFile()), page)
        image = QtGui.QImage(str(page.with_suffix(".png")))
        self.assertEqual((image.width(), image.height()), report_commands.PICTURE)
        colours = {image.pixel(x, y) for x in range(0, 1600, 9) for y in range(0, 1000, 9)}
        self.assertGreater(len(colours), 5, "the picture is empty")
        self.assertEqual(self.document.CableReport.get("A2"), self.cable.Label)

    def test_it_speaks_the_language_of_the_window(self):
        self.make_cable()
        self.kind.MinBendRadius = "60 mm"
        self.document.saveAs(os.path.join(self.folder, "a.FCStd"))
        pages = {}
        self.addCleanup(FreeCADGui.setLocale, "en")
        for language in ("en", "de", "zh-CN"):
            FreeCADGui.setLocale(language)
            self.run_report()
            page = Path(self.folder) / "a-cables.html"
            pages[language] = page.read_text(encoding="utf-8")
            heading = self.document.CableReport.get("C1")
            self.assertEqual(heading, FreeCAD.Qt.translate("CableReport", "Length [mm]"))
        for language, said in (
            ("en", ('lang="en"', "Cut length", "63.5 mm is allowed.", "from the front")),
            ("de", ('lang="de"', "Schnittlänge", "erlaubt sind 63.5 mm.", "von vorn")),
            ("zh-CN", ('lang="zh-CN"', "下料长度", "允许 63.5 mm。", "前视")),
        ):
            for each in said:
                self.assertIn(each, pages[language])
        # Of the page itself nothing stays English; what the document says, does.
        texts = re.compile("<h[23]>([^<]*)<|<th[^>]*>([^<]+)<|<td>([^<]+)</td><td class")
        english = {text.strip() for found in texts.findall(pages["en"]) for text in found}
        self.assertGreater(len(english), 30)
        own = {"", *(obj.Label for obj in (self.cable, self.kind, self.start, self.end))}
        for language, same in (("de", {"Moment [N m]"}), ("zh-CN", set())):
            other = {text.strip() for found in texts.findall(pages[language]) for text in found}
            self.assertEqual((english & other) - own, same)

    def test_it_is_one_step_of_undo(self):
        self.make_cable()
        self.document.saveAs(os.path.join(self.folder, "a.FCStd"))
        steps = self.document.UndoCount
        self.run_report()
        self.assertEqual(self.document.UndoCount, steps + 1)
        self.document.undo()
        self.assertIsNone(self.document.getObject("CableReport"))

    def test_a_document_that_is_not_saved_asks_for_a_folder(self):
        self.make_cable()
        for answer in ("", self.folder):
            with mock.patch.object(
                QtGui.QFileDialog, "getExistingDirectory", return_value=answer
            ) as asked:
                self.run_report()
            asked.assert_called_once()
            self.assertEqual(self.opened.called, bool(answer))
        pages = [name for name in os.listdir(self.folder) if name.endswith(".html")]
        self.assertEqual(pages, ["Window-cables.html"])

    def test_a_folder_that_cannot_be_written_is_an_error_and_leaves_nothing(self):
        self.make_cable()
        blocked = os.path.join(self.folder, "file")
        Path(blocked).write_text("")
        with mock.patch.object(QtGui.QFileDialog, "getExistingDirectory", return_value=blocked):
            self.run_report()
        self.assertIsNone(self.document.getObject("CableReport"))
        self.assertFalse(self.opened.called)


class ExampleCommandTest(WindowTest):
    def test_it_opens_the_panel_with_ten_cables_also_without_matplotlib(self):
        before = set(FreeCAD.listDocuments())
        for name in [name for name in sys.modules if name.startswith("freecad_cable.demo")]:
            del sys.modules[name]
        # mock.patch.dict would forget what else is imported meanwhile, and the scene graph's module not bear that.
        known = {name: sys.modules.get(name) for name in MATPLOTLIB}
        sys.modules.update(dict.fromkeys(MATPLOTLIB))
        try:
            FreeCADGui.runCommand("Cable_Example")
        finally:
            for name, module in known.items():
                del sys.modules[name]
                if module:
                    sys.modules[name] = module
        (name,) = set(FreeCAD.listDocuments()) - before
        self.addCleanup(FreeCAD.closeDocument, name)
        document = FreeCAD.getDocument(name)
        solving.wait(document)
        cables = document.findObjects("Part::FeaturePython", "^Cable")
        self.assertEqual(len(cables), 10)
        for cable in cables:
            self.assertTrue(cable.isValid(), cable.Status)
            self.assertTrue(cable.Shape.isClosed())
        self.assertEqual(len({cable.ViewObject.ShapeColor for cable in cables}), 10)
        self.assertIs(FreeCAD.ActiveDocument, document)
        if "CABLE_PICTURES" in os.environ:
            FreeCADGui.activeView().saveImage(f"{os.environ['CABLE_PICTURES']}/example.png")
