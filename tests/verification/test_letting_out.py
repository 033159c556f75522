# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cables whose free shape crosses obstacles, found by letting out a short one that goes straight past them."""

from dataclasses import replace

import pytest

from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.problem import Box, Clamped, Free, Ring, Rod, Scene, Sleeve, Swivel
from freecad_cable.problem.reduce import reduce
from freecad_cable.solve.letting_out import let_out
from freecad_cable.solve.problem import Problem
from tests.verification.test_laying import assert_rests

PLATES = Scene(
    rod=Rod(
        length=0.652,
        radius=0.00341,
        mass_per_length=0.086,
        bending_stiffness=0.464,
        torsional_stiffness=0.242,
    ),
    start=Clamped([0, 0, 0], [0.771, -0.339, 0.505, -0.189]),
    end=Swivel([0.416, 0.333, 0.159], [0.299, 0.949, 0.0964]),
    gravity=[0, 0, -9.81],
    obstacles=(
        Box([0.185, 0.0233, 0.0715], [0.972, 0.225, 0.0607, 0.00509], [0.134, 0.109, 0.00341]),
        Box([0.355, 0.113, 0.137], [0.927, -0.0347, 0.37, -0.0611], [0.145, 0.00211, 0.157]),
    ),
)
BLOCK = Scene(
    rod=Rod(
        length=1.96,
        radius=0.00191,
        mass_per_length=0.024,
        bending_stiffness=0.000204,
        torsional_stiffness=0.000116,
    ),
    start=Swivel([0, 0, 0], [0.963, -0.0483, 0.267]),
    end=Clamped([1.42, 0.131, 0.134], [0.559, 0.0194, 0.828, -0.0378]),
    gravity=[0, 0, -9.81],
    obstacles=(
        Box([0.513, 0.0366, -0.432], [0.989, -0.0366, -0.0577, -0.127], [0.26, 0.241, 0.253]),
    ),
)


@pytest.mark.parametrize("scene", [PLATES, BLOCK], ids=["thin plates", "block under a long cable"])
def test_found(scene):
    assert_rests(find_equilibrium(scene).raise_for_status())


def test_a_free_end_that_a_shorter_cable_would_not_reach():
    """Between what holds it there is slack, but none beyond."""
    along = [0, 1, 0]
    scene = replace(
        PLATES,
        end=Free(),
        supports=(
            Sleeve([0, 0.2, 0], along, arc_length=0.25),
            Ring([0, 0.59, 0], along, radius=0.01),
        ),
    )
    assert let_out(Problem.of(scene, reduce(scene)), lambda *_: None) is None
