# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ctrl-C: what was solved until then is written, one sentence says so, and nothing goes on."""

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from freecad_cable.__main__ import main
from freecad_cable.study import cases

ROOT = Path(__file__).parents[2]
PATH = {"path": {"parameter": {"field": "cable.length"}, "from": 0.6, "to": 0.8, "count": 5000}}
# Some ten seconds, so that they do not come to their end before Ctrl-C.
CASES = {"tolerance": {"method": "random", "count": 1000, "seed": 4, "length": True}}


@pytest.fixture
def start(tmp_path, data):
    (tmp_path / "scene.json").write_text(json.dumps(data))

    def begin(*arguments):
        command = [sys.executable, "-m", "freecad_cable", *map(str, arguments)]
        return subprocess.Popen(
            command, cwd=ROOT, stderr=subprocess.PIPE, text=True, start_new_session=True
        )

    return begin


def said_after(program, send):
    """What it says after Ctrl-C; workers have standard error too, so its end is theirs."""
    send(program.pid, signal.SIGINT)
    said = program.communicate(timeout=60)[1].splitlines()
    assert program.returncode == 130, said
    return said


@pytest.mark.parametrize("send", [os.kill, os.killpg], ids=["program", "terminal"])
@pytest.mark.parametrize(("kind", "processes"), [(PATH, 1), (CASES, 1), (CASES, 2)])
def test_a_study(start, tmp_path, kind, processes, send):
    study, target = tmp_path / "study.json", tmp_path / "rows.json"
    study.write_text(json.dumps({"schema": 1, "scene": "scene.json"} | kind))
    program = start("study", study, "-o", target, "--processes", processes)
    first = program.stderr.readline()
    *progress, last = said_after(program, send)
    found = json.loads(target.read_text())
    count = len(found["rows"])
    total = first.split()[0].partition("/")[2]
    assert 1 <= count < int(total)
    assert last == f"{study}: stopped; {count} of {total} rows are written"
    assert all(f"/{total} " in line for line in progress)
    assert all(row["solved"] for row in found["rows"])
    if kind is CASES:
        assert found["summary"]["count"] == count
    else:
        assert found["summary"]["smallest_bend_radius"]


def test_a_study_that_has_no_row_yet(tmp_path, data, monkeypatch, capsys):
    def interrupted(scene, start=None, watch=None):
        signal.raise_signal(signal.SIGINT)
        watch("")

    monkeypatch.setattr(cases, "find_equilibrium", interrupted)
    handler = signal.getsignal(signal.SIGINT)
    study, target = tmp_path / "study.json", tmp_path / "rows.csv"
    study.write_text(json.dumps({"schema": 1, "scene": data} | CASES))
    target.write_text("of before")
    assert main(["study", str(study), "-o", str(target)]) == 130
    said = capsys.readouterr().err
    assert said == f"{study}: stopped before the first row; nothing is written\n"
    assert target.read_text() == "of before"
    assert signal.getsignal(signal.SIGINT) is handler


def test_scenes(start, tmp_path):
    program = start("solve", *[tmp_path / "scene.json"] * 1000, "--out-dir", tmp_path / "out")
    while not (tmp_path / "out" / "scene.solution.json").exists() and program.poll() is None:
        time.sleep(0.01)
    (said,) = said_after(program, os.kill)
    assert said == f"{tmp_path / 'scene.json'}: stopped before it was solved"
