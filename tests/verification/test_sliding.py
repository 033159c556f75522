# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a cable may slide: a closed form, a scan over the arc length, and a boundary value problem solved by SciPy."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_bvp
from scipy.optimize import minimize_scalar
from scipy.special import ellipe, ellipeinc, ellipk, ellipkinc

from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.geometry import rotation
from freecad_cable.options import SolveOptions
from freecad_cable.problem import Clamp, Clamped, Free, Pinned, Ring, Rod, Scene, Sleeve
from freecad_cable.status import Status

ALONG = rotation.from_tangent([1.0, 0, 0])
FINE = 1e-7
"""Tolerance asked for where an exact answer is compared with."""
NEAR = 1e-5
"""What that leaves in loads and arc lengths: an energy that is flat to second order where the position is wrong by 1e-7
of the length, times the derivatives of a bend over 0.1 of it."""


def plane_scene(supports, end=None, weight=0.0, length=1.0, **options):
    """EI = 1, clamped along x at the origin, in the x-z plane."""
    rod = Rod(
        length=length,
        radius=0.001,
        mass_per_length=weight / 9.81,
        bending_stiffness=1.0,
        torsional_stiffness=0.8,
    )
    return Scene(
        rod=rod,
        start=Clamped([0, 0, 0], ALONG, place="start"),
        end=end or Free(),
        supports=tuple(supports),
        options=SolveOptions(**options),
    )


def direction(angle):
    return np.array([np.cos(angle), 0.0, np.sin(angle)])


def rectangular_elastica(first, last, force):
    """(length, x, z in the frame of the force) of a rod with H = n·t + m²/2EI = 0 between the angles ``first`` and
    ``last`` of its tangent from −n, 0 ≤ first < last < π/2.

    EI θ'²/2 = P cos θ, the pendulum let go from the horizontal: with √2 sin(θ/2) = sin φ, m = 1/2 and λ = √(P/EI),
    λ s = F(φ), λ X = 2 E(φ) − F(φ) along −n, λ Z = √2 (1 − cos φ) across.
    """
    # At a right angle the product may exceed one by rounding.
    phi = np.arcsin(np.minimum(np.sqrt(2) * np.sin(np.array([first, last]) / 2), 1.0))
    rate = np.sqrt(force)
    length = np.diff(ellipkinc(phi, 0.5)) / rate
    along = np.diff(2 * ellipeinc(phi, 0.5) - ellipkinc(phi, 0.5)) / rate
    across = np.diff(-np.sqrt(2) * np.cos(phi)) / rate
    return float(length[0]), float(along[0]), float(across[0])


def test_the_rectangular_elastica_knows_its_quarter():
    """Euler's rectangular elastica: a quarter of its period has length K(1/2)/λ and the width (2 E − K)/λ."""
    length, along, across = rectangular_elastica(0.0, np.pi / 2, 4.0)
    assert length == pytest.approx(ellipk(0.5) / 2, rel=1e-12)
    assert along == pytest.approx((2 * ellipe(0.5) - ellipk(0.5)) / 2, rel=1e-12)
    assert across == pytest.approx(np.sqrt(2) / 2, rel=1e-12)


@pytest.mark.parametrize(("first", "last"), [(0.0, 0.6), (0.3, 0.9), (0.0, 1.2), (0.5, 1.4)])
@pytest.mark.parametrize("kind", ["sleeve", "clamp"])
def test_a_free_tail_that_hangs_out_of_a_sliding_support(first, last, kind):
    """The tail is straight and free of loads, so H is zero all along the part before it, a rectangular elastica; the
    support pushes with m²/2EI along the tail (Bigoni's configurational force)."""
    force = 3.0
    length, along, across = rectangular_elastica(first, last, force)
    angle = last - first
    place = np.array(
        [
            along * np.cos(first) + across * np.sin(first),
            0.0,
            across * np.cos(first) - along * np.sin(first),
        ]
    )
    quaternion = rotation.from_tangent(direction(angle))
    if kind == "clamp":
        # The frame of the clamp at the start, turned about y: no twist.
        quaternion = rotation.multiply(rotation.exponential([0, -angle, 0]), ALONG)
        held = Clamp(place, quaternion)
    else:
        held = Sleeve(place, direction(angle))
    solution = find_equilibrium(plane_scene([held], length=length + 0.3, tolerance=FINE))
    solution.raise_for_status()
    node, load = solution.support_nodes[0], solution.support_reactions[0]
    assert solution.arc_length[node] == pytest.approx(length, abs=NEAR)
    bend = np.sqrt(2 * force * np.cos(last))
    assert load.force @ direction(angle) == pytest.approx(-(bend**2) / 2, abs=NEAR * force)
    assert np.linalg.norm(load.force) == pytest.approx(force, rel=NEAR)
    assert np.linalg.norm(load.moment) == pytest.approx(bend, rel=NEAR)
    tail = solution.position[node:] - place
    straight = np.outer(solution.arc_length[node:] - length, direction(angle))
    assert np.abs(tail - straight).max() < NEAR


@pytest.mark.parametrize("kind", ["ring", "sleeve", "clamp"])
def test_sliding_finds_the_arc_length_with_the_least_energy(kind):
    place = [0.35, 0.02, 0.12]
    held = {
        "ring": Ring(place, [1, 0.1, 0], 0.001),
        "sleeve": Sleeve(place, [1, 0.1, 0]),
        "clamp": Clamp(place, rotation.from_tangent([1, 0.1, 0])),
    }[kind]
    scene = plane_scene([held], Clamped([0.8, 0, 0], ALONG), 20.0, elements=32)
    free = find_equilibrium(scene).raise_for_status()
    found = float(free.arc_length[free.support_nodes[0]])

    def energy(arc_length):
        given = replace(scene, supports=(replace(held, arc_length=arc_length),))
        # From the branch it is on, for others may be lower elsewhere.
        return find_equilibrium(given, start=free).raise_for_status().energy.total

    least = minimize_scalar(energy, bounds=(found - 0.004, found + 0.004), options={"xatol": 1e-5})
    # Of the same discrete energy; the scan stops within its own 1e-5.
    assert least.x == pytest.approx(found, abs=2e-5)
    # A clamp at a given arc length cuts the cable: its stretches have meshes of their own, good to 1e-4.
    assert least.fun == pytest.approx(free.energy.total, rel=2e-4 if kind == "clamp" else 1e-6)


def test_a_plane_cable_through_an_eyelet_as_scipy_sees_it():
    """Two stretches of EI θ'' = n × t, each on [0, 1], with their lengths as unknowns: at the eyelet position, angle,
    moment and n·t are continuous."""
    place, last = np.array([0.35, 0.12]), np.array([0.8, 0.0])
    eyelet = Ring([place[0], 0, place[1]], [1, 0, 0], 0.001)
    end = Clamped([last[0], 0, last[1]], ALONG)
    solution = find_equilibrium(plane_scene([eyelet], end, tolerance=FINE)).raise_for_status()
    node = solution.support_nodes[0]
    found = float(solution.arc_length[node])

    def rate(_, y, p):
        # Of each stretch x, z, θ, θ'; parameters its length of the first and both forces.
        rows = []
        for (_, _, theta, bend), length, force in (
            (y[:4], p[0], p[1:3]),
            (y[4:], 1 - p[0], p[3:5]),
        ):
            cos, sin = np.cos(theta), np.sin(theta)
            turn = force[0] * sin - force[1] * cos
            rows += [length * cos, length * sin, length * bend, length * turn]
        return np.array(rows)

    def ends(a, b, p):
        pull = [p[1 + i] * np.cos(b[2]) + p[2 + i] * np.sin(b[2]) for i in (0, 2)]
        return np.concatenate(
            [a[:3], b[:2] - place, a[4:8] - b[:4], b[4:6] - last, b[6:7], [pull[0] - pull[1]]]
        )

    u = np.linspace(0, 1, 41)
    angles = np.unwrap([np.arctan2(t[2], t[0]) for t in rotation.tangent(solution.quaternion)])
    columns = np.column_stack(
        [solution.position[:, 0], solution.position[:, 2], angles, -solution.moment[:, 1]]
    )
    # Started near the answer, for there are several, but not on it.
    guess = [
        np.array([np.interp(u * (b - a) + a, solution.arc_length, c) for c in columns.T])
        for a, b in ((0, found), (found, 1))
    ]
    forces = [solution.force[node, [0, 2]], solution.force[-1, [0, 2]]]
    start = 1.05 * np.concatenate([[found], *forces])
    exact = solve_bvp(rate, ends, u, np.vstack(guess), start, tol=1e-9, max_nodes=5000)
    assert exact.success
    assert found == pytest.approx(exact.p[0], abs=NEAR)
    scale = np.linalg.norm(exact.p[1:])
    assert np.concatenate(forces) == pytest.approx(exact.p[1:], abs=NEAR * scale)
    inside = solution.arc_length[: node + 1] / found
    x, z = exact.sol(inside)[:2]
    assert solution.position[: node + 1, 0] == pytest.approx(x, abs=10 * FINE)
    assert solution.position[: node + 1, 2] == pytest.approx(z, abs=10 * FINE)


@pytest.mark.parametrize("scheme", ["helix", "magnus"])
def test_order(scheme):
    """Halving the elements must cut the errors of arc length and energy by 2 to the order, 2 or 4. The support is half
    way, so that both stretches are halved."""
    tilted = Clamped([0.8, 0, 0], rotation.from_tangent(direction(0.5)))
    scene = plane_scene([Ring([0.4, 0, 0.12], [1, 0, 0], 0.001)], tilted, 5.0, length=1.1)

    def solve(elements, scheme=scheme):
        # The cable also slides to another place, at a little more energy; ipopt goes to the same one on all meshes.
        options = SolveOptions(elements=elements, scheme=scheme, solver="ipopt")
        return find_equilibrium(replace(scene, options=options)).raise_for_status()

    def read(solution):
        return np.array([solution.arc_length[solution.support_nodes[0]], solution.energy.total])

    exact = solve(128, "magnus")
    found = [solve(elements) for elements in (16, 32, 64)]
    errors = [np.abs(read(solution) - read(exact)) for solution in found]
    order = {"helix": 2, "magnus": 4}[scheme]
    assert -np.diff(np.log2(errors), axis=0) == pytest.approx(order, abs=0.4)
    # The estimate is one Newton step, right up to its square and to what its Runge-Kutta steps leave, and a tenth;
    # nodes are compared at the same share of a stretch.
    away = np.linalg.norm(found[1].position - exact.position[::4], axis=1).max()
    assert found[1].position_error == pytest.approx(1.1 * away, rel=0.2)


def test_both_solvers_agree():
    held = [Ring([0.35, 0.02, 0.12], [1, 0, 0], 0.02), Sleeve([0.6, 0, 0.1], [1, 0, -0.3])]
    scene = plane_scene(held, Clamped([0.8, 0, 0], ALONG), 5.0, length=1.1)
    found = [
        find_equilibrium(replace(scene, options=SolveOptions(solver=name, elements=48)))
        for name in ("fatrop", "ipopt")
    ]
    assert [each.solver["name"] for each in found] == ["fatrop", "ipopt"]
    # Barrier solvers leave 1e-9 over the force of the rim.
    assert np.abs(found[0].position - found[1].position).max() < 1e-6


def test_a_cable_that_slides_out_is_named():
    """A heavy one that hangs from its start over a ring: no catenary of span 0.3 pulls its end with less than
    0.754 · 0.3 w (Irvine), and its tail of 0.1 at most holds 0.1 w."""
    ring = Ring([0.3, 0, 0], [1, 0, 0], 0.001, place="supports[0]")
    scene = plane_scene([ring], weight=1e4, length=0.4)
    scene = replace(scene, start=Pinned([0, 0, 0], place="start"))
    solution = find_equilibrium(scene)
    assert solution.status is Status.NOT_CONVERGED
    assert "slides through supports[0]" in solution.message
