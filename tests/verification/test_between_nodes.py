# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contact between the nodes of a coarse mesh: without friction, and at the right place."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.interpolate import CubicHermiteSpline

from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.geometry import rotation
from freecad_cable.problem import Box
from tests.verification.test_contact_solids import ROUND, of_cylinder

ELEMENTS = 32
EDGE = Box([0.045, -0.22, -0.05], [1, 0, 0, 0], [0.1, 0.1, 0.1])
FACETS = of_cylinder(48)


def curve(solution):
    tangents = rotation.tangent(solution.quaternion)
    return CubicHermiteSpline(solution.arc_length, solution.position, tangents)


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
