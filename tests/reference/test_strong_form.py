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
from freecad_cable.problem import Clamped, Free, Pinned, Ring, Rod, Scene, Sphere, Swivel
from freecad_cable.reference.catenary import hanging_rod
from freecad_cable.reference.collocation import NoSolutionError
from freecad_cable.reference.elastica import cantilever, clamped_elastica, pinned_elastica
from freecad_cable.reference.heavy import heavy_cantilever
from freecad_cable.reference.helix import helix, roll_up, twisted_rod
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


@pytest.mark.parametrize("stages", [2, 3, 5])
def test_the_error_stated_bounds_the_true_one(stages):
    """And is within the tolerance, however far the first mesh is from that."""
    state = clamped_elastica(S, 0.5)
    found = equilibrium(scene(ends(state)), state, tolerance=1e-9, stages=stages)
    true = np.abs(found.at(S).position - state.position).max()
    rounding = 1e-15
    assert true < found.error + rounding
    assert found.error < 1e-9


def test_the_mesh_is_fine_where_the_rod_bends():
    """A heavy cantilever bends within some √(EI/wL) = L/32 of its clamp and hangs straight beyond."""
    state = heavy_cantilever(S, 1000.0)
    steps = np.diff(
        equilibrium(scene(ends(state, "clamped", "free"), weight=1000.0), state).arc_length
    )
    assert steps[0] < steps[-1] / 1.9


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


def test_energy_does_not_know_where_the_origin_is():
    energy = []
    for shift in (np.zeros(3), np.array([1.0, -2, 3])):
        problem = general_scene()
        held = {
            end.place: replace(end, position=end.position + shift)
            for end in (problem.start, problem.end)
        }
        problem = replace(problem, **held)
        energy.append(equilibrium(problem, smooth(problem)).energy.total)
    assert energy[1] == pytest.approx(energy[0], rel=1e-12)


def test_the_start_is_kept_among_the_arc_lengths_and_units_do_not_matter():
    """The same rod 1000 times as long and in other units of force: energies and lengths scale, to rounding."""
    state = clamped_elastica(S**1.3, 0.7)
    small_scene = scene(ends(state))
    found = equilibrium(small_scene, state)
    big = clamped_elastica(1e3 * S**1.3, 700.0, 1e-4)
    scaled_scene = scene(ends(big), 1e3, bending=1e-4, torsional=1e-4)
    scaled = equilibrium(scaled_scene, big)
    rough = [
        equilibrium(problem, start, tolerance=1e-5, stages=2).error
        for problem, start in ((scaled_scene, big), (small_scene, state))
    ]
    assert rough[0] == pytest.approx(1e3 * rough[1], rel=1e-6)
    assert np.abs(scaled.at(big.arc_length).position / 1e3 - state.position).max() < 1e-12
    assert scaled.energy.total == pytest.approx(1e-7 * found.energy.total, rel=1e-12)


def test_what_it_cannot_do_is_said(monkeypatch):
    state = clamped_elastica(S, 0.5)
    held = scene(ends(state))
    with pytest.raises(NotYetError, match="supports"):
        equilibrium(replace(held, supports=(Ring(state.position[10], (1, 0, 0), 0.1),)), state)
    with pytest.raises(NotYetError, match="obstacles"):
        equilibrium(replace(held, obstacles=(Sphere((9, 9, 9), 0.1),)), state)
    turned = ends(state, "clamped", "swivel")
    turned["end"] = Swivel(state.position[-1], (-1, 0, 0))
    with pytest.raises(NoSolutionError, match="end points against"):
        equilibrium(scene(turned), state)
    with monkeypatch.context() as patch:
        patch.setattr("freecad_cable.reference.strong_form.LARGEST_MESH", 40)
        with pytest.raises(NoSolutionError, match="40 elements"):
            equilibrium(held, state, stages=2)
    wild = shape_of(state)
    wild.position = np.random.default_rng(3).normal(size=(21, 3))
    wild.quaternion = np.random.default_rng(4).normal(size=(21, 4))
    with pytest.raises(NoSolutionError):
        equilibrium(held, wild)
