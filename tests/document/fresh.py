# SPDX-License-Identifier: LGPL-2.1-or-later
"""A file opened, recomputed and edited in a process of its own, where CasADi is not there."""

import json
import os
import shutil
import subprocess
from pathlib import Path

import freecad_cable

READER = Path(__file__).with_name("reader.py")


def in_a_fresh_process(path, folder):
    """What ``reader.observe`` sees in the file ``path``; ``folder`` is for its answer."""
    program = shutil.which("freecadcmd") or shutil.which("FreeCADCmd")
    result = Path(folder) / "seen.json"
    root = str(Path(freecad_cable.__file__).parents[1])
    environment = os.environ | {
        "CABLE_FILE": str(path),
        "CABLE_SEEN": str(result),
        "PYTHONPATH": os.pathsep.join([root, os.environ.get("PYTHONPATH", "")]),
    }
    code = f"exec(compile(open({str(READER)!r}).read(), 'reader.py', 'exec'))"
    ran = subprocess.run(
        [program, "-c", f"{code}\nimport os\nos._exit(0)"],
        env=environment,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )
    assert result.exists(), ran.stdout + ran.stderr
    return json.loads(result.read_text(encoding="utf-8"))
