# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD does with the add-on at every start, played in plain Python."""

import subprocess
import sys
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest

CHECKOUT = Path(__file__).resolve().parents[2]
MANIFEST = {"m": "https://wiki.freecad.org/Package_Metadata"}

# As FreeCAD's start-up does: execute the source, without __file__, with the root on the path.
START = """
import sys, types

stored = []
freecad = types.ModuleType("FreeCAD")
freecad.Version = lambda: [sys.argv[1], "0"]
freecad.ParamGet = lambda group: types.SimpleNamespace(
    SetString=lambda name, value: stored.append(value), SetBool=lambda name, value: None
)
sys.modules["FreeCAD"] = freecad
gui = types.ModuleType("FreeCADGui")
gui.Workbench = type("Workbench", (), {})
gui.addWorkbench = lambda workbench: print(type(workbench).__name__, workbench.Icon)
sys.modules["FreeCADGui"] = gui
sys.path.insert(0, ".")
for name in ("Init.py", "InitGui.py"):
    exec(compile(open(name).read(), name, "exec"), {})
print(*stored)
print(*sorted({name.split(".")[0] for name in sys.modules}))
"""


@pytest.mark.parametrize("version", ["0", "1"])
def test_starting_is_cheap_and_brings_one_workbench(version):
    command = [sys.executable, "-c", START, version]
    outcome = subprocess.run(command, cwd=CHECKOUT, capture_output=True, text=True, check=False)
    assert outcome.returncode == 0, outcome.stderr
    workbench, stored, modules = outcome.stdout.splitlines()
    assert workbench == f"CableWorkbench {CHECKOUT / 'resources/icons/cable_workbench.svg'}"
    assert not {"numpy", "scipy", "casadi", "matplotlib"} & set(modules.split())
    # FreeCAD has a library of materials from 1.0 on, and is told where ours are.
    assert all(Path(place).exists() for place in stored.split())
    assert len(stored.split()) == (3 if version == "1" else 0)


def test_the_manifest_names_what_is_there():
    manifest = ET.parse(CHECKOUT / "package.xml").getroot()
    for tag in ("name", "version", "date", "description", "license", "icon", "content"):
        assert manifest.find(f"m:{tag}", MANIFEST) is not None, tag
    workbench = manifest.find("m:content/m:workbench", MANIFEST)
    assert workbench.find("m:classname", MANIFEST).text == "CableWorkbench"
    assert (CHECKOUT / workbench.find("m:icon", MANIFEST).text).is_file()
    assert (CHECKOUT / manifest.find("m:license", MANIFEST).get("file")).is_file()
    assert manifest.find("m:freecadmin", MANIFEST).text == "0.20.2"
    assert manifest.find("m:pythonmin", MANIFEST).text == "3.11"
    needed = {d.text for d in manifest.findall("m:depend", MANIFEST) if d.get("type") == "python"}
    assert needed == {"casadi", "numpy", "scipy"}


def test_one_version():
    version = ET.parse(CHECKOUT / "package.xml").getroot().find("m:version", MANIFEST).text
    assert f'__version__ = "{version}"' in (CHECKOUT / "freecad_cable/__init__.py").read_text()
