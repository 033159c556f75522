# SPDX-License-Identifier: LGPL-2.1-or-later
"""The ten steps of docs/guide.md in the window give the numbers of the same steps without one."""

import json
import os
import re
import shutil
import subprocess
import tempfile
from pathlib import Path

import FreeCAD
from guide_steps import LENGTH, LIMIT, Hand
from window import WindowTest

GUIDE = Path(__file__).parents[2] / "docs/guide.md"

ALIKE = 1e-6
"""relative: the same scenes, solved from the same starts, by the same libraries."""


def without_a_window(folder):
    """The numbers that the headless program next to this one finds."""
    result = Path(folder) / "numbers.json"
    program = shutil.which("freecadcmd") or shutil.which("FreeCADCmd")
    lines = [
        "import json, sys",
        f"sys.path.append({str(Path(__file__).parent)!r})",
        "import guide_steps",
        f"json.dump(guide_steps.by_macro(), open({str(result)!r}, 'w'))",
    ]
    subprocess.run(
        [program, "-c", "\n".join(lines)],
        check=True,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        timeout=120,
        env=os.environ,
    )
    return json.loads(result.read_text(encoding="utf-8"))


class GuideTest(WindowTest):
    def test_the_window_and_the_macro_give_the_same_numbers(self):
        folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, folder)
        seen = []
        hand = Hand(seen.append, self.rest, folder)
        found = hand.do()
        self.addCleanup(lambda: FreeCAD.closeDocument(hand.document.Name))
        for name, number in without_a_window(folder).items():
            self.assertLess(abs(found[name] / number - 1), ALIKE, name)
        self.assertEqual(found["length"], LENGTH)
        self.assertGreater(found["radius"], LIMIT)
        for obj in hand.document.Objects:
            self.assertIn("Up-to-date", obj.State, f"{obj.Label}: {obj.getStatusString()}")
        self.assertTrue((Path(folder) / "guide-cables.html").exists())
        text = GUIDE.read_text(encoding="utf-8")
        self.assertEqual([text.count(f"guide/{name}.png") for name in seen], [1] * 10)
        (quoted,) = re.findall("“([^”]*)”", " ".join(text.split()))
        self.assertIn(quoted, hand.said)
        for name, format_ in (
            ("shortest", "{:.1f} mm"),
            ("radius", "{:.1f} mm"),
            ("route", "{:.1f} mm"),
            ("force", "{:.2f} N"),
        ):
            self.assertIn(format_.format(found[name]), text, name)
