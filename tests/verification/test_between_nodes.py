# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contact between the nodes of a coarse mesh: without friction, and at the right place."""

from dataclasses import replace

import numpy as np
import pytest

from benchmarks.among import curve
from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.options import SolveOptions
from freecad_cable.problem import Box, Pinned, Rod, Scene, Sphere
from tests.verification.test_contact_solids import ROUND, of_cylinder

ELEMENTS = 32
EDGE = Box([0.045, -0.22, -0.05], [1, 0, 0, 0], [0.1, 0.1, 0.1])
FACETS = of_cylinder(48)


@pytest.fixture(scope="module")
def exact():
    return {}


@pytest.fixture
def find(table_1, exact):
    """(solution on few elements that gather nowhere, exact one) with an obstacle, from the exact one."""

    def both(name, obstacle):
        if name not in exact:
            scene = replace(table_1(0.73, tolerance=1e-6), obstacles=(obstacle,))
            exact[name] = find_equilibrium(scene).raise_for_status()
        best = exact[name]
        coarse = replace(best.scene, options=replace(best.scene.options, elements=ELEMENTS))
        return find_equilibrium(coarse).raise_for_status(), best

    return both


@pytest.mark.parametrize("name", ROUND)
def test_the_place_and_the_shape(find, name):
    coarse, best = find(name, ROUND[name])
    assert len(coarse.contacts) == len(best.contacts) == 1
    rod = best.scene.rod
    h = rod.length / ELEMENTS
    # The force bends the element that it is on twice, a linear curvature only once: what that misses is no more than
    # the deflection of a beam of one element, held at its ends.
    force = np.linalg.norm(best.contacts[0].force)
    missed = force * h**3 / (12 * rod.bending_stiffness[0])
    away = np.linalg.norm(curve(best)(coarse.arc_length) - coarse.position, axis=1).max()
    assert away < missed + best.position_error


@pytest.mark.parametrize("name", [*ROUND, "edge", "facets"])
def test_nothing_pushes_along_the_cable(find, name):
    obstacle = {**ROUND, "edge": EDGE, "facets": FACETS}[name]
    coarse, _ = find(name, obstacle)
    for contact in coarse.contacts:
        slope = curve(coarse)(contact.arc_length, 1)
        along = contact.force @ slope / np.linalg.norm(slope) / np.linalg.norm(contact.force)
        # A tangent of a cubic through nodes whose curvature has a kink between them, F h/EI, turns by h²/16 of it.
        h = coarse.scene.rod.length / ELEMENTS
        kink = np.linalg.norm(contact.force) / coarse.scene.rod.bending_stiffness[0]
        assert abs(along) < kink * h**2 / 8


@pytest.mark.parametrize("name", [*ROUND, "edge"])
def test_the_error_on_a_mesh_that_is_given(find, name):
    coarse, best = find(name, {**ROUND, "edge": EDGE}[name])
    away = np.linalg.norm(curve(best)(coarse.arc_length) - coarse.position, axis=1).max()
    print(name, away, coarse.position_error, best.position_error)
    assert away <= coarse.position_error + best.position_error
    assert coarse.position_error < 20 * away
    again = find_equilibrium(coarse.scene, start=coarse).raise_for_status()
    assert len(again.arc_length) == len(coarse.arc_length)


@pytest.mark.parametrize("ball", [1.0, 3.0])
@pytest.mark.parametrize("share", [0.25, 0.5])
def test_a_thin_wire_does_not_pass_through_a_pin(ball, share):
    """One as thin as it is itself, 1/500 of an element, wherever between samples."""
    radius = 1e-4
    rod = Rod(
        length=0.44,
        radius=radius,
        mass_per_length=0.05,
        bending_stiffness=1.18e-3,
        torsional_stiffness=1e-3,
    )
    free = Scene(
        rod=rod,
        start=Pinned([0, 0, 0]),
        end=Pinned([0.4, 0, 0]),
        gravity=[0, 0, -9.81],
        options=SolveOptions(elements=8),
    )
    below = curve(find_equilibrium(free))(rod.length / 8 * (3 + (20 + share) / 64))
    pin = Sphere(below - [0, 0, ball * radius / 2], ball * radius)
    held = find_equilibrium(replace(free, obstacles=(pin,)))
    assert held.contacts
    along = curve(held)(np.linspace(0, rod.length, 1_000_001))
    clear = np.linalg.norm(along - pin.center, axis=1).min() - pin.radius - radius
    assert clear > -0.01 * radius
    # It is sampled at 1/1024 of an element; between two samples a ball is nearer by an eighth of that squared, over the
    # distance of its centre.
    apart = rod.length / 8 / 1024
    missed = apart**2 / 8 / (pin.radius + radius)
    assert held.min_clearance == pytest.approx(clear, abs=missed)
