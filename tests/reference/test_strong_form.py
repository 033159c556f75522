# SPDX-License-Identifier: LGPL-2.1-or-later
"""The strong-form solver against closed forms, and against numbers that other codes found."""

import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from freecad_cable.errors import NotYetError
from freecad_cable.geometry import curves, rotation
from freecad_cable.problem import Clamped, Free, Pinned, Rod, Scene, Swivel
from freecad_cable.reference.catenary import hanging_rod
from freecad_cable.reference.collocation import NoSolutionError
from freecad_cable.reference.elastica import cantilever, clamped_elastica, pinned_elastica
from freecad_cable.reference.heavy import heavy_cantilever
from freecad_cable.reference.helix import helix, roll_up, twisted_rod
from freecad_cable.reference.rod_equations import SIZE, RodEquations
from freecad_cable.reference.strong_form import equilibrium

S = np.linspace(0, 1, 21)
START = {"place": "start"}


def ends(state, start="clamped", end="clamped"):
    """End conditions that hold what the state has there."""
    made = []
    for kind, i, place in ((start, 0, "start"), (end, -1, "end")):
        position, quaternion = state.position[i], state.quaternion[i]
        made.append(
            {
                "clamped": lambda: Clamped(position, quaternion, place=place),  # noqa: B023
                "swivel": lambda: Swivel(position, rotation.tangent(quaternion), place=place),  # noqa: B023
                "pinned": lambda: Pinned(position, place=place),  # noqa: B023
                "free": lambda: Free(place=place),  # noqa: B023
            }[kind]()
        )
    return {"start": made[0], "end": made[1]}


def scene(held, length=1.0, weight=0.0, bending=1.0, torsional=1.0, gravity=(0, 0, -1), **rod):
    rod = Rod(
        length=length,
        radius=1e-3,
        mass_per_length=weight,
        bending_stiffness=bending,
        torsional_stiffness=torsional,
        **rod,
    )
    return Scene(rod=rod, **held, gravity=gravity)


def shape_of(state):
    """The shape alone: no force, no moment."""
    return SimpleNamespace(
        arc_length=state.arc_length,
        position=state.position,
        quaternion=state.quaternion,
        force=None,
        moment=None,
    )


HELIX = helix(1.25 * 2 * math.pi / 8 * S, 0.1, 8, 1.5, 1.0, 0.7)

# closed form, kinds of its ends, and what its rod has besides EI = GJ = 1
CLOSED = {
    "clamped": (clamped_elastica(S, 0.5), "clamped", "clamped", {}),
    "clamped, almost straight": (clamped_elastica(S, 0.999), "clamped", "clamped", {}),
    "swivels on one line": (clamped_elastica(S, 0.5), "swivel", "swivel", {}),
    "pinned": (pinned_elastica(S, 1.5), "pinned", "pinned", {}),
    "clamped and pinned": (pinned_elastica(S, 1.5), "clamped", "pinned", {}),
    "cantilever": (cantilever(S, 10.0), "clamped", "free", {}),
    "helix": (HELIX, "clamped", "clamped", {"torsional": 0.7}),
    "roll-up": (roll_up(S), "clamped", "free", {}),
    "twisted": (twisted_rod(S, 2.0), "clamped", "clamped", {}),
    "heavy": (heavy_cantilever(S, 100.0), "clamped", "free", {"weight": 100.0}),
    "hanging": (
        hanging_rod(S, 3.0, 7.0),
        "clamped",
        "free",
        {"weight": 3.0, "axial_stiffness": 7.0},
    ),
}


@pytest.mark.parametrize("name", CLOSED)
@pytest.mark.parametrize("given", ["state", "shape"])
def test_closed_forms(name, given):
    """To 1e-11 of the largest value: rounding of some 1000 unknowns, amplified by a condition below
    1e4.

    The shape alone stands for all but dead loads on a free end, which are part of the statement.
    """
    state, start, end, rod = CLOSED[name]
    loads = {"end_force": state.force[-1], "end_moment": state.moment[-1]} if end == "free" else {}
    problem = scene(ends(state, start, end), state.arc_length[-1], **rod)
    found = equilibrium(problem, state if given == "state" else shape_of(state), **loads)
    there = found.at(state.arc_length)
    for array in ("position", "quaternion", "force", "moment"):
        exact = getattr(state, array)
        limit = 1e-11 * max(1.0, np.abs(exact).max())
        assert np.abs(getattr(there, array) - exact).max() < limit, array
    assert found.energy.total == pytest.approx(state.energy.total, rel=1e-11)
    assert found.error < 1e-10 * state.arc_length[-1]


def test_a_disturbed_start_on_a_symmetry_finds_the_same_rod_turned():
    """Clamps on one line: the hump may lie in any plane through it, and the energy does not know which."""
    state = clamped_elastica(S, 0.5)
    noise = np.random.default_rng(1).normal(scale=1e-3, size=(21, 7))
    start = shape_of(state)
    start.position = state.position + noise[:, :3]
    start.quaternion = state.quaternion + noise[:, 3:]
    start.quaternion /= np.linalg.norm(start.quaternion, axis=1, keepdims=True)
    found = equilibrium(scene(ends(state)), start).at(S)
    height = np.hypot(found.position[:, 1], found.position[:, 2])
    assert np.abs(height - state.position[:, 2]).max() < 1e-11
    assert found.energy.total == pytest.approx(state.energy.total, rel=1e-12)


def test_a_rod_on_swivels_may_turn_about_itself():
    """Its frames depend on the start, its centreline does not, and it carries no torque."""
    held = {
        "start": Swivel((0, 0, 0), (1, 0, 0), **START),
        "end": Swivel((0.6, 0.1, 0.2), (0, 1, 0)),
    }
    problem = scene(held, weight=400.0)
    curve = curves.hermite(0 * S[:3], (1, 0, 0), (0.6, 0.1, 0.2), (0, 1, 0), 1.0, (0, 0, -100))
    position, tangent = curve.at(S)
    random, found = np.random.default_rng(5), []
    for _ in range(3):
        start = SimpleNamespace(arc_length=S, position=position, force=None, moment=None)
        frames = rotation.transport(rotation.from_tangent(tangent[0]), tangent)
        noise = rotation.exponential(random.normal(scale=1e-2, size=(21, 3)))
        turned = rotation.exponential((0, 0, random.uniform(-3, 3)))
        start.quaternion = rotation.multiply(rotation.multiply(frames, noise), turned)
        found.append(equilibrium(problem, start))
    for one in found:
        assert np.abs(one.at(S).position - found[0].at(S).position).max() < 1e-11
        torque = (one.moment * rotation.tangent(one.quaternion)).sum(axis=1)
        assert np.abs(torque).max() < 1e-10
    assert np.abs(found[0].quaternion[0] - found[1].quaternion[0]).max() > 0.01


@pytest.mark.parametrize("stages", [2, 3])
def test_the_error_stated_bounds_the_true_one(stages):
    state = clamped_elastica(S, 0.5)
    found = equilibrium(scene(ends(state)), state, tolerance=1e-6, stages=stages)
    true = np.abs(found.at(S).position - state.position).max()
    assert 1e-13 < true < found.error < 1e-6


def general_scene():
    """Everything at once: two stiffnesses, natural curvature and twist, stretch, shear, weight."""
    held = {
        "start": Clamped((0, 0, 0), (1, 0.3, -0.2, 0.1), **START),
        "end": Swivel((0.5, 0.2, 0.6), (1, 0.3, 0.2)),
    }
    rod = {
        "bending": (1.0, 2.5),
        "torsional": 0.7,
        "natural_curvature": (0.4, -0.3, 0.8),
        "axial_stiffness": 60.0,
        "shear_stiffness": 30.0,
    }
    return scene(held, weight=8.0, gravity=(0.3, -0.4, -1.0), **rod)


def smooth(problem):
    """A start from afar: some curve between the ends, the frame carried along."""
    start, end = problem.start, problem.end
    first = rotation.tangent(start.quaternion)
    curve = curves.hermite(start.position, first, end.position, end.tangent, 1.0)
    position, tangent = curve.at(S)
    return SimpleNamespace(
        arc_length=S,
        position=position,
        quaternion=rotation.transport(start.quaternion, tangent),
        force=None,
        moment=None,
    )


def test_any_rod_satisfies_the_equations_integrated_by_other_means():
    """From the start, with a rotation matrix instead of a quaternion, by DOP853: global errors near its rtol."""
    problem = general_scene()
    found = equilibrium(problem, smooth(problem))
    rod = problem.rod
    compliance = np.diag([1 / rod.shear_stiffness] * 2 + [1 / rod.axial_stiffness])

    def rate(_, y):
        turn, n, m = y[3:12].reshape(3, 3), y[12:15], y[15:]
        x, y, z = rod.natural_curvature + turn.T @ m / rod.stiffness
        along = turn @ ([0, 0, 1] + compliance @ turn.T @ n)
        spin = turn @ [[0, -z, y], [z, 0, -x], [-y, x, 0]]
        return np.concatenate((along, spin.ravel(), -problem.weight, -np.cross(along, n)))

    turn = rotation.matrix(found.quaternion)
    first = (found.position[0], turn[0].ravel(), found.force[0], found.moment[0])
    path = solve_ivp(rate, (0, 1), np.concatenate(first), method="DOP853", rtol=1e-13, atol=1e-13)
    last = (found.position[-1], turn[-1].ravel(), found.force[-1], found.moment[-1])
    assert np.abs(path.y[:, -1] - np.concatenate(last)).max() < 1e-10
    assert np.abs(found.position[-1] - problem.end.position).max() < 1e-14
    assert np.abs(turn[-1, :, 2] - problem.end.tangent).max() < 1e-13
    assert abs(found.moment[-1] @ problem.end.tangent) < 1e-12
    assert np.abs(np.linalg.norm(found.quaternion, axis=1) - 1).max() < 1e-13


def test_the_start_is_kept_among_the_arc_lengths_and_units_do_not_matter():
    """The same rod 1000 times as long and in other units of force: energies and lengths scale, to rounding."""
    state = clamped_elastica(S**1.3, 0.7)
    found = equilibrium(scene(ends(state)), state)
    big = clamped_elastica(1e3 * S**1.3, 700.0, 1e-4)
    scaled = equilibrium(scene(ends(big), 1e3, bending=1e-4, torsional=1e-4), big)
    assert np.abs(scaled.at(big.arc_length).position / 1e3 - state.position).max() < 1e-12
    assert scaled.energy.total == pytest.approx(1e-7 * found.energy.total, rel=1e-12)
    assert scaled.error == pytest.approx(1e3 * found.error, abs=1e-9)


def test_rates_have_their_jacobian():
    """Against central differences of step 1e-5, which miss third derivatives (of order 10) times 1e-10/6."""
    rod = RodEquations(*np.array([[1, 2, 0.7], [0.1, 0.1, 0.05], [0.3, -0.2, 0.5], [1, 2, -3]]))
    y = np.random.default_rng(2).normal(size=(5, SIZE))
    differences = [
        (rod.rate(y + step)[0] - rod.rate(y - step)[0]) / 2e-5 for step in 1e-5 * np.eye(SIZE)
    ]
    assert np.abs(rod.rate(y)[1] - np.stack(differences, axis=-1)).max() < 1e-8


def test_what_it_cannot_do_is_said():
    state = clamped_elastica(S, 0.5)
    held = scene(ends(state))
    with pytest.raises(NotYetError, match="supports"):
        equilibrium(replace(held, supports=(object(),)), state)
    with pytest.raises(NotYetError, match="obstacles"):
        equilibrium(replace(held, obstacles=(object(),)), state)
    wild = shape_of(state)
    wild.position = np.random.default_rng(3).normal(size=(21, 3))
    wild.quaternion = np.random.default_rng(4).normal(size=(21, 4))
    with pytest.raises(NoSolutionError):
        equilibrium(held, wild)
