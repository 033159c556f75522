# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rings in triangulated plates with round holes: the cable keeps clear of the plates, and the ring says no more."""

import numpy as np
import pytest

from benchmarks.among import curve
from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.options import SolveOptions
from freecad_cable.problem import Mesh, Ring, Rod, Scene, Swivel

RADIUS = 0.0035
LEFT_OUT = 0.01 + 1 / 128
"""Depth, in radii of the cable, that is left between nodes, and what an edge may enter between two samples."""


def gap(solution):
    """Of the cable's surface to the plates, in its radii, at places a fortieth of a radius apart."""
    length = solution.arc_length[-1]
    places = curve(solution)(np.arange(0, length, RADIUS / 40))
    nearest = min(plate.nearest(places).distance.min() for plate in solution.scene.obstacles)
    return nearest / RADIUS - 1


@pytest.fixture
def through(drilled):
    def scene(length, heights, hole=0.01, thickness=0.003, axis=(-1, 0, 0), **options):
        """A cable from (0, 0, 0) to the same height beyond plates at every 150 mm, their holes at these heights."""
        axis = np.array(axis) / np.linalg.norm(axis)
        places = [np.array([0.15 * (i + 1), y, 0]) for i, y in enumerate(heights)]
        return Scene(
            rod=Rod(
                length=length,
                radius=RADIUS,
                mass_per_length=0.0446,
                bending_stiffness=(1.18e-3, 1.18e-3),
                torsional_stiffness=1.18e-3,
            ),
            start=Swivel([0, 0, 0], [1, 0, 0]),
            end=Swivel([0.15 * (len(heights) + 1), 0, 0], [1, 0, 0]),
            supports=[Ring(place, axis, hole) for place in places],
            obstacles=[Mesh(*drilled(p, axis, hole, thickness, 32)) for p in places],
            options=SolveOptions(**options),
        )

    return scene


@pytest.mark.parametrize(
    ("length", "heights", "hole"),
    [(0.64, (0.02, -0.02, 0.01), 0.01), (0.31, (0.03,), 0.006), (0.48, (-0.03, 0.03), 0.01)],
)
def test_it_keeps_clear_of_the_plates(through, length, heights, hole):
    found = find_equilibrium(through(length, heights, hole)).raise_for_status()
    assert found.contacts
    assert not any("rims" in sentence for sentence in found.left_out)
    assert gap(found) > -LEFT_OUT
    assert found.min_clearance / RADIUS == pytest.approx(gap(found), abs=LEFT_OUT)


def test_it_is_the_same_on_a_finer_mesh(through):
    found = find_equilibrium(through(0.64, (0.02, -0.02, 0.01)))
    finer = find_equilibrium(through(0.64, (0.02, -0.02, 0.01), tolerance=1e-5))
    apart = np.linalg.norm(curve(finer)(found.arc_length) - found.position, axis=1).max()
    assert apart < found.position_error + finer.position_error


def test_a_drag_goes_on_from_where_it_lay(through):
    before = find_equilibrium(through(0.64, (0.02, -0.02, 0.01)))
    scene = through(0.641, (0.02, -0.02, 0.01))
    cold, warm = find_equilibrium(scene), find_equilibrium(scene, start=before)
    assert warm.raise_for_status().solver["iterations"] < cold.solver["iterations"] / 2
    assert gap(warm) > -LEFT_OUT


def test_what_lies_between_the_nodes_of_a_coarse_mesh_is_seen(through):
    """Elements of 33 mm at a plate of 1 mm: nodes and four places between them are all clear of it."""
    scene = through(0.31, (0.03,), hole=0.006, thickness=0.001)
    found = find_equilibrium(scene).raise_for_status()
    assert gap(found) > -LEFT_OUT
