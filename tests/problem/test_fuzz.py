# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scene files with anything in any place: each is read, or named wrong in one line."""

import copy
import json
import random

from freecad_cable.errors import ProblemError
from freecad_cable.problem.scene_file import read_scene

WHOLE = """
{"schema": 1, "gravity": [0, 0, -9.81], "clearance": 0.001,
 "cable": {"length": 0.9, "radius": 0.0035, "mass_per_length": 0.0446, "bending_stiffness": [1e-3, 2e-3],
           "torsional_stiffness": 4e-3, "axial_stiffness": 400, "shear_stiffness": null,
           "natural_curvature": [0, 0, 0], "min_bend_radius": 0.03, "bend_radius_mode": "enforce"},
 "start": {"kind": "clamped", "position": [0, 0, 0], "quaternion": [1, 0, 0, 0]},
 "end": {"kind": "swivel", "position": [0.3, -0.2, 0.3], "tangent": [0, 0, 1]},
 "supports": [{"kind": "ring", "position": [0, 0, 0.1], "axis": [0, 0, 1], "radius": 0.01, "arc_length": null},
              {"kind": "clip", "position": [0.1, 0, 0.2], "tangent": [1, 0, 0], "arc_length": 0.4},
              {"kind": "clamp", "position": [0.2, 0, 0.2], "quaternion": [1, 0, 0, 0], "arc_length": 0.5}],
 "obstacles": [{"kind": "half_space", "point": [0, 0, -1], "normal": [0, 0, 1]},
               {"kind": "sphere", "center": [3, 0, 0], "radius": 0.05},
               {"kind": "cylinder", "start": [3, 0, -1], "end": [3, 0, 1], "radius": 0.02},
               {"kind": "box", "position": [3, 0, 0], "quaternion": [1, 0, 0, 0], "size": [0.1, 0.1, 0.1]},
               {"kind": "mesh", "vertices": [[2, 0, 0], [3, 0, 0], [2, 1, 0], [2, 0, 1]],
                "triangles": [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]}],
 "options": {"tolerance": 1e-4, "solver": "auto", "scheme": "auto", "elements": null, "keep": ["stretch"]}}
"""
ANYTHING = (
    *(None, True, -1, 0, 1e400, float("nan"), 1e31, 1e-40, 10**30, "x", "ring", "\n"),
    *([], {}, [1, 2], [0, 0, 0], [[0]], [float("inf")] * 3, {"kind": "ring"}, [[0, 0, 0]] * 4),
)
TRIES = 4000


def test_anything_anywhere_is_read_or_named():
    chance = random.Random(5)
    whole = json.loads(WHOLE)
    places = [place for place in _places(whole) if place]
    read = 0
    for _ in range(TRIES):
        data = copy.deepcopy(whole)
        for _ in range(chance.choice((1, 1, 2))):
            _spoil(data, chance.choice(places), chance)
        try:
            read_scene(data)
        except ProblemError as error:
            assert error.field
            assert "\n" not in str(error)
            assert len(str(error)) < 600
        else:
            read += 1
    # Some of what is put in is right, so that not all of the tries end at the same check.
    assert 0.02 * TRIES < read < 0.5 * TRIES


def _places(data, here=()):
    yield here
    items = (
        data.items()
        if isinstance(data, dict)
        else enumerate(data if isinstance(data, list) else ())
    )
    for key, value in items:
        yield from _places(value, (*here, key))


def _spoil(data, place, chance):
    try:
        for key in place[:-1]:
            data = data[key]
        if chance.random() < 0.2:
            del data[place[-1]]
        else:
            data[place[-1]] = copy.deepcopy(chance.choice(ANYTHING))
    except (KeyError, IndexError, TypeError):
        pass  # the first change took the place of the second away
