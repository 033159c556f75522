# SPDX-License-Identifier: LGPL-2.1-or-later
"""A ring in a plate that is an obstacle itself: at the hole the ring is the contact, farther away the plate is."""

import numpy as np
import pytest

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


def test_the_rim_is_left_to_the_ring():
    """The cable leans on the rim, where it is nearer to the plate than its radius because it passes at an angle."""
    free = find_equilibrium(through(0.4, ())).raise_for_status()
    offset = np.linalg.norm(free.position[free.support_nodes[0]] - PLACE)
    assert offset == pytest.approx(HOLE - 0.0035, rel=1e-4)
    held = find_equilibrium(through(0.4, plate(THICKNESS))).raise_for_status()
    assert np.array_equal(held.position, free.position)


def test_farther_away_the_plate_is_in_the_way():
    """A block as deep as six radii: the cable has to go through its hole, and must not cut its far edge."""
    held = find_equilibrium(through(0.4, plate(0.02))).raise_for_status()
    assert held.contacts
    # One percent of the radius is left to enter.
    assert held.min_clearance > -0.01 * 0.0035
