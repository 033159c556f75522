# SPDX-License-Identifier: LGPL-2.1-or-later
"""A ring in a plate that is an obstacle itself: a cable that passes at an angle lies on the rims of the hole."""

import numpy as np
import pytest

from benchmarks.among import curve
from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.problem import Box, Clamped, Ring, Rod, Scene, Swivel

HOLE, THICKNESS = 0.01, 0.002
PLACE = np.array([0.06, 0.0, 0.07])


def through(length, obstacles):
    return Scene(
        rod=Rod(
            length=length,
            radius=0.0035,
            mass_per_length=0.0446,
            bending_stiffness=1.18e-3,
            torsional_stiffness=1.18e-3,
        ),
        start=Clamped([0, 0, 0], [1, 0, 0, 0], place="start"),
        end=Swivel([0.2, 0, 0], [0, 0, -1]),
        supports=(Ring(PLACE, [1, 0, 0], HOLE),),
        obstacles=obstacles,
    )


def plate(depth):
    """Four bars around a square hole as wide as the ring, from the ring's plane back."""
    bars = []
    for axis in (1, 2):
        for side in (-1, 1):
            centre = PLACE - [depth / 2, 0, 0]
            centre[axis] += side * (HOLE + 0.02)
            size = np.array([depth, 0.1, 0.1])
            size[axis] = 0.04
            bars.append(Box(centre, [1, 0, 0, 0], size))
    return tuple(bars)


@pytest.mark.parametrize("depth", [THICKNESS, 0.02])
def test_the_cable_does_not_cut_the_rims(depth):
    """Nearer to a rim than its radius it would be if only its section in the plane of the ring passed."""
    scene = through(0.4, plate(depth))
    held = find_equilibrium(scene).raise_for_status()
    assert held.contacts
    # One percent of the radius is left to enter; nodes and what is between them.
    places = curve(held)(np.linspace(0, scene.rod.length, 4001))
    gap = min(bar.nearest(places).distance.min() for bar in scene.obstacles) - 0.0035
    assert gap > -0.01 * 0.0035
    assert held.min_clearance == pytest.approx(gap, abs=0.01 * 0.0035)
