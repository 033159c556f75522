# SPDX-License-Identifier: LGPL-2.1-or-later
"""A scene file that is right, for tests that break it in one place; a plate with a round hole."""

import copy

import pytest

from benchmarks.among import plate
from freecad_cable.problem import Ring

SCENE = {
    "schema": 1,
    "gravity": [0, 0, -9.81],
    "cable": {
        "length": 0.73,
        "radius": 0.0035,
        "mass_per_length": 0.0446,
        "bending_stiffness": 1.18e-3,
        "torsional_stiffness": 4.71e-3,
        "axial_stiffness": None,
        "shear_stiffness": None,
        "natural_curvature": [0, 0, 0],
        "min_bend_radius": None,
    },
    "start": {"kind": "clamped", "position": [0, 0, 0], "quaternion": [0.7071, 0.7071, 0, 0]},
    "end": {
        "kind": "clamped",
        "position": [0.16, -0.235, 0.33],
        "quaternion": [0.5, 0.5, 0.5, 0.5],
    },
    "supports": [],
    "obstacles": [],
    "clearance": 0.0,
    "options": {"tolerance": 1e-4, "solver": "auto", "scheme": "auto", "elements": None},
}


@pytest.fixture
def data():
    return copy.deepcopy(SCENE)


@pytest.fixture
def changed(data):
    """The scene with the value at ``cable.length`` or the like replaced."""

    def change(path, value):
        place = data
        *parents, name = path.split(".")
        for parent in parents:
            place = place[parent]
        place[name] = value
        return data

    return change


@pytest.fixture
def drilled():
    """(vertices (n, 3), triangles (t, 3)) of a square plate that lies from ``center`` along ``axis`` and has a hole
    there with corners on its circle; its sides are three radii from the axis."""

    def build(center, axis, radius, thickness, corners):
        return plate(Ring(center, axis, radius), 3 * radius, (0.0, thickness), corners)

    return build
