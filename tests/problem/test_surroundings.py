# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a cable cannot touch is left out; what it can is not."""

import numpy as np
import pytest
from numpy.linalg import norm

from freecad_cable.problem import Box, HalfSpace, Mesh, Sphere
from freecad_cable.problem.surroundings import out_of_reach

A, B, LENGTH = np.array([0.0, 0, 0]), np.array([0.3, 0, 0]), 0.5
SHORT = 0.2  # half of √(L² − |b − a|²): how far the middle of the cable gets from the chord
STRAIGHT = (1, 0, 0, 0)


@pytest.mark.parametrize("margin", [0.0, 0.005])
def test_out_of_reach_to_the_micrometre(margin):
    def cubes(gap):
        across, along = 0.05 + SHORT + margin + gap, 0.05 + 0.4 + margin + gap
        places = [(0.15, across, 0), (0.15, 0, -across), (along, 0, 0), (0.3 - along, 0, 0)]
        return [Box(place, STRAIGHT, (0.1, 0.1, 0.1)) for place in places]

    assert out_of_reach(cubes(1e-6), A, B, LENGTH, margin).all()
    assert not out_of_reach(cubes(-1e-6), A, B, LENGTH, margin).any()


def test_a_half_space_by_its_plane_not_its_bounds():
    # The plane that touches where |x − a| + |x − b| = L at x has there the sum of the unit vectors as its normal.
    x = np.array([0.15, 0.12, 0.16])
    normal = (x - A) / norm(x - A) + (x - B) / norm(x - B)
    normal /= norm(normal)
    for gap, far in ((0.0051, True), (0.0049, False)):
        wall = HalfSpace(x + gap * normal, -normal)
        assert out_of_reach([wall], A, B, LENGTH, 0.005).tolist() == [far]


def test_held_at_one_end():
    near, far = Sphere((0, 0, 0.56), 0.05), Sphere((0, 0, 0.5602), 0.05)
    assert out_of_reach([near, far], A, None, LENGTH, 0.01005).tolist() == [False, True]


def test_no_obstacles():
    assert out_of_reach([], A, B, LENGTH, 0.01).shape == (0,)


def test_kinds_may_be_mixed():
    corners, faces = np.eye(4)[:, 1:], [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
    scene = [
        Mesh(corners + 2, faces),
        HalfSpace((0, 0, -0.1), (0, 0, 1)),
        Mesh(corners, faces),
        HalfSpace((0, 0, -0.3), (0, 0, 1)),
    ]
    assert out_of_reach(scene, A, B, LENGTH, 0.01).tolist() == [True, False, False, True]
