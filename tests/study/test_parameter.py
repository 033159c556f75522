# SPDX-License-Identifier: LGPL-2.1-or-later
"""What of a scene can be varied, and what is said where it cannot."""

from dataclasses import replace

import numpy as np
import pytest
from scenes import table_1

from freecad_cable.errors import ProblemError
from freecad_cable.geometry import rotation
from freecad_cable.problem import Box, Clip, Free, Sphere, Swivel
from freecad_cable.study import Parameter


@pytest.fixture
def scene():
    clip = Clip([0.1, -0.1, 0.1], [1, 0, 0], arc_length=0.3, place="supports[0]")
    ball = Sphere([1, 0, 0], 0.1, place="obstacles[0]")
    box = Box([0, 1, 0], [1, 0, 0, 0], [0.1, 0.2, 0.3], place="obstacles[1]")
    return replace(table_1(), supports=(clip,), obstacles=(ball, box))


@pytest.mark.parametrize(
    ("parameter", "value", "read", "expected"),
    [
        ({"field": "cable.length"}, 0.9, lambda s: s.rod.length, 0.9),
        ({"field": "cable.length", "how": "add"}, 0.05, lambda s: s.rod.length, 0.78),
        (
            {"field": "cable.bending_stiffness"},
            2e-3,
            lambda s: s.rod.bending_stiffness,
            [2e-3, 2e-3],
        ),
        ({"field": "cable.axial_stiffness"}, 99.0, lambda s: s.rod.axial_stiffness, 99.0),
        (
            {"field": "cable.natural_curvature[2]"},
            3.0,
            lambda s: s.rod.natural_curvature,
            [0, 0, 3],
        ),
        ({"field": "clearance"}, 0.01, lambda s: s.clearance, 0.01),
        ({"field": "gravity[0]"}, 5.0, lambda s: s.gravity, [5, 0, -9.81]),
        ({"field": "gravity", "how": "scale"}, 0.5, lambda s: s.gravity, [0, 0, -4.905]),
        (
            {"field": "gravity", "how": "turn", "axis": [0, 1, 0]},
            np.pi / 2,
            lambda s: s.gravity,
            [-9.81, 0, 0],
        ),
        ({"field": "end.position[2]"}, 0.3, lambda s: s.end.position, [0.16, -0.235, 0.3]),
        ({"field": "supports[0].arc_length"}, 0.35, lambda s: s.supports[0].arc_length, 0.35),
        ({"field": "obstacles[0].radius", "how": "scale"}, 2, lambda s: s.obstacles[0].radius, 0.2),
        (
            {"field": "end", "how": "move", "axis": [0, 0, 2]},
            0.01,
            lambda s: s.end.position,
            [0.16, -0.235, 0.34],
        ),
        (
            {"field": "obstacles[0]", "how": "turn", "axis": [0, 0, 1], "point": [0, 0, 0]},
            np.pi / 2,
            lambda s: s.obstacles[0].center,
            [0, 1, 0],
        ),
        (
            {"field": "obstacles[1]", "how": "move", "axis": [0, 1, 0]},
            0.5,
            lambda s: s.obstacles[1].position,
            [0, 1.5, 0],
        ),
        (
            {"field": "supports[0]", "how": "turn", "axis": [0, 0, 1]},
            np.pi / 2,
            lambda s: s.supports[0].tangent,
            [0, 1, 0],
        ),
    ],
)
def test_what_is_changed(scene, parameter, value, read, expected):
    changed = Parameter(**parameter).of(scene, value)
    assert read(changed) == pytest.approx(expected, abs=1e-12)
    assert read(scene) is not read(changed)


def test_stiffness_scales_both_ways_of_bending_and_torsion(scene):
    changed = Parameter(field="cable.stiffness", how="scale").of(scene, 3.0)
    assert changed.rod.stiffness == pytest.approx(3 * scene.rod.stiffness)


def test_slack_is_measured_over_the_supports(scene):
    changed = Parameter(field="cable.slack").of(scene, 0.6)
    way = np.linalg.norm(scene.supports[0].position) + np.linalg.norm(
        scene.end.position - scene.supports[0].position
    )
    assert changed.rod.length == pytest.approx(1.6 * way)


def test_a_roll_turns_about_the_tangent(scene):
    changed = Parameter(field="end", how="turn", axis="d3").of(scene, 0.7)
    before, after = (rotation.matrix(s.end.quaternion) for s in (scene, changed))
    assert after[:, 2] == pytest.approx(before[:, 2])
    assert after[:, 0] @ before[:, 1] == pytest.approx(np.sin(0.7))
    assert changed.end.position == pytest.approx(scene.end.position)


def test_a_swivel_tilts_about_its_own_axes(scene):
    scene = replace(scene, end=Swivel(scene.end.position, [1, 0, 0]))
    for axis in ("d1", "d2"):
        changed = Parameter(field="end", how="turn", axis=axis).of(scene, 0.2)
        assert changed.end.tangent @ scene.end.tangent == pytest.approx(np.cos(0.2))


def test_a_path_of_places(scene):
    path = Parameter(
        field="end",
        how="path",
        positions=[[0.1, 0, 0], [0.2, 0, 0], [0.2, 0.1, 0]],
        quaternions=[[1, 0, 0, 0], [1, 0, 0, 0], [np.sqrt(0.5), 0, 0, np.sqrt(0.5)]],
    )
    there = path.of(scene, 0.25).end
    assert there.position == pytest.approx([0.125, 0, 0])
    half = path.of(scene, 1.5).end
    assert half.position == pytest.approx([0.2, 0.05, 0])
    assert rotation.matrix(half.quaternion)[:, 0] == pytest.approx([np.sqrt(0.5), np.sqrt(0.5), 0])
    assert path.of(scene, 2).end.position == pytest.approx([0.2, 0.1, 0])
    with pytest.raises(ProblemError, match="from 0 to 2"):
        path.of(scene, 2.1)


@pytest.mark.parametrize(
    ("parameter", "sentence"),
    [
        ({"field": "cable.lenght"}, "cable.lenght: is no place in this scene"),
        ({"field": "cable"}, "no number that could set"),
        ({"field": "cable.length[0]"}, "not in this scene: it has 0"),
        ({"field": "supports[1].arc_length"}, "not in this scene: it has 1"),
        ({"field": "gravity"}, r"is a vector; vary gravity\[0\]"),
        ({"field": "options.tolerance"}, "is no place"),
        ({"field": "end.place"}, "is no place"),
        ({"field": "enforce_bend_radius"}, "no number that could set"),
        ({"field": "cable.axial_stiffness", "how": "scale"}, "None, no number that could scale"),
        ({"field": "cable.stiffness"}, "cannot set; it can only scale"),
        ({"field": "cable.slack", "how": "add"}, "cannot add; it can only set"),
        ({"field": "gravity", "how": "move", "axis": [1, 0, 0]}, "is nothing that could move"),
        ({"field": "gravity", "how": "turn", "axis": "d3"}, "holds nothing"),
        ({"field": "start", "how": "move", "axis": [1, 0, 0]}, "is nothing that could move"),
        ({"field": "start", "how": "turn", "axis": "d1"}, "holds nothing"),
        ({"field": "obstacles[0]", "how": "turn", "axis": "d1"}, "holds nothing"),
        ({"field": "start", "how": "path", "positions": [[0, 0, 0], [1, 1, 1]]}, "holds nothing"),
        ({"field": "cable.length", "how": "grow"}, "must be one of set, add"),
        ({"field": "cable..length"}, "must be a place as cable.length"),
        ({"field": 7}, "must be a place as cable.length"),
        ({"field": "end", "how": "move"}, "must be a list of 3 numbers"),
        ({"field": "end", "how": "turn", "axis": [0, 0, 0]}, "gives no direction"),
        ({"field": "end", "how": "path", "positions": [[0, 0, 0]]}, "must have at least 2"),
        (
            {
                "field": "end",
                "how": "path",
                "positions": [[0, 0, 0]] * 2,
                "quaternions": [[1, 0, 0, 0]],
            },
            "must be 2 frames",
        ),
    ],
)
def test_what_cannot_be_varied(scene, parameter, sentence):
    scene = replace(scene, start=Free(place="start"))
    with pytest.raises(ProblemError, match=sentence):
        Parameter(**parameter).of(scene, 1.0)


def test_a_value_that_no_scene_has_is_named(scene):
    with pytest.raises(ProblemError, match="arc_length: is 0.3 m, which is not on the cable"):
        Parameter(field="cable.length").of(scene, 0.1)
    with pytest.raises(ProblemError, match="finite"):
        Parameter(field="cable.length").of(scene, float("nan"))
