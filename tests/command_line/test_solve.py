# SPDX-License-Identifier: LGPL-2.1-or-later
"""``python -m freecad_cable solve``: files in, files out, exit status."""

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from freecad_cable.__main__ import main

ROOT = Path(__file__).parents[2]


@pytest.fixture
def scene_file(tmp_path, data):
    def write(name="scene", **changes):
        path = tmp_path / f"{name}.json"
        path.write_text(json.dumps(data | changes))
        return path

    return write


def test_a_scene_is_solved(scene_file, tmp_path):
    target = tmp_path / "solution.json"
    command = [sys.executable, "-m", "freecad_cable", "solve", scene_file(), "-o", target]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    solution = json.loads(target.read_text())
    assert solution["status"] == "converged"
    nodes = {name: np.array(values) for name, values in solution["nodes"].items()}
    n = solution["solver"]["elements"]
    assert nodes["arc_length"].shape == (n + 1,)
    assert nodes["position"].shape == nodes["force"].shape == nodes["moment"].shape == (n + 1, 3)
    assert nodes["quaternion"].shape == (n + 1, 4)
    assert np.array(solution["curvature"]).shape == (n + 1, 3)
    assert nodes["arc_length"][-1] == pytest.approx(0.73)
    assert nodes["position"][-1] == pytest.approx([0.16, -0.235, 0.33], abs=1e-9)
    assert solution["stable"] is True
    assert solution["energy"]["total"] == pytest.approx(
        sum(solution["energy"][part] for part in ("bending", "torsion", "stretch", "gravity"))
    )
    assert set(solution["end_reaction"]) == {"force", "moment"}
    assert solution["min_bend_radius"]["value"] == pytest.approx(0.0508, rel=0.01)
    assert solution["error_estimate"]["position"] < 1e-4 * 0.73
    assert solution["model"]["kept"] and solution["model"]["left_out"]
    assert {"name", "scheme", "iterations", "build_time", "solve_time"} < set(solution["solver"])


def test_a_bend_that_is_too_sharp_is_said_and_is_no_failure(scene_file, tmp_path, data, capsys):
    """Table 1 bends to 50.8 mm."""
    target = tmp_path / "solution.json"
    for limit, said in ((0.05, ""), (0.06, "bends to 0.0508 m")):
        data["cable"]["min_bend_radius"] = limit
        assert main(["solve", str(scene_file()), "-o", str(target)]) == 0
        radius = json.loads(target.read_text())["min_bend_radius"]
        assert radius["margin"] == pytest.approx(radius["value"] - limit)
        error = capsys.readouterr().err
        assert said in error and bool(said) == bool(error)


def test_the_obstacle_that_is_too_near_is_named(scene_file, tmp_path, data, capsys):
    """A small face that two elements cannot follow."""
    data["cable"] |= {"length": 0.44, "radius": 0.002, "mass_per_length": 0.05}
    data["start"] = {"kind": "pinned", "position": [0, 0, 0]}
    data["end"] = {"kind": "pinned", "position": [0.4, 0, 0]}
    data["options"]["elements"] = 2
    far = {"kind": "sphere", "center": [0.2, 0, 0.1], "radius": 0.002}
    face = {
        "kind": "box",
        "position": [0.23, 0, -0.088],
        "quaternion": [1, 0, 0, 0],
        "size": [0.03, 0.1, 0.02],
    }
    target = tmp_path / "solution.json"
    assert main(["solve", str(scene_file(obstacles=[far, face])), "-o", str(target)]) == 3
    assert "At 0.236 m the cable is" in capsys.readouterr().err
    assert "nearer to obstacles[1] than" in json.loads(target.read_text())["message"]


def test_several_scenes_go_to_a_folder_and_the_worst_status_wins(scene_file, tmp_path, capsys):
    out = tmp_path / "out"
    good = [scene_file("a"), scene_file("b", gravity=[0, 0, 0])]
    bad = scene_file("c", gravity="down")
    assert main(["solve", *map(str, good), "--out-dir", str(out)]) == 0
    assert main(["solve", *map(str, [bad, *good]), "--out-dir", str(out)]) == 2
    assert sorted(p.name for p in out.iterdir()) == ["a.solution.json", "b.solution.json"]
    error = capsys.readouterr().err
    assert error.count("\n") == 1
    assert "gravity" in error and "down" in error


def test_not_solved_is_said_in_the_file_and_on_standard_error(scene_file, tmp_path, data, capsys):
    data["cable"]["length"] = float(np.linalg.norm(data["end"]["position"])) * (1 + 1e-9)
    target = tmp_path / "solution.json"
    assert main(["solve", str(scene_file()), "-o", str(target)]) == 3
    solution = json.loads(target.read_text())
    assert solution["status"] == "infeasible"
    assert solution["nodes"] is None
    assert solution["message"] in capsys.readouterr().err


@pytest.mark.parametrize("text", ["", "{", "[1, 2", '{"schema": 1}', "null", "[" * 100000])
def test_files_that_are_no_scene(tmp_path, text, capsys):
    path = tmp_path / "scene.json"
    path.write_text(text)
    assert main(["solve", str(path)]) == 2
    assert capsys.readouterr().err.count("\n") == 1


def test_a_file_that_is_not_there(tmp_path, capsys):
    assert main(["solve", str(tmp_path / "none.json")]) == 2
    assert "none.json" in capsys.readouterr().err
