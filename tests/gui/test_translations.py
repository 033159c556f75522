# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whatever a person reads in the window stands in German and in Chinese, and FreeCAD finds it."""

import re
import runpy
import string
import unittest
from pathlib import Path
from unittest import mock

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from freecad_cable.document import make
from freecad_cable.gui.language import install

FOLDER = Path(__file__).resolve().parents[2] / "resources" / "translations"

UPDATE = runpy.run_path(str(FOLDER / "update.py"))

LANGUAGE = "en"
"""The text that names the language of a page."""

CHINESE = re.compile("[\u3000-\u303f\u4e00-\u9fff\uff00-\uffef]")


def fields(text):
    """What stands in braces and is filled in."""
    return sorted(name for _, name, _, _ in string.Formatter().parse(text) if name)


class TranslationTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        FreeCADGui.activateWorkbench("CableWorkbench")
        cls.strings = UPDATE["source_strings"]()

    def test_what_is_read_is_found(self):
        contexts = {context for context, _ in self.strings}
        expected = {"App::Property", "Cable", "CablePreferences", "CableReport", "Cable_Report"}
        self.assertLessEqual(expected | {"Workbench"}, contexts)
        self.assertIn(("App::Property", "Bending stiffness EI"), self.strings)
        self.assertIn(("Cable", "Solve Now"), self.strings)
        self.assertIn(("CablePreferences", "Terminals hold"), self.strings)

    def test_everything_is_translated_and_nothing_else(self):
        for language in UPDATE["LANGUAGES"]:
            known = UPDATE["translations"](FOLDER / f"Cable_{language}.ts")
            missing = sorted(set(self.strings) - set(known))
            self.assertEqual(missing, [], f"{language}: ./run translations lists them")
            self.assertEqual(sorted(set(known) - set(self.strings)), [], language)
            for (_, text), translation in known.items():
                self.assertEqual(fields(text), fields(translation), translation)
                if text == LANGUAGE:
                    self.assertEqual(translation, language)
                elif language == "zh-CN":
                    self.assertRegex(translation, CHINESE)

    def test_freecad_gets_what_the_table_says(self):
        for language in UPDATE["LANGUAGES"]:
            path = FOLDER / f"Cable_{language}.ts"
            translator = QtCore.QTranslator()
            self.assertTrue(translator.load(str(path.with_suffix(".qm"))))
            for (context, text), translation in UPDATE["translations"](path).items():
                self.assertEqual(translator.translate(context, text), translation)

    def test_whoever_opens_a_document_need_not_use_the_workbench(self):
        document = FreeCAD.newDocument()
        self.addCleanup(FreeCAD.closeDocument, document.Name)
        install.cache_clear()
        with (
            mock.patch.object(FreeCADGui, "addLanguagePath") as added,
            mock.patch.object(FreeCADGui, "updateLocale") as updated,
        ):
            for _ in range(2):
                make.cable_type(document, "Some cable")
        (place,) = (call.args[0] for call in added.call_args_list)
        self.assertEqual(Path(place).resolve(), FOLDER)
        updated.assert_called_once()

    def test_the_window_speaks_it(self):
        self.addCleanup(FreeCADGui.setLocale, "en")
        for language, expected in (
            ("de", ("Jetzt lösen", "Bericht")),
            ("zh-CN", ("立即求解", "报告")),
            ("en", ("Solve Now", "Report")),
        ):
            FreeCADGui.setLocale(language)
            QtGui.QApplication.processEvents()
            said = FreeCAD.Qt.translate("Cable", "Solve Now")
            title = FreeCADGui.Command.get("Cable_Report").getAction()[0].text()
            self.assertEqual((said, title.replace("&", "")), expected)
