# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cable that touches itself: against shooting with a point force, in balance, and never through itself."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicHermiteSpline
from scipy.optimize import fsolve

from freecad_cable.equilibrium import find_equilibria, find_equilibrium
from freecad_cable.geometry import rotation
from freecad_cable.options import SolveOptions
from freecad_cable.problem import Clamp, Clamped, Rod, Scene, Swivel
from freecad_cable.status import Status

RADIUS, WEIGHT = 0.012, 2.0
ALONG_X = rotation.exponential([0, np.pi / 2, 0])
ALONG_Y = rotation.from_tangent([0, 1, 0])
INTEGRATION = {"method": "DOP853", "rtol": 1e-10, "atol": 1e-11}


def loop(tolerance=1e-4, chord=0.15, radius=RADIUS):
    """Both ends point along x, so that the cable must turn once around and pass itself. EI = 1, GJ = 0.7."""
    return Scene(
        rod=Rod(
            length=1.0,
            radius=radius,
            bending_stiffness=1.0,
            torsional_stiffness=0.7,
            mass_per_length=WEIGHT,
        ),
        start=Clamped([0, 0, 0], ALONG_X, place="start"),
        end=Swivel([chord, 0.02, 0], [1, 0, 0]),
        gravity=[0, 0, -1.0],
        options=SolveOptions(tolerance=tolerance),
    )


def samples(solution, count=3000):
    s = np.linspace(0, solution.arc_length[-1], count)
    nodes = solution.arc_length, solution.position, rotation.tangent(solution.quaternion)
    return s, CubicHermiteSpline(*nodes)(s)


def smallest_distance(solution):
    """Between centrelines of parts that are farther from each other along the cable than half a turn about its own
    radius."""
    s, r = samples(solution, 1500)
    distance = np.linalg.norm(r[:, None] - r[None], axis=2)
    far = np.abs(s[:, None] - s[None]) > np.pi * solution.scene.rod.radius
    return distance[far].min()


@pytest.fixture(scope="module")
def solution():
    return find_equilibrium(loop()).raise_for_status()


def test_it_keeps_apart(solution):
    # One hundredth of the radius is what is left between nodes.
    assert smallest_distance(solution) == pytest.approx(2 * RADIUS, abs=0.01 * RADIUS)


def test_action_and_reaction(solution):
    here, there = solution.contacts
    assert here.obstacle is None and there.obstacle is None
    assert here.other_arc_length == there.arc_length
    assert np.array_equal(here.force, -there.force)
    # The reactions of the ends alone carry the weight, in force and in moment.
    start, end = solution.start_reaction, solution.end_reaction
    weight = np.array([0, 0, -WEIGHT])
    assert start.force + end.force + weight == pytest.approx(0, abs=1e-6)
    s, r = samples(solution)
    middle = np.trapezoid(r, s, axis=0) if hasattr(np, "trapezoid") else np.trapz(r, s, axis=0)
    moment = start.moment + end.moment + np.cross(solution.position[-1], end.force)
    assert moment + np.cross(middle, weight) == pytest.approx(0, abs=1e-5)


def rate(s, y, weight):
    """The rod's equations, with EI = 1 and GJ = 0.7."""
    q, n, m = y[3:7], y[7:10], y[10:13]
    frame = rotation.matrix(q / np.linalg.norm(q))
    kappa = frame.T @ m / np.array([1, 1, 0.7])
    turning = rotation.multiply(q, np.append(0.0, kappa)) / 2
    return np.concatenate([frame[:, 2], turning, -weight, -np.cross(frame[:, 2], n)])


def shot(unknown, scene):
    """States at start, first place, second place and end from force and moment at the start, force and places."""
    n0, m0, push, places = unknown[:3], unknown[3:6], unknown[6:9], unknown[9:]
    y = np.concatenate([scene.start.position, scene.start.quaternion, n0, m0])
    states, at = [y], 0.0
    for place, force in zip((*places, scene.rod.length), (push, -push, np.zeros(3)), strict=True):
        run = solve_ivp(rate, (at, place), y, args=(scene.weight,), **INTEGRATION)
        y, at = run.y[:, -1].copy(), place
        states.append(y.copy())
        y[7:10] -= force
    return states


def missed(unknown, scene):
    """Of eleven conditions: the swivel, and a push between two places that are a diameter apart, square to both."""
    _, first, second, end = shot(unknown, scene)
    tangents = [rotation.tangent(y[3:7]) for y in (first, second, end)]
    apart, push = first[:3] - second[:3], unknown[6:9]
    return [
        *(end[:3] - scene.end.position),
        *tangents[2][1:],
        tangents[2] @ end[10:13],
        apart @ apart - 4 * scene.rod.radius**2,
        apart @ tangents[0],
        apart @ tangents[1],
        push @ tangents[0],
        push @ tangents[1],
    ]


def test_against_shooting():
    """Where two parts cross they push each other in one point each. Eleven unknowns are found by shooting, and every
    node is within the tolerance of that."""
    scene = loop(1e-4)
    solution = find_equilibrium(scene).raise_for_status()
    contact = solution.contacts[0]
    guess = np.concatenate(
        [
            solution.force[0],
            solution.moment[0],
            contact.force,
            [contact.arc_length, contact.other_arc_length],
        ]
    )
    found, _, converged, message = fsolve(missed, guess, (scene,), xtol=1e-11, full_output=True)
    assert converged == 1, message
    assert np.abs(missed(found, scene)).max() < 1e-8
    # The push and its place are found as well as the nearest node is placed: that moves the moment by push times step.
    assert contact.force == pytest.approx(found[6:9], abs=0.02 * np.linalg.norm(found[6:9]))
    states, places = shot(found, scene), [0.0, *found[9:], 1.0]
    for k in range(3):
        y = states[k].copy()
        if k:
            y[7:10] -= found[6:9] if k == 1 else -found[6:9]
        inside = (solution.arc_length >= places[k]) & (solution.arc_length <= places[k + 1])
        s = np.unique([places[k], *solution.arc_length[inside], places[k + 1]])
        run = solve_ivp(rate, (s[0], s[-1]), y, t_eval=s, args=(scene.weight,), **INTEGRATION)
        there = np.isin(s, solution.arc_length[inside])
        away = run.y[:3].T[there] - solution.position[inside]
        assert np.linalg.norm(away, axis=1).max() < scene.options.tolerance


def test_dragged(solution):
    """From the last shape the cable stays in contact with itself, on the same side."""
    moved = find_equilibrium(loop(chord=0.152), start=solution).raise_for_status()
    anew = find_equilibrium(loop(chord=0.152)).raise_for_status()
    assert moved.contacts and smallest_distance(moved) > 1.99 * RADIUS
    assert moved.energy.total == pytest.approx(anew.energy.total, rel=1e-4)
    assert moved.contacts[0].force @ solution.contacts[0].force > 0


def test_thin_cables_are_left_alone():
    """A cable that is never near itself is solved as if that could not be."""
    free = find_equilibrium(loop(radius=1e-4)).raise_for_status()
    other = find_equilibrium(loop(radius=2e-4)).raise_for_status()
    assert not free.contacts
    assert np.array_equal(free.position, other.position)


def test_all_equilibria_keep_apart():
    found = find_equilibria(loop(1e-3))
    assert found
    for each in found:
        assert each.status.success
        assert smallest_distance(each) > 1.99 * RADIUS


def test_stretches_between_clamps_keep_apart():
    """Two stretches that cross are no longer independent of each other."""
    scene = replace(
        loop(),
        rod=replace(loop().rod, length=2.0, mass_per_length=0.2),
        supports=(
            Clamp([0.6, 0, 0], ALONG_X, arc_length=0.605, place="supports[0]"),
            Clamp([0.3, -0.3, 0], ALONG_Y, arc_length=1.4, place="supports[1]"),
        ),
        end=Clamped([0.3, 0.29, 0], ALONG_Y),
    )
    solution = find_equilibrium(scene).raise_for_status()
    assert smallest_distance(solution) == pytest.approx(2 * RADIUS, abs=0.01 * RADIUS)
    assert [round(contact.arc_length, 1) for contact in solution.contacts] == [0.3, 1.7]


def test_what_cannot_keep_apart_is_no_answer():
    """The end is held in the way on which the start leaves, nearer than the cable can bend out of it."""
    scene = replace(loop(), end=Clamped([0.03, 0, 0], ALONG_X))
    solution = find_equilibrium(scene)
    assert solution.status is Status.INACCURATE
    assert "runs through itself at 0.015" in solution.message
