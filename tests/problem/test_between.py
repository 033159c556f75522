# SPDX-License-Identifier: LGPL-2.1-or-later
from dataclasses import replace

import numpy as np
import pytest

from freecad_cable.errors import ProblemError
from freecad_cable.options import SolveOptions
from freecad_cable.problem import Box, Clamped, HalfSpace, Mesh, Pinned, Ring, Rod, Scene, Sphere
from freecad_cable.problem.between import between

ROUNDING = 1e-15
ROD = Rod(
    length=1.0,
    radius=0.01,
    mass_per_length=0.1,
    bending_stiffness=0.1,
    torsional_stiffness=0.1,
)
UNTURNED, QUARTER, HALF = ([np.cos(a), 0, 0, np.sin(a)] for a in np.radians([0, 45, 90]))
CORNERS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
FACES = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])


def scene(x, turn, obstacles=(), supports=(), **rod):
    start, end = Clamped([0, 0, 0], UNTURNED), Clamped([x, 0, 0], turn)
    rod = replace(ROD, **rod)
    return Scene(rod=rod, start=start, end=end, obstacles=obstacles, supports=supports)


def test_numbers_places_and_turns():
    low = scene(0.2, UNTURNED, [Box([0, 0, 1], UNTURNED, [1, 1, 1])], length=1.0)
    high = scene(0.6, HALF, [Box([0, 0, 3], HALF, [1, 1, 3])], length=2.0)
    there = between(low, high, 0.5)
    assert there.rod.length == 1.5
    assert there.end.position[0] == pytest.approx(0.4, abs=ROUNDING)
    assert there.end.quaternion == pytest.approx(QUARTER, abs=ROUNDING)
    assert there.obstacles[0].position[2] == 2.0
    assert there.obstacles[0].quaternion == pytest.approx(QUARTER, abs=ROUNDING)
    assert there.obstacles[0].size[2] == 2.0


def test_at_the_end_it_is_the_other():
    low = scene(0.2, UNTURNED, [Sphere([0, 0, 1], 0.1)], [Ring([0.1, 0, 0], [1, 0, 0], 0.1)])
    high = scene(0.6, HALF, [Sphere([0, 0, 3], 0.2)], [Ring([0.3, 0, 0], [1, 0, 0], 0.2)])
    there = between(low, high, 1.0)
    assert there.obstacles[0].radius == 0.2
    assert there.supports[0].position[0] == 0.3
    assert there.end.quaternion == pytest.approx(HALF, abs=ROUNDING)


def test_meshes_move_and_others_are_others():
    low, high = Mesh(CORNERS, FACES), Mesh(CORNERS + [0, 0, 2], FACES)
    there = between(scene(0.2, UNTURNED, [low]), scene(0.2, UNTURNED, [high]), 0.5)
    assert np.array_equal(there.obstacles[0].vertices, CORNERS + [0, 0, 1])
    turned = Mesh(CORNERS + [0, 0, 2], FACES[:, [1, 2, 0]])
    there = between(scene(0.2, UNTURNED, [low]), scene(0.2, UNTURNED, [turned]), 0.5)
    assert there.obstacles[0] is turned


def test_what_only_one_of_them_has():
    ball, options = Sphere([0, 0, 3], 0.2), SolveOptions(tolerance=1e-3)
    low, high = scene(0.2, UNTURNED), scene(0.6, UNTURNED, [ball], min_bend_radius=0.1)
    there = between(low, replace(high, options=options), 0.5)
    assert there.obstacles == (ball,)
    assert there.rod.min_bend_radius == 0.1
    assert there.options == options
    pinned = replace(high, end=Pinned([0.6, 0, 0]))
    assert between(low, pinned, 0.5).end is pinned.end


def test_another_name_is_another_thing():
    low, high = (Sphere([0, 0, z], 0.1, place=f"obstacle {z}") for z in (1, 3))
    there = between(scene(0.2, UNTURNED, [low]), scene(0.2, UNTURNED, [high]), 0.5)
    assert there.obstacles[0] is high


def test_no_scene_on_the_way():
    up, down = (scene(0.2, UNTURNED, [HalfSpace([0, 0, -1], [0, 0, z])]) for z in (1, -1))
    with pytest.raises(ProblemError, match="normal"):
        between(up, down, 0.5)
