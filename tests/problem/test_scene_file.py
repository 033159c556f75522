# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reading scene files: what is right is read, what is wrong is named."""

import math

import numpy as np
import pytest

from freecad_cable.errors import ProblemError
from freecad_cable.problem.scene_file import read_scene

NAN, INFINITE = float("nan"), float("inf")


def test_a_scene_is_read(data):
    scene = read_scene(data)
    assert scene.rod.length == 0.73
    assert scene.rod.bending_stiffness.tolist() == [1.18e-3, 1.18e-3]
    assert scene.start.kind == "clamped"
    assert np.linalg.norm(scene.start.quaternion) == pytest.approx(1, abs=1e-15)
    assert scene.weight.tolist() == pytest.approx([0, 0, -0.0446 * 9.81])


def test_what_may_be_left_out_has_its_default(data):
    for name in ("gravity", "supports", "obstacles", "clearance", "options"):
        del data[name]
    for name in ("axial_stiffness", "natural_curvature", "min_bend_radius"):
        del data["cable"][name]
    scene = read_scene(data)
    assert scene.gravity.tolist() == [0, 0, -9.81]
    assert scene.options.tolerance == 1e-4
    assert scene.rod.axial_stiffness is None


def test_length_by_slack(data):
    del data["cable"]["length"]
    data["cable"]["length_mode"] = {"kind": "slack", "value": 0.1}
    chord = math.dist(data["start"]["position"], data["end"]["position"])
    assert read_scene(data).rod.length == pytest.approx(1.1 * chord, rel=1e-15)


@pytest.mark.parametrize(
    ("path", "value", "field"),
    [
        ("schema", 2, "schema"),
        ("schema", True, "schema"),
        ("cable", [], "cable"),
        ("cable.length", 0, "cable.length"),
        ("cable.length", -1.0, "cable.length"),
        ("cable.length", NAN, "cable.length"),
        ("cable.length", INFINITE, "cable.length"),
        ("cable.length", "730 mm", "cable.length"),
        ("cable.length", True, "cable.length"),
        ("cable.length", None, "cable.length"),
        ("cable.length", 0.4, "cable.length"),
        ("cable.length", 10**400, "cable.length"),
        ("cable.radius", 0, "cable.radius"),
        ("cable.mass_per_length", -1e-9, "cable.mass_per_length"),
        ("cable.bending_stiffness", 0, "cable.bending_stiffness[0]"),
        ("cable.bending_stiffness", [1e-3, -1e-3], "cable.bending_stiffness[1]"),
        ("cable.bending_stiffness", [1e-3, 1e-3, 1e-3], "cable.bending_stiffness"),
        ("cable.bending_stiffness", None, "cable.bending_stiffness[0]"),
        ("cable.torsional_stiffness", 0, "cable.torsional_stiffness"),
        ("cable.axial_stiffness", 0, "cable.axial_stiffness"),
        ("cable.shear_stiffness", -5, "cable.shear_stiffness"),
        ("cable.natural_curvature", [0, 0], "cable.natural_curvature"),
        ("cable.natural_curvature", [0, NAN, 0], "cable.natural_curvature[1]"),
        ("cable.min_bend_radius", 0, "cable.min_bend_radius"),
        ("cable.colour", "red", "cable.colour"),
        ("start", None, "start"),
        ("start.kind", "fixed", "start.kind"),
        ("start.kind", [], "start.kind"),
        ("start.position", [0, 0], "start.position"),
        ("start.position", {"x": 0}, "start.position"),
        ("start.position", [0, 0, INFINITE], "start.position[2]"),
        ("start.quaternion", [0, 0, 0, 0], "start.quaternion"),
        ("end.quaternion", [1, 0, 0], "end.quaternion"),
        ("end", {"kind": "swivel", "position": [0, 0, 0], "tangent": [0, 0, 0]}, "end.tangent"),
        ("end", {"kind": "pinned"}, "end.position"),
        ("gravity", [0, 0], "gravity"),
        ("gravity", -9.81, "gravity"),
        ("clearance", -0.001, "clearance"),
        ("supports", {}, "supports"),
        ("supports", [{"kind": "hook"}], "supports[0].kind"),
        ("supports", [{"kind": "ring", "position": [0, 0, 0]}], "supports[0].axis"),
        ("obstacles", [3], "obstacles[0]"),
        ("obstacles", [{"kind": "sphere", "center": [0, 0, 0]}], "obstacles[0].radius"),
        ("options.tolerance", 0, "options.tolerance"),
        ("options.tolerance", 0.5, "options.tolerance"),
        ("options.tolerance", "fine", "options.tolerance"),
        ("options.solver", "snopt", "options.solver"),
        ("options.solver", ["fatrop"], "options.solver"),
        ("options.scheme", "cubic", "options.scheme"),
        ("options.elements", 1, "options.elements"),
        ("options.elements", 24.5, "options.elements"),
        ("options.elements", 10**9, "options.elements"),
        ("options.time_limit", -1, "options.time_limit"),
        ("colour", "red", "colour"),
    ],
)
def test_what_is_wrong_is_named(changed, path, value, field):
    with pytest.raises(ProblemError) as caught:
        read_scene(changed(path, value))
    assert caught.value.field == field
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("missing", ["schema", "cable", "start", "end"])
def test_a_missing_field_is_named(data, missing):
    del data[missing]
    with pytest.raises(ProblemError, match=f"{missing}: is missing"):
        read_scene(data)


def test_the_shortest_possible_length_is_said(changed):
    with pytest.raises(ProblemError, match=r"0\.4 m.*0\.435574 m apart.*shortest possible"):
        read_scene(changed("cable.length", 0.4))


def test_a_cable_that_stretches_may_be_shorter_than_its_chord(changed):
    data = changed("cable.length", 0.43)
    data["cable"]["axial_stiffness"] = 100.0
    assert read_scene(data).rod.length == 0.43


@pytest.mark.parametrize(
    ("start", "end", "gravity", "field"),
    [
        ({"kind": "free"}, {"kind": "free"}, [0, 0, -9.81], "end"),
        ({"kind": "pinned", "position": [0, 0, 0]}, {"kind": "free"}, [0, 0, 0], "start"),
        ({"kind": "free"}, {"kind": "pinned", "position": [0, 0, 0]}, [0, 0, 0], "end"),
    ],
)
def test_ends_that_hold_nothing(data, start, end, gravity, field):
    data.update(start=start, end=end, gravity=gravity)
    with pytest.raises(ProblemError) as caught:
        read_scene(data)
    assert caught.value.field == field
