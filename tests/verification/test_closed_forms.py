# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solved cables against closed forms.

Tolerances: the error estimate must cover the true position error (with the accuracy of the closed
form itself and of the solver, 1e-8, added), and be within the tolerance asked for. Energy is stationary,
so its relative error is that of the scheme's energy, for order 4 and 32 elements below 1e-4. A force is a
second derivative of the curvature in disguise: with curvature like cos(k s), helix elements of length h
miss (k h)²/12 of it, 1 % for k = 4π and 32 elements; order 4 misses about the square of that.
"""

import math

import numpy as np
import pytest

from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.geometry import rotation
from freecad_cable.options import SolveOptions
from freecad_cable.problem import Clamped, Free, Pinned, Rod, Scene, Swivel
from freecad_cable.reference.catenary import catenary, hanging_rod
from freecad_cable.reference.elastica import clamped_elastica, pinned_elastica
from freecad_cable.reference.heavy import heavy_cantilever
from freecad_cable.reference.helix import helix, twisted_rod

TOLERANCE = 1e-4
FORCE = {"helix": 1e-2, "magnus": 1e-3}
"""relative to the largest"""
ALONG_X = rotation.from_tangent([1.0, 0.0, 0.0])


def rod(length=1.0, bending=1.0, torsional=0.8, weight=0.0, **others):
    return Rod(
        length=length,
        radius=0.005,
        mass_per_length=weight / 9.81,
        bending_stiffness=bending,
        torsional_stiffness=torsional,
        **others,
    )


def solved(rod, start, end, **options):
    scene = Scene(rod=rod, start=start, end=end, options=SolveOptions(**options))
    return find_equilibrium(scene).raise_for_status()


def assert_same(solution, exact, tolerance=TOLERANCE):
    length = solution.scene.rod.length
    error = np.linalg.norm(solution.position - exact.position, axis=1).max() / length
    assert error <= tolerance
    assert error <= solution.position_error / length + 1e-8
    largest = max(np.linalg.norm(exact.force, axis=1).max(), 1e-12)
    off = np.linalg.norm(solution.force - exact.force, axis=1).max()
    assert off <= FORCE[solution.solver["scheme"]] * largest
    assert solution.energy.total == pytest.approx(exact.energy.total, rel=tolerance, abs=1e-12)
    assert solution.stable


@pytest.mark.parametrize("chord", [0.9, 0.7, 0.5])
@pytest.mark.parametrize("scheme", ["magnus", "helix"])
def test_clamped_elastica(chord, scheme):
    # Any turn about the chord is as good: compare in the plane in which the hump stands.
    solution = solved(
        rod(torsional=10.0),
        Clamped([0, 0, 0], ALONG_X),
        Clamped([chord, 0, 0], ALONG_X),
        scheme=scheme,
        tolerance=TOLERANCE / 3,
    )
    exact = clamped_elastica(solution.arc_length, chord)
    rise = np.linalg.norm(solution.position[:, 1:], axis=1)
    assert np.abs(rise - exact.position[:, 2]).max() < TOLERANCE
    assert np.abs(solution.position[:, 0] - exact.position[:, 0]).max() < TOLERANCE
    assert solution.force[0, 0] == pytest.approx(exact.force[0, 0], rel=FORCE[scheme])
    assert solution.energy.total == pytest.approx(exact.energy.total, rel=FORCE[scheme])


def test_pinned_elastica():
    slope = math.radians(60)
    exact = pinned_elastica(np.linspace(0, 1, 33), slope)
    chord = exact.position[-1, 0]
    solution = solved(rod(), Pinned([0, 0, 0]), Pinned([chord, 0, 0]))
    exact = pinned_elastica(solution.arc_length, slope)
    rise = np.linalg.norm(solution.position[:, 1:], axis=1)
    assert np.abs(rise - exact.position[:, 2]).max() < TOLERANCE
    assert solution.energy.total == pytest.approx(exact.energy.total, rel=TOLERANCE)
    assert solution.force[0, 0] == pytest.approx(exact.force[0, 0], rel=FORCE["magnus"])


@pytest.mark.parametrize("weight", [1.0, 10.0, 100.0, 1000.0])
def test_cantilever_under_its_own_weight(weight):
    solution = solved(rod(weight=weight), Clamped([0, 0, 0], ALONG_X), Free())
    assert_same(solution, heavy_cantilever(solution.arc_length, weight))


def test_cantilever_held_at_its_end():
    weight = 10.0
    solution = solved(
        rod(weight=weight),
        Free(place="start"),
        Clamped([0, 0, 0], rotation.from_tangent([-1.0, 0, 0])),
    )
    exact = heavy_cantilever(solution.scene.rod.length - solution.arc_length[::-1], weight)
    assert np.abs(solution.position[::-1] - exact.position).max() < TOLERANCE
    # Gravity energy is measured from the start point, here the free tip.
    tip = exact.energy.gravity - weight * exact.position[-1, 2]
    assert solution.energy.gravity == pytest.approx(tip, rel=TOLERANCE)


@pytest.mark.parametrize("scheme", ["magnus", "helix"])
def test_helix_under_end_moment_and_force(scheme):
    turn, twist = 3.0, 1.5
    exact = helix(np.linspace(0, 1, 33), 0.2, turn, twist, 1.0, 0.7)
    solution = solved(
        rod(torsional=0.7),
        Clamped(exact.position[0], exact.quaternion[0]),
        Clamped(exact.position[-1], exact.quaternion[-1]),
        scheme=scheme,
    )
    exact = helix(solution.arc_length, 0.2, turn, twist, 1.0, 0.7)
    assert_same(solution, exact)
    off = np.abs(solution.moment - exact.moment).max()
    assert off < FORCE[scheme] * np.abs(exact.moment).max()


@pytest.mark.parametrize("angle", [0.5, -2.0])
def test_twist_of_a_straight_rod(angle):
    # Held at a distance that leaves hardly any slack, so that it stays straight to 1e-3.
    end = rotation.multiply(ALONG_X, rotation.exponential([0, 0, angle]))
    pulled = rod(axial_stiffness=1e4)
    solution = solved(pulled, Clamped([0, 0, 0], ALONG_X), Clamped([1.002, 0, 0], end))
    exact = twisted_rod(solution.arc_length, angle, 0.8)
    torque = np.einsum("ki,ki->k", solution.moment, rotation.tangent(solution.quaternion))
    assert torque == pytest.approx(
        exact.moment[0] @ rotation.tangent(exact.quaternion[0]), rel=1e-6
    )
    assert solution.energy.torsion == pytest.approx(0.8 * angle**2 / 2, rel=1e-6)
    assert solution.twist == pytest.approx(angle, rel=1e-6)
    # Hooke: EA times the strain.
    assert solution.force[:, 0] == pytest.approx(1e4 * 0.002, rel=1e-6)


def test_torsion_is_left_out_where_an_end_may_twist():
    solution = solved(rod(weight=5.0), Clamped([0, 0, 0], ALONG_X), Swivel([0.7, 0, 0], [1, 0, 0]))
    assert any(sentence.startswith("torsion") for sentence in solution.left_out)
    torque = np.einsum("ki,ki->k", solution.moment, rotation.tangent(solution.quaternion))
    assert np.abs(torque).max() < 1e-6 * np.abs(solution.moment).max()


def test_towards_the_catenary():
    span, weight = 1.0 / 1.5, 1.0
    off, pull = [], []
    stiffness = [1e-4, 1e-5, 1e-6]
    for bending in stiffness:
        solution = solved(
            rod(bending=bending, torsional=bending, weight=weight),
            Pinned([0, 0, 0]),
            Pinned([span, 0, 0]),
            tolerance=1e-7,
        )
        exact = catenary(solution.arc_length, span, 0.0, weight)
        off.append(np.linalg.norm(solution.position - exact.position, axis=1).max())
        pull.append(abs(solution.force[0, 0] / exact.force[0, 0] - 1))
    # A hinged cable differs from its catenary by the first power of EI: a tenth for each tenth.
    assert off[-1] < 1e-5 and pull[-1] < 1e-4
    for series in (off, pull):
        assert series[0] / series[1] == pytest.approx(10, rel=0.1)
        assert series[1] / series[2] == pytest.approx(10, rel=0.1)


@pytest.mark.parametrize("axial", [20.0, 1e3])
def test_extensible_hanging_cable(axial):
    span, weight, bending = 1.0, 1.0, 1e-6
    solution = solved(
        rod(1.5, bending=bending, torsional=bending, weight=weight, axial_stiffness=axial),
        Pinned([0, 0, 0]),
        Pinned([span, 0, 0]),
    )
    exact = catenary(solution.arc_length, span, 0.0, weight, axial)
    # Bending stiffness of 1e-6 shifts the sag by about its own size over H.
    assert np.abs(solution.position - exact.position).max() < 1.5 * TOLERANCE
    assert solution.energy.stretch == pytest.approx(exact.energy.stretch, rel=1e-3)


def test_rod_that_hangs_from_a_pin_stretches():
    axial, weight = 50.0, 3.0
    solution = solved(rod(weight=weight, axial_stiffness=axial), Pinned([0, 0, 0]), Free())
    assert_same(solution, hanging_rod(solution.arc_length, weight, axial), tolerance=1e-6)
