# SPDX-License-Identifier: LGPL-2.1-or-later
"""Heavy cables over edges and steps, which are laid there while they are light; and one that slides off the side."""

import numpy as np
import pytest
from scipy.optimize import brentq

from benchmarks.among import curve
from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.options import SolveOptions
from freecad_cable.problem import Box, Clamped, Rod, Scene

STRAIGHT = [1, 0, 0, 0]
TOP, HALF_WIDTH = -0.15, 0.05
TABLE = Box([0.4, 0, TOP - 0.15], STRAIGHT, [2 * HALF_WIDTH, 4, 0.3])
STEP = (
    Box([0.2, 0, -0.2], STRAIGHT, [0.4, 0.4, 0.1]),
    Box([0.6, 0, -0.25], STRAIGHT, [0.4, 0.4, 0.1]),
)


def laid(length, weight_ratio, obstacles):
    """Between two clamps 0.8 m apart, along +x."""
    stiffness, along = 1e-3, [0.5**0.5, 0, 0.5**0.5, 0]
    rod = Rod(
        length=length,
        radius=0.004,
        mass_per_length=weight_ratio * stiffness / length**3 / 9.81,
        bending_stiffness=stiffness,
        torsional_stiffness=0.8 * stiffness,
    )
    return find_equilibrium(
        Scene(
            rod=rod,
            start=Clamped([0, 0, 0], along),
            end=Clamped([0.8, 0, 0], along),
            gravity=[0, 0, -9.81],
            obstacles=obstacles,
            options=SolveOptions(time_limit=120),
        )
    ).raise_for_status()


def chain_lift(length, span, drop, weight):
    """Vertical force at the upper end of a chain [N]."""
    level = (length**2 - drop**2) ** 0.5
    half = brentq(lambda u: level * u - span * np.sinh(u), 1e-6, 20)
    return weight / 2 * (length + drop / np.tanh(half))


def assert_rests(solution):
    """Outside of all by samples of its own, and pushed as it pushes."""
    scene = solution.scene
    rod = scene.rod
    cable = curve(solution)(np.linspace(0, rod.length, 4001))
    cable = cable[np.linalg.norm(cable - scene.start.position, axis=1) > 3 * rod.radius]
    for each in scene.obstacles:
        assert each.nearest(cable).distance.min() > 0.99 * rod.radius
    ends = solution.start_reaction.force + solution.end_reaction.force
    pushed = sum((contact.force for contact in solution.contacts), np.zeros(3))
    weight = rod.mass_per_length * rod.length * scene.gravity
    assert np.linalg.norm(ends + pushed + weight) < 1e-3 * np.linalg.norm(weight)


def test_a_heavy_cable_lies_over_a_table_as_a_chain_does():
    solution = laid(1.0, 1e5, [TABLE])
    assert_rests(solution)
    weight = solution.scene.rod.mass_per_length * 9.81
    # A chain hangs from each clamp to an edge, round which the cable goes at a distance of its radius.
    radius = solution.scene.rod.radius
    hanging = 0.5 - HALF_WIDTH
    lift = chain_lift(hanging, 0.4 - HALF_WIDTH, -(TOP + radius), weight)
    pushed = sum(contact.force[2] for contact in solution.contacts)
    # Its layers of bending, of √(EI/T) = 0.006 m, are 3 % of the span of a hanging part.
    assert pushed == pytest.approx(weight - 2 * lift, rel=0.03)


@pytest.mark.parametrize(("length", "weight_ratio"), [(1.0, 5e3), (1.2, 200), (1.1, 60)])
def test_over_a_step(length, weight_ratio):
    solution = laid(length, weight_ratio, STEP)
    assert_rests(solution)
    assert solution.contacts
