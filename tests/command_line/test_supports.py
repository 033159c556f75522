# SPDX-License-Identifier: LGPL-2.1-or-later
"""Supports in scene files: read, solved, and named when they are wrong."""

import json

import numpy as np
import pytest

from freecad_cable.__main__ import main
from freecad_cable.errors import ProblemError
from freecad_cable.problem.scene_file import read_scene

TANGENT = [0.52, -0.68, 0.52]
SUPPORTS = [
    {"kind": "clip", "position": [0.05, -0.23, -0.05], "tangent": TANGENT, "arc_length": 0.27},
    {"kind": "ring", "position": [0.12, -0.26, 0.12], "axis": [0.3, 0, 1], "radius": 0.01},
]
MORE = [
    {"kind": "sleeve", "position": [0.05, -0.23, -0.05], "tangent": TANGENT},
    {"kind": "clamp", "position": [0.12, -0.25, 0.12], "quaternion": [1, 0, 0, 0.1]},
]


@pytest.mark.parametrize("supports", [SUPPORTS, MORE])
def test_what_supports_exert_is_written(data, supports, tmp_path, capsys):
    path = tmp_path / "scene.json"
    path.write_text(json.dumps(data | {"supports": supports}))
    assert main(["solve", str(path)]) == 0
    solution = json.loads(capsys.readouterr().out)
    assert solution["status"] == "converged"
    loads = [solution["start_reaction"], *solution["support_reactions"], solution["end_reaction"]]
    assert len(loads) == 4
    weight = data["cable"]["mass_per_length"] * 9.81 * data["cable"]["length"]
    forces = np.sum([load["force"] for load in loads], axis=0)
    assert forces == pytest.approx([0, 0, weight], abs=1e-6)


def test_kinds_and_fields_are_read(data):
    read = read_scene(data | {"supports": SUPPORTS + MORE[1:]}).supports
    assert [support.kind for support in read] == ["clip", "ring", "clamp"]
    assert [support.slides for support in read] == [False, True, True]
    assert read[0].arc_length == 0.27
    assert read[1].radius == 0.01
    assert np.linalg.norm(read[1].axis) == pytest.approx(1, abs=1e-15)
    assert np.linalg.norm(read[2].quaternion) == pytest.approx(1, abs=1e-15)


@pytest.mark.parametrize(
    ("change", "field"),
    [
        ({"kind": "hook"}, "supports[1].kind"),
        ({"position": [0, 0]}, "supports[1].position"),
        ({"axis": "up"}, "supports[1].axis"),
        ({"radius": -1}, "supports[1].radius"),
        ({"radius": 0.001}, "supports[1].radius"),
        ({"arc_length": "half"}, "supports[1].arc_length"),
        ({"arc_length": 0.2}, "supports[1].arc_length"),
        ({"arc_length": 0.8}, "supports[1].arc_length"),
        ({"tangent": TANGENT}, "supports[1].tangent"),
        ({"position": [3, 0, 0]}, "supports[0].arc_length"),
    ],
)
def test_what_is_wrong_is_named(data, change, field, tmp_path, capsys):
    wrong = [SUPPORTS[0], SUPPORTS[1] | change]
    with pytest.raises(ProblemError) as caught:
        read_scene(data | {"supports": wrong})
    assert caught.value.field == field
    path = tmp_path / "scene.json"
    path.write_text(json.dumps(data | {"supports": wrong}))
    assert main(["solve", str(path)]) == 2
    assert field in capsys.readouterr().err


@pytest.mark.parametrize("value", [None, {}, "ring", [None], [[]], [{"position": [0, 0, 0]}]])
def test_a_list_that_is_none(data, value):
    with pytest.raises(ProblemError) as caught:
        read_scene(data | {"supports": value})
    assert caught.value.field.startswith("supports")
