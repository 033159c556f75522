# SPDX-License-Identifier: LGPL-2.1-or-later
"""What holds for every file: its size, its head, its name, its words."""

import os
import re
from pathlib import Path

import pytest

CHECKOUT = Path(__file__).resolve().parents[2]
MADE_HERE = {".git", ".packages", ".venv", "build", "demo-output", "__pycache__"}
LINES = 300
LICENCE = "# SPDX-License-Identifier: LGPL-2.1-or-later"
NAMELESS = {"utils", "util", "common", "helpers", "helper", "core", "misc", "tools"}
# Spelled in pieces, or this file would fail its own test.
HERE_ONLY = re.compile(r"(?<![\w.}])/(" + "|".join(("work", "tmp", "root", "home", "Users")) + ")/")
SPELLING = re.compile("center" + "line", re.IGNORECASE)


def _written_here(checkout):
    for folder, folders, files in os.walk(checkout):
        # Not even looked into: a whole Debian may lie there.
        folders[:] = sorted(
            {*folders} - MADE_HERE - {it for it in folders if it.endswith("_cache")}
        )
        yield from ((Path(folder) / file).relative_to(checkout) for file in sorted(files))


def complaints(checkout):
    """What is wrong with the files of a checkout, one sentence each."""
    for path in _written_here(checkout):
        yield from (f"{path}: {complaint}" for complaint in _complaints(checkout, path))


def _complaints(checkout, path):
    if {part.split(".")[0] for part in path.parts} & NAMELESS:
        yield "is named after nothing; name it after what lives in it"
    if path.parts[0] in ("tests", "benchmarks") and path.name == "__init__.py":
        yield "would make a module that every add-on of FreeCAD sees; remove it"
    try:
        text = (checkout / path).read_text(encoding="utf-8")
    except UnicodeDecodeError:
        return
    lines = text.splitlines()
    program = path.suffix == ".py" or path.name in ("run", "other_freecads")
    if program and len(lines) > LINES:
        yield f"has {len(lines)} lines; at most {LINES} belong in one file"
    if program and LICENCE not in lines[:2]:
        yield f"does not start with {LICENCE}"
    if path.name == "__init__.py" and not re.search('^"""', text, re.MULTILINE):
        yield "does not say what lives in its room"
    for number, line in enumerate(lines, 1):
        if HERE_ONLY.search(line):
            yield f"line {number} names a place on one machine"
        if SPELLING.search(line):
            yield f"line {number} spells centreline in American"


def test_every_file():
    assert len(list(_written_here(CHECKOUT))) > 20
    assert "\n".join(complaints(CHECKOUT)) == ""


@pytest.mark.parametrize(
    ("place", "text", "complaint"),
    [
        ("a.py", LICENCE + "\n" * LINES, None),
        ("a.py", LICENCE + "\n" * LINES + "x = 1\n", "has 301 lines"),
        ("run", "#!/bin/sh\n" + LICENCE, None),
        ("a.py", '"""No licence."""\n', "does not start with"),
        ("tests/utils.py", LICENCE, "is named after nothing"),
        ("freecad_cable/core/a.py", LICENCE, "is named after nothing"),
        ("tests/shape/__init__.py", LICENCE + '\n"""Room."""', "every add-on of FreeCAD sees"),
        ("room/__init__.py", LICENCE, "does not say what lives in its room"),
        ("a.md", "see " + "/ro" + "ot/notes.md", "line 1 names a place on one machine"),
        ("a.md", "the " + "Center" + "line of a cable", "spells centreline in American"),
        ("a.md", "the centreline; a path/to/home/x; https://example.org/home/", None),
    ],
)
def test_a_planted_fault_is_named(tmp_path, place, text, complaint):
    path = tmp_path / place
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")
    found = list(complaints(tmp_path))
    assert len(found) == (complaint is not None)
    assert all(complaint in sentence for sentence in found)
