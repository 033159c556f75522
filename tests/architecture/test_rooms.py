# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which room may import what. Data walks left to right, and a room looks only to its left."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

CHECKOUT = Path(__file__).resolve().parents[2]
PACKAGE = "freecad_cable"

ROOT = "errors status options"
STATEMENT = f"{ROOT} geometry problem"
CORE = f"{STATEMENT} result routes"

# room: (our own rooms it may import, names from outside besides the standard library)
TABLE = {
    "errors": ("", ""),
    "status": ("", ""),
    "options": ("errors", ""),
    "geometry": (ROOT, "numpy scipy"),
    "problem": (f"{ROOT} geometry", "numpy"),
    "transcription": (STATEMENT, "numpy scipy casadi"),
    "solve": (f"{STATEMENT} transcription", "numpy scipy casadi"),
    "result": (STATEMENT, "numpy scipy"),
    "routes": (f"{STATEMENT} result", "numpy scipy"),
    "reference": (f"{STATEMENT} result", "numpy scipy"),
    "equilibrium": (CORE, "numpy scipy"),
    "study": (f"{CORE} equilibrium", "numpy scipy"),
    "__main__": (f"{CORE} equilibrium study", ""),
    "shape": (CORE, "numpy FreeCAD MeshPart Part"),
    "document": (f"{CORE} equilibrium study shape", "numpy FreeCAD Part"),
    "demo": (f"{CORE} equilibrium study shape document", "numpy matplotlib FreeCAD Part Import"),
    "gui": (f"{CORE} study shape document", "FreeCAD FreeCADGui Part PySide pivy"),
    "Init.py": ("document", ""),
    "InitGui.py": ("gui", "FreeCADGui"),
}

# Only inside a function, so that a stored document opens without CasADi.
LATE = {"equilibrium": "transcription solve"}

WITHOUT_FREECAD = [room for room, (_, outside) in TABLE.items() if "FreeCAD" not in outside]
WITHOUT_CASADI = [r for r in WITHOUT_FREECAD if r not in ("transcription", "solve", "Init.py")]


def violations(checkout):
    """What the files of a checkout import against the table, one sentence each."""
    files = sorted((checkout / PACKAGE).rglob("*.py"))
    files += [checkout / name for name in ("Init.py", "InitGui.py")]
    return [line for path in files if path.exists() for line in _violations(checkout, path)]


def _violations(checkout, path):
    relative = path.relative_to(checkout)
    package = relative.parent.parts
    room = relative.parts[1].removesuffix(".py") if package else relative.name
    if room == "__init__":
        room = "errors"  # the package itself: as poor as the poorest room
    if room not in TABLE:
        yield f"{relative} is in no room of the table"
        return
    ours, outside = (names.split() for names in TABLE[room])
    late = LATE.get(room, "").split()
    tree = ast.parse(path.read_text(encoding="utf-8"))
    for line, name, inside in _imports(tree, package):
        parts = name.split(".")
        target = parts[1] if parts[0] == PACKAGE and len(parts) > 1 else parts[0]
        where = f"{relative} line {line} imports {name}"
        if parts[0] != PACKAGE:
            if target not in outside and target not in sys.stdlib_module_names:
                yield f"{where}: from outside, {room} may import {', '.join(outside) or 'nothing'}"
        elif target in late:
            if not inside:
                yield f"{where}: {room} may import {target} only inside a function"
        elif target in TABLE and target not in (room, *ours):
            yield f"{where}: of our rooms, {room} may import {', '.join(ours) or 'none'}"
        elif target not in (*TABLE, PACKAGE, "__version__"):
            yield f"{where}: {target} is no room of the table"


def _imports(node, package, inside=False):
    """(line, absolute dotted name, whether inside a function) of every import under a node."""
    for child in ast.iter_child_nodes(node):
        names = []
        if isinstance(child, ast.Import):
            names = [alias.name for alias in child.names]
        elif isinstance(child, ast.ImportFrom):
            above = package[: len(package) - child.level + 1] if child.level else ()
            base = ".".join((*above, *([child.module] if child.module else ())))
            names = [f"{base}.{alias.name}" for alias in child.names]
        elif isinstance(child, ast.Call) and child.args:
            called = getattr(child.func, "attr", getattr(child.func, "id", None))
            if called in ("import_module", "__import__"):
                names = [getattr(child.args[0], "value", "a computed name")]
        yield from ((child.lineno, name, inside) for name in names)
        function = isinstance(child, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda)
        yield from _imports(child, package, inside or function)


def test_every_import_looks_to_the_left():
    assert (CHECKOUT / PACKAGE / "equilibrium").is_dir()
    assert "\n".join(violations(CHECKOUT)) == ""


@pytest.mark.parametrize(
    ("place", "source", "sentence"),
    [
        ("problem/a.py", "import casadi as ca", "line 1 imports casadi: from outside, problem may"),
        ("result/a.py", "from ..solve import search", "imports freecad_cable.solve.search: of our"),
        (
            "result/a.py",
            "from .. import solve",
            "imports freecad_cable.solve: of our",
        ),
        ("geometry/a.py", "def f():\n    import FreeCAD", "line 2 imports FreeCAD: from outside"),
        ("document/a.py", "def f():\n    from PySide import QtGui", "imports PySide.QtGui"),
        ("document/a.py", "import FreeCADGui as Gui", "line 1 imports FreeCADGui"),
        ("document/views/a.py", "from ...gui import paths", "imports freecad_cable.gui.paths"),
        ("shape/a.py", "from freecad_cable.document import make", "imports freecad_cable.document"),
        (
            "problem/a.py",
            "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    import Part",
            "line 3 imports Part",
        ),
        ("routes/a.py", "try:\n    import casadi\nexcept ImportError:\n    pass", "line 2 imports"),
        ("routes/a.py", "import importlib\nimportlib.import_module('casadi')", "imports casadi"),
        ("equilibrium.py", "from .solve import search", "solve only inside a function"),
        ("errors.py", "from .options import SolveOptions", "may import none"),
        ("status.py", "import numpy", "status may import nothing"),
        ("__init__.py", "from .equilibrium import find_equilibrium", "may import none"),
        ("utils/a.py", "", "freecad_cable/utils/a.py is in no room"),
        ("gui/a.py", "from ..transcription.nlp import Nlp", "imports freecad_cable.transcription"),
        ("gui/a.py", "import numpy", "line 1 imports numpy"),
        ("gui/a.py", "from ..cables import x", "cables is no room of the table"),
        ("../InitGui.py", "import freecad_cable.document.make", "InitGui.py may import gui"),
        ("../Init.py", "import freecad_cable.shape", "Init.py may import document"),
    ],
)
def test_a_planted_violation_is_named(tmp_path, place, source, sentence):
    _plant(tmp_path, place, source)
    (found,) = violations(tmp_path)
    assert sentence in found


@pytest.mark.parametrize(
    ("place", "source"),
    [
        ("solve/a.py", "import casadi\nfrom ..transcription.nlp import Nlp\nfrom . import b"),
        ("equilibrium.py", "def f():\n    from .solve import search\n    return search"),
        ("document/a.py", "import json, FreeCAD\nfrom ..shape import units"),
        (
            "gui/views/a.py",
            "from PySide import QtGui\nfrom ...shape import a\nfrom .. import b",
        ),
        ("__main__.py", "from . import __version__\nfrom .problem.scene_file import read_scene"),
    ],
)
def test_what_is_allowed_is_not_named(tmp_path, place, source):
    _plant(tmp_path, place, source)
    assert violations(tmp_path) == []


def _plant(checkout, place, source):
    path = checkout / PACKAGE / place
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(source, encoding="utf-8")


IMPORT_ALL = """
import importlib, sys

class Absent:
    def find_spec(name, path=None, target=None):
        if name.split(".")[0] in sys.argv[1].split():
            raise ModuleNotFoundError(f"{name} is not installed", name=name)

sys.meta_path.insert(0, Absent)
for name in sys.argv[2:]:
    importlib.import_module(name)
"""


@pytest.mark.parametrize(
    ("absent", "rooms"),
    [
        ("FreeCAD FreeCADGui Part PySide matplotlib casadi", WITHOUT_CASADI),
        ("FreeCAD FreeCADGui Part PySide matplotlib", WITHOUT_FREECAD),
    ],
    ids=["without FreeCAD and CasADi", "without FreeCAD"],
)
def test_a_fresh_interpreter_imports_the_core(absent, rooms):
    paths = [path.relative_to(CHECKOUT) for path in (CHECKOUT / PACKAGE).rglob("*.py")]
    names = [path.with_suffix("").parts for path in paths]
    modules = [".".join(parts) for parts in names if parts[1] in rooms]
    assert "freecad_cable.equilibrium.find" in modules
    command = [sys.executable, "-c", IMPORT_ALL, absent, *modules]
    outcome = subprocess.run(command, cwd=CHECKOUT, capture_output=True, text=True, check=False)
    assert outcome.returncode == 0, outcome.stderr
