# SPDX-License-Identifier: LGPL-2.1-or-later
"""``python -m freecad_cable study``: files in, rows out, exit status."""

import csv
import json
import subprocess
import sys
from pathlib import Path

import pytest

from freecad_cable.__main__ import main

ROOT = Path(__file__).parents[2]
LENGTH = {"field": "cable.length"}


@pytest.fixture
def study_file(tmp_path, data):
    (tmp_path / "scene.json").write_text(json.dumps(data))

    def write(**kind):
        path = tmp_path / "study.json"
        path.write_text(json.dumps({"schema": 1, "scene": "scene.json"} | kind))
        return str(path)

    return write


def test_a_path_becomes_a_table(study_file, tmp_path):
    study = study_file(path={"parameter": LENGTH, "values": [0.6, 0.7, 0.8]})
    target = tmp_path / "out" / "rows.csv"
    command = [sys.executable, "-m", "freecad_cable", "study", study, "-o", target]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stderr.splitlines()[0] == "1/3 cable.length = 0.6"
    rows = list(csv.DictReader(target.read_text().splitlines()))
    assert [float(row["cable.length"]) for row in rows] == [0.6, 0.7, 0.8]
    assert all(row["solved"] == "True" and float(row["end_force [N]"]) > 0 for row in rows)


def test_rows_and_summary_as_json(study_file, tmp_path):
    target = tmp_path / "rows.json"
    study = study_file(path={"parameter": LENGTH, "from": 0.6, "to": 0.8, "count": 3})
    assert main(["study", study, "-o", str(target)]) == 0
    found = json.loads(target.read_text())
    assert found["parameters"] == ["cable.length"]
    radii = {row["values"][0]: row["smallest_bend_radius"] for row in found["rows"]}
    assert tuple(found["summary"]["smallest_bend_radius"]) == min(
        radii.items(), key=lambda item: item[1]
    )


def test_a_tolerance_in_processes_has_the_same_rows(study_file, tmp_path):
    study = study_file(tolerance={"method": "random", "count": 20, "seed": 4, "length": True})
    found = []
    for processes in ("1", "2"):
        target = tmp_path / f"{processes}.json"
        assert main(["study", study, "-o", str(target), "--processes", processes]) == 0
        data = json.loads(target.read_text())
        for row in data["rows"]:
            del row["time"]
        found.append(data)
    assert found[0] == found[1]
    assert found[0]["summary"]["count"] == 20 and found[0]["summary"]["share"] == 1


def test_without_a_file_the_table_goes_to_standard_output(study_file, capsys):
    assert main(["study", study_file(path={"parameter": LENGTH, "values": [0.7]})]) == 0
    assert capsys.readouterr().out.startswith("cable.length,length [m],")


def test_a_value_that_cannot_be_solved_is_a_row_and_a_status(study_file, tmp_path, capsys):
    target = tmp_path / "rows.csv"
    study = study_file(path={"parameter": LENGTH, "values": [0.7, 0.1]})
    assert main(["study", study, "-o", str(target)]) == 3
    assert "1 of 2 are not solved" in capsys.readouterr().err.splitlines()[-1]
    rows = list(csv.DictReader(target.read_text().splitlines()))
    assert "apart" in rows[1]["error"]


@pytest.mark.parametrize(
    ("kind", "sentence"),
    [
        ({"path": {"parameter": {"field": "cable.lenght"}, "values": [1]}}, "cable.lenght"),
        ({"path": {"parameter": LENGTH, "values": []}}, "path.values"),
        ({}, "either path or tolerance"),
        ({"scene": "none.json", "path": {"parameter": LENGTH, "values": [1]}}, "cannot be read"),
        ({"scene": 3, "path": {"parameter": LENGTH, "values": [1]}}, "scene: is 3"),
    ],
)
def test_what_is_no_study_is_one_line(study_file, kind, sentence, capsys):
    assert main(["study", study_file(**kind)]) == 2
    said = capsys.readouterr().err
    assert said.count("\n") == 1
    assert sentence in said


def test_an_output_that_is_no_table(study_file, tmp_path, capsys):
    study = study_file(path={"parameter": LENGTH, "values": [0.7]})
    assert main(["study", study, "-o", str(tmp_path / "rows.xls")]) == 2
    assert "must end with .csv or .json" in capsys.readouterr().err
    with pytest.raises(SystemExit):
        main(["study", study, "--processes", "0"])
