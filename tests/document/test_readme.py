# SPDX-License-Identifier: LGPL-2.1-or-later
"""The macros of the README, run on parts with the names that they use."""

import contextlib
import io
import re
from pathlib import Path

from scenes import TOP, DocumentTest

README = Path(__file__).resolve().parents[2] / "README.md"


class ReadmeTest(DocumentTest):
    def test_the_macros_do_what_they_say(self):
        plate, hole = self.plate("Plate", (60, 0, 70), (1, 0, 0))
        bracket, circle = self.plate("Bracket", (100, 0, 90), (1, 0, 0))
        names = {
            "doc": self.doc,
            "connector": self.pin("Left", (0, 0, 0)),
            "other": self.pin("Right", (200, 0, 0)),
            "plate": plate,
            "bracket": bracket,
            "panel": self.pin("Panel", (160, 0, 40)),
        }
        self.doc.recompute()
        edges = {"Edge7": TOP, "Face2": TOP, "Edge15": hole, "Edge3": circle}
        macros = re.findall(r"```python\n(.*?)```", README.read_text(encoding="utf-8"), re.DOTALL)
        self.assertEqual(len(macros), 3)
        printed = io.StringIO()
        for macro in macros:
            macro = re.sub("|".join(edges), lambda found: edges[found.group()], macro)
            with contextlib.redirect_stdout(printed):
                exec(macro, names)
            cable = names["cable"]
            self.assertTrue(cable.isValid(), cable.Status)
        self.assertEqual(len(names["study"].DrawnValues), 9)
        self.assertEqual(names["within"].Status, "")
        self.assertGreater(cable.SolvedLength.Value, 200)
        self.assertLess(cable.SolvedLength.Value, 400)
        self.assertEqual(len(cable.SupportForces), 2)
        self.assertTrue(any(row.cable == cable.Label for row in names["rows"]))
