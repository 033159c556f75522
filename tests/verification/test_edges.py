# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cable across the edge of a box, and one that a thin plate cuts: neither has a closed form."""

from dataclasses import replace

import numpy as np
import pytest

from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.options import SolveOptions
from freecad_cable.problem import Box, Clamped, Free, Rod, Scene


def unit(quaternion):
    return np.array(quaternion) / np.linalg.norm(quaternion)


def scene(stiffness, first, place, last, box):
    bend = {"bending_stiffness": stiffness, "torsional_stiffness": 2e-3}
    return Scene(
        rod=Rod(length=0.6, radius=0.004, mass_per_length=0.06, **bend),
        start=Clamped([0, 0, 0], unit(first), place="start"),
        end=Clamped(place, unit(last)),
        gravity=[0, 0, -9.81],
        obstacles=[box],
    )


ACROSS = scene(
    4e-3,
    [0.743, 0.253, 0.62, 0],
    [0.189, 0.481, 0.163],
    [0.681, 0.701, 0.213, 0],
    Box([0.105, 0.318, 0.085], unit([0.681, 0.317, -0.521, -0.405]), [0.09, 0.057, 0.078]),
)
CUT = scene(
    4e-4,
    [0.687, -0.192, 0.701, 0],
    [0.161, 0.247, -0.09],
    [0.762, 0.622, 0.18, 0],
    Box([0.093, 0.263, -0.242], unit([-0.185, 0.678, 0.665, -0.251]), [0.1, 0.1, 0.002]),
)


def test_a_cable_slides_along_an_edge_until_nothing_pushes_it_along(distance):
    solution = find_equilibrium(ACROSS).raise_for_status()
    options = SolveOptions(tolerance=1e-5)
    best = find_equilibrium(replace(ACROSS, options=options), start=solution)
    assert distance(solution, best) <= solution.position_error + best.position_error


def test_a_cable_that_a_plate_cuts_goes_around_it():
    solution = find_equilibrium(CUT).raise_for_status()
    (contact,) = solution.contacts
    assert np.linalg.norm(contact.force) > 1e-3
    assert solution.min_clearance == pytest.approx(0, abs=0.01 * CUT.rod.radius)


def test_the_place_is_found_where_an_edge_is_met_between_two_faces():
    """A bent cable that hangs against a box: beside the edge the gap falls steeply, beyond it next to nothing."""
    hanging = Scene(
        rod=Rod(
            length=0.83166,
            radius=0.0039146,
            mass_per_length=0.094682,
            bending_stiffness=0.0021128,
            torsional_stiffness=0.0017807,
            natural_curvature=[0.37183, -3.8683, 0.0],
        ),
        start=Clamped([0, 0, 0], unit([0.7895422, -0.1008436, 0.590796, -0.131961])),
        end=Free(),
        gravity=[0, 0, -9.81],
        obstacles=[
            Box(
                [0.10549122, -0.00583531, -0.38616471],
                [1, 0, 0, 0],
                [0.04278258, 0.10632122, 0.02800582],
            )
        ],
    )
    solution = find_equilibrium(hanging).raise_for_status()
    (contact,) = solution.contacts
    ends = solution.start_reaction.force + contact.force
    weight = hanging.rod.mass_per_length * hanging.rod.length * hanging.gravity
    assert np.linalg.norm(ends + weight) < 1e-3 * np.linalg.norm(weight)
