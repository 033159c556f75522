# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the tests of studies start from."""

import re

from scenes import DocumentTest

from freecad_cable.document import make, studying


def state(document):
    """What a user could see change: every property that can be read as text, and whether it is to be recomputed."""
    found = {}
    for obj in document.Objects:
        if obj.Name.startswith("Study"):
            continue
        found[obj.Name] = tuple(obj.State), tuple(obj.ExpressionEngine)
        for name in obj.PropertiesList:
            if name in ("Shape", "Proxy", "ExpressionEngine", "cells"):
                continue
            # Without addresses, which FreeCAD 1.0 and later write into some.
            found[obj.Name, name] = re.sub(r"0x[0-9a-f]+", "", repr(getattr(obj, name)))
        if hasattr(obj, "Shape"):
            found[obj.Name, "Volume"] = obj.Shape.Volume, obj.Shape.Length
        if obj.TypeId == "Spreadsheet::Sheet":
            found[obj.Name, "cells"] = {
                cell: obj.getContents(cell) for cell in ("A1", "A2", "B1") if obj.getContents(cell)
            }
    return found


class StudyTest(DocumentTest):
    def setUp(self):
        super().setUp()
        self.cable_between_pins(length="300 mm")
        self.compute()

    def study(self, *varied, **arguments):
        made = make.study(
            self.doc, self.cable, **({"varied": varied} if len(varied) > 1 else {}) | arguments
        )
        return made

    def run_unchanged(self, study):
        before = state(self.doc)
        studying.run(study)
        self.assertEqual(state(self.doc), before)
        return study

    def column(self, study, head):
        sheet = study.Sheet
        for letter in "ABCDEFGHIJKLMNOPQRSTUVWXYZ":
            if head in str(sheet.getContents(f"{letter}1")):
                contents = (sheet.getContents(f"{letter}{k}") for k in range(2, 200))
                return [text.lstrip("'=") for text in contents if text]
        raise AssertionError(head)
