# SPDX-License-Identifier: LGPL-2.1-or-later
"""What must not change the answer: where the scene stands, its units, and which end is called the start.

Tolerance: both runs solve the same discrete problem, to 1e-9 of the scaled optimality conditions.
"""

from dataclasses import replace

import numpy as np
import pytest

from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.geometry import rotation
from freecad_cable.problem import Clamped, Rod, Scene, Swivel

SAME = 1e-7


def anisotropic(scene):
    """The scene with what symmetry would hide: two bending stiffnesses and a natural curvature."""
    rod = scene.rod
    stiffness = rod.bending_stiffness * (1.0, 1.6)
    changed = replace(rod, bending_stiffness=stiffness, natural_curvature=[1.0, -2.0, 0.7])
    return replace(scene, rod=changed)


@pytest.fixture
def scene(table_1):
    return anisotropic(table_1(0.73))


def test_rigid_motion(scene):
    shift = np.array([3.0, -1.0, 2.0])
    turn = rotation.exponential([0.4, -1.1, 0.8])

    def moved(end):
        return Clamped(
            rotation.rotate(turn, end.position) + shift, rotation.multiply(turn, end.quaternion)
        )

    here = find_equilibrium(scene).raise_for_status()
    there = find_equilibrium(
        replace(
            scene,
            start=moved(scene.start),
            end=moved(scene.end),
            gravity=rotation.rotate(turn, scene.gravity),
        )
    )
    expected = rotation.rotate(turn, here.position) + shift
    assert np.abs(there.position - expected).max() < SAME
    assert np.abs(there.force - rotation.rotate(turn, here.force)).max() < SAME
    assert there.energy.total == pytest.approx(here.energy.total, rel=1e-8)


def test_a_ribbon_whose_start_may_roll_is_turned_the_same_way_wherever_it_stands():
    """As its ends stand here its first frames are more than half a turn from those that its end asks for."""
    ribbon = Rod(
        length=1.287716,
        radius=0.00433,
        mass_per_length=0.115992,
        bending_stiffness=[0.0398034, 0.2292512],
        torsional_stiffness=0.0425114,
    )
    tangent = np.array([0.7469205, 0.6549293, 0.114793])
    last = np.array([0.2982926, -0.6605552, -0.3608829, -0.5869002])
    place, weight = (
        np.array([0.5442846, 0.7068475, 0.2013193]),
        np.array([-0.2624816, -2.8356245, 9.387568]),
    )
    energies = []
    for turn in np.random.default_rng(1).normal(size=(6, 3)):
        turn = rotation.exponential(turn)
        scene = Scene(
            rod=ribbon,
            start=Swivel([0, 0, 0], rotation.rotate(turn, tangent / np.linalg.norm(tangent))),
            end=Clamped(
                rotation.rotate(turn, place),
                rotation.multiply(turn, last / np.linalg.norm(last)),
            ),
            gravity=rotation.rotate(turn, weight),
        )
        energies.append(find_equilibrium(scene).raise_for_status().energy.total)
    # Each to the tolerance of a position, of which an energy is wrong by the square, or by the mesh, 1e-5 of it.
    assert energies == pytest.approx([energies[0]] * 6, rel=1e-4)


def test_reversal(scene):
    """Reading the cable from its other end turns d2 and d3 about."""
    half_turn = np.array([0.0, 1.0, 0.0, 0.0])

    def flipped(end):
        return Clamped(end.position, rotation.multiply(end.quaternion, half_turn))

    natural = scene.rod.natural_curvature * (-1, 1, 1)
    other = find_equilibrium(
        replace(
            scene,
            start=flipped(scene.end),
            end=flipped(scene.start),
            rod=replace(scene.rod, natural_curvature=natural),
        )
    ).raise_for_status()
    one = find_equilibrium(scene).raise_for_status()
    assert np.abs(other.position[::-1] - one.position).max() < SAME
    assert np.abs(other.start_reaction.force - one.end_reaction.force).max() < SAME
    assert np.abs(other.start_reaction.moment - one.end_reaction.moment).max() < SAME
    elastic = [s.energy.bending + s.energy.torsion for s in (one, other)]
    assert elastic[0] == pytest.approx(elastic[1], rel=1e-8)


@pytest.mark.parametrize("scale", [1e-3, 1e3])
def test_units(scene, scale):
    """Lengths times ``scale``, with stiffness and mass so that all forces stay: the same numbers in other units."""
    rod = scene.rod
    bigger = Rod(
        length=rod.length * scale,
        radius=rod.radius * scale,
        mass_per_length=rod.mass_per_length / scale,
        bending_stiffness=rod.bending_stiffness * scale**2,
        torsional_stiffness=rod.torsional_stiffness * scale**2,
        natural_curvature=rod.natural_curvature / scale,
    )
    ends = [Clamped(e.position * scale, e.quaternion) for e in (scene.start, scene.end)]
    one = find_equilibrium(scene).raise_for_status()
    other = find_equilibrium(replace(scene, rod=bigger, start=ends[0], end=ends[1]))
    assert np.abs(other.position / scale - one.position).max() < SAME
    assert np.abs(other.force - one.force).max() < SAME
    assert other.min_bend_radius[0] == pytest.approx(scale * one.min_bend_radius[0], rel=1e-6)


def test_the_sign_of_a_quaternion(scene):
    one = find_equilibrium(scene)
    flipped = replace(scene, end=Clamped(scene.end.position, -scene.end.quaternion))
    assert np.abs(find_equilibrium(flipped).position - one.position).max() < SAME
