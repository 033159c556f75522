# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cable led to its supports ends where it is found directly."""

from dataclasses import replace

import numpy as np
import pytest

from freecad_cable.geometry import rotation
from freecad_cable.problem import Clamp, Ring, Sleeve
from freecad_cable.problem.reduce import reduce
from freecad_cable.solve.leading import led
from freecad_cable.solve.problem import Problem
from freecad_cable.solve.search import find

ASIDE = np.array([0.03, -0.02, 0.01])
TURN = rotation.exponential([0.3, -0.2, 0.1])


def problem(scene):
    return Problem.of(scene, reduce(scene))


@pytest.mark.parametrize("slides", [False, True])
@pytest.mark.parametrize("kind", ["clamp", "sleeve", "ring"])
def test_a_cable_is_led_to_its_support(table_1, kind, slides):
    free = find(problem(table_1()))
    k = len(free.shape.steps) // 2
    place = 0.73 * free.shape.position[k] + ASIDE
    frame = rotation.multiply(TURN, free.shape.quaternion[k])
    more = {"arc_length": None if slides else 0.73 * free.shape.arc_length[k], "place": "held"}
    support = {
        "clamp": lambda: Clamp(place, frame, **more),
        "sleeve": lambda: Sleeve(place, rotation.tangent(frame), **more),
        "ring": lambda: Ring(place, rotation.tangent(frame), 0.006, **more),
    }[kind]()
    there = problem(replace(table_1(), supports=(support,)))
    (trial,) = led(there, free)
    direct = find(problem(there.scene))
    assert trial.stable
    # On a first mesh the energy is right to some 1e-5.
    assert trial.energy == pytest.approx(direct.energy, rel=1e-4)
    assert there.effort.iterations > 0
