# SPDX-License-Identifier: LGPL-2.1-or-later
"""A scene file that is right, for tests that break it in one place; a plate with a round hole."""

import copy

import numpy as np
import pytest

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
    return _drilled


def _drilled(center, axis, radius, thickness, sides, size=3.0):
    """(vertices (n, 3), triangles (t, 3)) of a square plate, ``size`` radii from the middle of its hole to its sides.
    It lies from ``center`` along ``axis``; the hole has corners on its circle."""
    angle = np.linspace(0, 2 * np.pi, sides, endpoint=False)
    across = np.linalg.svd(np.array(axis)[None])[2][1:]
    if np.linalg.det([*across, axis]) < 0:
        across = across[::-1]
    circle = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    outline = size * circle / np.abs(circle).max(axis=1)[:, None]
    rings = [
        center + radius * ring @ across + height * np.array(axis)
        for height in (0.0, thickness)
        for ring in (circle, outline)
    ]
    triangles = []
    for i in range(sides):
        j = (i + 1) % sides
        for a, b in ((1, 0), (2, 3), (0, 2), (3, 1)):  # bottom, top, wall of the hole, outline
            a, b = a * sides, b * sides
            triangles += [(a + i, b + i, a + j), (b + i, b + j, a + j)]
    return np.concatenate(rings), np.array(triangles)
