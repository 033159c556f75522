# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the document says in English is read in German in a German window: panel, status bar, tree, report."""

import tempfile
from pathlib import Path
from unittest import mock

import FreeCAD
import FreeCADGui
from PySide import QtGui
from window import WindowTest

from freecad_cable.document import make, report
from freecad_cable.errors import DocumentError
from freecad_cable.gui.job import Job, in_words


class GermanTest(WindowTest):
    def setUp(self):
        super().setUp()
        self.addCleanup(FreeCADGui.setLocale, "en")
        FreeCADGui.setLocale("de")
        self.make_cable()

    def assertSaid(self, *parts):
        said = self.widget("Said", QtGui.QLabel)
        self.wait_for(lambda: all(part in said.text() for part in parts))

    def test_the_panel(self):
        self.kind.MinBendRadius = "200 mm"
        self.compute()
        self.open_panel(self.cable)
        length = self.widget("Length").toolTip()
        self.assertEqual(length, "Länge des unbelasteten Kabels")
        marked = self.widget("ShowContacts").toolTip()
        self.assertEqual(marked, "Markiert die Stellen, an denen Hindernisse das Kabel drücken")
        self.assertSaid("! Das Kabel ist im Gleichgewicht.", "Warnung: die engste Biegung, ")
        self.assertIn("Warning: the tightest bend, ", self.cable.Status)
        self.cable.Length = "100 mm"
        self.rest()
        self.assertSaid("✗ Cable, Length: ist 100 mm, aber die Anschlüsse sind 200 mm ausein")
        self.assertIn("but the terminals are 200 mm apart", self.cable.Status)
        self.cancel()

    def test_the_panel_of_what_is_wrong(self):
        self.end.Reference = None
        self.document.recompute()
        self.open_panel(self.end)
        self.assertSaid("ist leer: das Objekt wurde gelöscht oder nie gewählt.")
        self.cancel()

    def test_the_tree(self):
        self.cable.Length = "100 mm"
        self.document.recompute()
        self.assertIn("aber die Anschlüsse", self.cable.getStatusString())

    def test_a_job(self):
        job = Job(("Document", "Cable"), "", None)
        job.said = "0.3 m in 32 elements"
        self.assertRegex(in_words(job), r"^Löst: \d s, 300 mm in 32 Elementen$")

    def test_the_report_view(self):
        FreeCADGui.Selection.addSelection(self.document.Left, "Face2")
        bound = "it must be a finite number, at most 1e+30 deg in size"
        error = DocumentError(f"Terminal, Roll: is nan deg; {bound}.")
        said = []
        with (
            mock.patch.object(make, "terminal", side_effect=error),
            mock.patch.object(FreeCAD.Console, "PrintError", said.append),
        ):
            FreeCADGui.runCommand("Cable_Terminal")
        bound = "es muss eine endliche Zahl vom Betrag höchstens 1e+30 deg sein"
        self.assertIn(f"ist nan deg; {bound}.\n", said[-1])
        self.cable.SchemaVersion = 99
        with mock.patch.object(FreeCAD.Console, "PrintWarning", said.append):
            self.cable.Proxy.onDocumentRestored(self.cable)
        self.assertIn("Den Arbeitsbereich aktualisieren.\n", said[-1])

    def test_the_report(self):
        self.kind.MassPerLength = "4.46 kg/m"
        self.compute()
        with tempfile.TemporaryDirectory() as folder:
            report.write(self.document, folder)
            (page,) = (path.read_text("utf-8") for path in Path(folder).glob("*.html"))
        for said in ("Das Kabel ist im Gleichgewicht.", "Berücksichtigt: Biegung in zwei"):
            self.assertIn(said, page)
        self.assertIn(">Multi-core cable 7 mm: bei diesem Durchmesser bedeutet die Masse", page)
        self.assertIn("Durchmesser 7 mm", page)
        for said in ("The cable is in equilibrium", "Kept:", "Left out:", "Diameter 7", "means a"):
            self.assertNotIn(said, page)
