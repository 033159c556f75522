# SPDX-License-Identifier: LGPL-2.1-or-later
"""The study file: what it reads and what it refuses, in a sentence."""

import copy
import json
from pathlib import Path

import numpy as np
import pytest

from freecad_cable.errors import ProblemError
from freecad_cable.study.study_file import PathStudy, ToleranceStudy, read_study

DOCS = Path(__file__).parents[2] / "docs"


@pytest.fixture
def path(data):
    parameter = {"field": "cable.length"}
    return {"schema": 1, "scene": data, "path": {"parameter": parameter, "values": [0.6, 0.7]}}


@pytest.fixture
def tolerance(data):
    return {
        "schema": 1,
        "scene": data,
        "tolerance": {
            "method": "random",
            "count": 10,
            "seed": 1,
            "length": True,
            "held": [{"field": "end", "distance": 0.001, "angle": 0.02}],
            "variations": [
                {
                    "parameter": {"field": "cable.stiffness", "how": "scale"},
                    "low": 0.5,
                    "high": 2,
                    "spread": "log",
                }
            ],
        },
    }


def no_file(name):
    raise AssertionError(name)


def test_a_path(path):
    study = read_study(path, no_file)
    assert isinstance(study, PathStudy)
    assert study.values == (0.6, 0.7)
    assert study.scene_at(0.7).rod.length == 0.7
    del path["path"]["values"]
    path["path"] |= {"from": 0.5, "to": 0.9, "count": 5}
    assert read_study(path, no_file).values == pytest.approx(np.linspace(0.5, 0.9, 5))


def test_a_tolerance(tolerance):
    study = read_study(tolerance, no_file)
    assert isinstance(study, ToleranceStudy)
    assert len(study.names) == len(set(study.names)) == 1 + 3 + 3 + 1
    assert study.cases.count == 10
    tolerance["tolerance"] = {
        "method": "corners",
        "length": True,
    }
    assert read_study(tolerance, no_file).cases.count == 2


@pytest.mark.parametrize("name", ["count", "seed"])
def test_corners_are_all_there_are(tolerance, name):
    tolerance["tolerance"] = {"method": "corners", "length": True, name: 3}
    with pytest.raises(ProblemError, match=f"tolerance.{name}: is given beside corners"):
        read_study(tolerance, no_file)


def test_a_scene_in_a_file_of_its_own(path):
    scene = path.pop("scene")
    study = read_study(path | {"scene": "other.json"}, {"other.json": scene}.__getitem__)
    assert study.scene.rod.length == 0.73


@pytest.mark.parametrize("name", ["study.json", "tolerance.json"])
def test_the_documented_files(name):
    load = lambda name: json.loads((DOCS / name).read_text())  # noqa: E731
    read_study(load(name), load)


def change(data, place, value):
    data = copy.deepcopy(data)
    inside = data
    *parents, last = place.split(".")
    for parent in parents:
        inside = inside[int(parent) if parent.isdecimal() else parent]
    if value is None:
        del inside[last]
    else:
        inside[last] = value
    return data


@pytest.mark.parametrize(
    ("place", "value", "sentence"),
    [
        ("schema", 2, "schema: is 2"),
        ("colour", 1, "colour: is not known"),
        ("scene", None, "scene: is missing"),
        ("scene.cable.radius", -1, "cable.radius: is -1"),
        ("path", None, "study: must have either path or tolerance"),
        ("tolerance", {}, "study: must have either path or tolerance"),
        ("path.parameter", None, "path.parameter: is missing"),
        ("path.parameter.field", "cable.lenght", "cable.lenght: is no place"),
        ("path.parameter.field", "supports[0].arc_length", "not in this scene"),
        ("path.parameter.speed", 1, "path.parameter.speed: is not known"),
        ("path.values", [], "path.values: is"),
        ("path.values", [0.5, "x"], r"path.values\[1\]: is 'x'"),
        ("path.values", None, "path.from: is missing"),
        ("path.from", 0.6, "path.from: is given beside values; give from, to and count, or values"),
        ("path.to", "x", "path.to: is given beside values"),
        ("path.count", 3, "path.count: is given beside values"),
        ("path.precision", 0, "path.precision: is 0"),
        ("path.needed_length", 1, "must be true or false"),
    ],
)
def test_what_is_no_path(path, place, value, sentence):
    with pytest.raises(ProblemError, match=sentence):
        read_study(change(path, place, value), no_file)


@pytest.mark.parametrize(
    ("last", "sentence"),
    [
        (0.6, "path.to: is 0.6 and so is from; give a range, or values"),
        (1e999, "path.to: is inf"),
    ],
)
def test_what_is_no_range(path, last, sentence):
    del path["path"]["values"]
    path["path"] |= {"from": 0.6, "to": last, "count": 3}
    with pytest.raises(ProblemError, match=sentence):
        read_study(path, no_file)


@pytest.mark.parametrize(
    ("place", "value", "sentence"),
    [
        ("tolerance.method", "all", "must be random or corners"),
        ("tolerance.variations.0.parameter.how", "turn", "parameter.axis: is None"),
        ("tolerance.seed", None, "tolerance.seed: is missing"),
        ("tolerance.count", 0, "tolerance.count: is 0"),
        ("tolerance.held.0.field", "gravity", "holds nothing"),
        ("tolerance.held.0.distance", -1, r"held\[0\].distance"),
        ("tolerance.held", {}, "must be a list"),
        ("tolerance.variations.0.low", 3, "must be at least low"),
        ("tolerance.variations.0.parameter.how", "add", "it can only scale"),
    ],
)
def test_what_is_no_tolerance(tolerance, place, value, sentence):
    with pytest.raises(ProblemError, match=sentence):
        read_study(change(tolerance, place, value), no_file)
