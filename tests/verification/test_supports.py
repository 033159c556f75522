# SPDX-License-Identifier: LGPL-2.1-or-later
"""Supports: what they exert, against the free cable, separate cables, and the balance of bodies.

Loads and energies of one discrete problem are compared at the solver's tolerance (SAME), different discretisations at
the tolerance asked for.
"""

from dataclasses import replace

import numpy as np
import pytest

from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.geometry import rotation
from freecad_cable.problem import Clamp, Clamped, Clip, Free, Ring, Rod, Scene, Sleeve
from freecad_cable.result import support_violation
from freecad_cable.status import Status

SAME = 1e-7
"""Both runs solve the same discrete problem, to 1e-9 of the scaled optimality conditions."""
KINDS = ("clamp", "sleeve", "clip", "ring", "eyelet")


def support(kind, position, quaternion, arc_length=None, **more):
    tangent = rotation.tangent(quaternion)
    if kind == "clamp":
        return Clamp(position, quaternion, arc_length=arc_length, **more)
    if kind in ("ring", "eyelet"):
        radius = 0.01 if kind == "ring" else 0.0035
        return Ring(position, tangent, radius, arc_length=arc_length, **more)
    return {"sleeve": Sleeve, "clip": Clip}[kind](position, tangent, arc_length=arc_length, **more)


def beside(free, kind, node=12, offset=(0.03, 0.02, -0.02), *, slides):
    """A support beside a node of a free cable."""
    arc_length = None if slides else float(free.arc_length[node])
    return support(kind, free.position[node] + offset, free.quaternion[node], arc_length)


@pytest.mark.parametrize("slides", [False, True])
@pytest.mark.parametrize("kind", KINDS)
def test_a_support_where_the_free_cable_is_exerts_nothing(table_1, kind, slides):
    scene = table_1(0.73, elements=32)
    free = find_equilibrium(scene)
    there = beside(free, kind, node=16, offset=(0, 0, 0), slides=slides)
    held = find_equilibrium(replace(scene, supports=(there,))).raise_for_status()
    # At half the length both have the same nodes, but the strain may jump there and the nodes slide along: what
    # that changes is within the error of the mesh.
    tolerance = 1e-5
    weight = np.linalg.norm(scene.weight) * 0.73
    assert np.abs(held.support_reactions[0].force).max() < 100 * tolerance * weight
    assert np.abs(held.support_reactions[0].moment).max() < 100 * tolerance * weight * 0.73
    assert held.energy.total == pytest.approx(free.energy.total, rel=1e-6)
    if not slides:
        assert np.abs(held.position - free.position).max() < free.position_error


@pytest.mark.parametrize("slides", [False, True])
@pytest.mark.parametrize("kind", KINDS)
def test_what_a_support_may_exert(table_1, kind, slides):
    """A ring never turns and pushes only along its axis and from its rim; a sleeve does not twist; a sliding support
    lets n·t + m²/2EI through, and a ring with it n·t."""
    scene = table_1(0.73, tolerance=1e-6)
    free = find_equilibrium(scene)
    held = beside(free, kind, slides=slides)
    solution = find_equilibrium(replace(scene, supports=(held,))).raise_for_status()
    node, load = solution.support_nodes[0], solution.support_reactions[0]
    tangent = rotation.tangent(solution.quaternion[node])
    size = np.linalg.norm(load.force)
    assert size > 0.01
    if kind in ("ring", "eyelet"):
        assert np.abs(load.moment).max() < SAME
    if kind in ("sleeve", "clip"):
        assert abs(load.moment @ tangent) < SAME
    offset = solution.position[node] - held.position
    if kind == "ring":
        # It leans on the rim, which pushes it back.
        assert np.linalg.norm(offset) == pytest.approx(0.01 - 0.0035, abs=1e-6)
        across = load.force - (load.force @ held.axis) * held.axis
        assert np.cross(across, offset) == pytest.approx(np.zeros(3), abs=1e-5 * size)
        assert across @ offset < 0
    if slides:
        # The program lets through what the derivative of its own energy by the length says, an order-4 reading.
        assert flux(solution, node, load) == pytest.approx(flux(solution, node), abs=1e-5 * size)
        if kind in ("ring", "eyelet"):
            assert load.force @ tangent == pytest.approx(0.0, abs=1e-5 * size)
    else:
        assert solution.arc_length[node] == pytest.approx(held.arc_length, abs=1e-12)


def flux(solution, node, load=None):
    """n·t + m·K⁻¹m/2 before a support, or beyond it: of a straight rod what a frictionless support lets through."""
    force, moment = solution.force[node], solution.moment[node]
    if load is not None:
        force, moment = force - load.force, moment - load.moment
    frame = rotation.matrix(solution.quaternion[node])
    bending = frame.T @ moment
    return force @ frame[:, 2] + bending @ (bending / solution.scene.rod.stiffness) / 2


def test_a_ring_with_room_to_spare_does_nothing(table_1):
    scene = table_1(0.73)
    free = find_equilibrium(scene)
    position = free.position[12] + [0.002, 0.0, 0.001]
    ring = Ring(position, rotation.tangent(free.quaternion[12]), 0.1)
    held = find_equilibrium(replace(scene, supports=(ring,))).raise_for_status()
    assert np.abs(held.support_reactions[0].force).max() < 1e-5
    assert held.energy.total == pytest.approx(free.energy.total, rel=1e-5)


def test_a_clamp_at_an_arc_length_makes_two_cables(table_1):
    scene = table_1(0.73, elements=32)
    free = find_equilibrium(scene)
    clamp = beside(free, "clamp", node=16, slides=False)
    both = find_equilibrium(replace(scene, supports=(clamp,))).raise_for_status()
    here = Clamped(clamp.position, clamp.quaternion, place="start")
    alone = [
        find_equilibrium(replace(scene, rod=rod, start=start, end=end, options=options))
        for start, end in ((scene.start, here), (here, scene.end))
        for rod in [replace(scene.rod, length=0.365)]
        for options in [replace(scene.options, elements=16)]
    ]
    node = both.support_nodes[0]
    assert node == 16
    for part, nodes in zip(alone, (slice(0, 17), slice(16, 33)), strict=True):
        assert np.abs(part.position - both.position[nodes]).max() < SAME
        # At the support force and moment are those just before it.
        inner = slice(1, None)
        assert np.abs(part.force[inner] - both.force[nodes][inner]).max() < 1e-6
        assert np.abs(part.moment[inner] - both.moment[nodes][inner]).max() < SAME
    reaction = alone[0].end_reaction.force + alone[1].start_reaction.force
    assert both.support_reactions[0].force == pytest.approx(reaction, abs=1e-6)
    # Gravity is measured from the start of the cable, of the second from the clamp.
    datum = -scene.weight * 0.365 @ (clamp.position - scene.start.position)
    total = sum(part.energy.total for part in alone) + datum
    assert both.energy.total == pytest.approx(total, abs=1e-9)


@pytest.mark.parametrize("weight", [0.0, 1.0, 1e4])
@pytest.mark.parametrize("kinds", ["clip", "ring", "sleeve clip ring"])
def test_reactions_carry_the_cable(kinds, weight):
    """Force balance of the whole cable and of each stretch, moment balance of each stretch without weight."""
    places = {1: [0.5], 3: [0.25, 0.5, 0.75]}[len(kinds.split())]
    held = [
        support(
            kind,
            [0.8 * s, 0.02, 0.06],
            rotation.from_tangent([1, 0, 0]),
            s if kind == "clip" else None,
            place=f"supports[{i}]",
        )
        for i, (kind, s) in enumerate(zip(kinds.split(), places, strict=True))
    ]
    solution = find_equilibrium(bench(held, weight)).raise_for_status()
    scene = solution.scene
    loads = [solution.start_reaction, *solution.support_reactions, solution.end_reaction]
    forces = sum(load.force for load in loads)
    scale = weight + max(np.linalg.norm(load.force) for load in loads)
    assert np.abs(forces + scene.weight).max() < SAME * scale
    nodes = [0, *solution.support_nodes, len(solution.arc_length) - 1]
    for j, (a, b) in enumerate(zip(nodes, nodes[1:], strict=False)):
        force, moment = solution.force[a], solution.moment[a]
        if j:
            force, moment = force - loads[j].force, moment - loads[j].moment
        length = solution.arc_length[b] - solution.arc_length[a]
        missing = solution.force[b] - force + length * scene.weight
        assert np.abs(missing).max() < SAME * scale
        if weight == 0:
            arm = solution.position[b] - solution.position[a]
            turned = solution.moment[b] - moment + np.cross(arm, solution.force[b])
            assert np.abs(turned).max() < SAME * scale
    assert (
        support_violation(
            scene,
            solution.support_nodes,
            solution.arc_length,
            solution.position,
            solution.quaternion,
        )
        < SAME
    )


def bench(supports, weight=0.0, end=None, start=None, rod=None, **options):
    """EI = L = 1, clamped along x 0.8 apart."""
    along = rotation.from_tangent([1.0, 0, 0])
    values = {
        "length": 1.0,
        "radius": 0.0035,
        "mass_per_length": weight / 9.81,
        "bending_stiffness": 1.0,
        "torsional_stiffness": 0.8,
    }
    scene = Scene(
        rod=Rod(**(values | (rod or {}))),
        start=start or Clamped([0, 0, 0], along, place="start"),
        end=end or Clamped([0.8, 0, 0], along),
        supports=tuple(supports),
    )
    return replace(scene, options=replace(scene.options, **options))


@pytest.mark.parametrize(
    "rod",
    [
        {"axial_stiffness": 2e3, "shear_stiffness": 1e3},
        {"bending_stiffness": [1.0, 2.5], "natural_curvature": [1.0, -0.5, 0.7]},
    ],
)
@pytest.mark.parametrize("scheme", ["helix", "magnus"])
def test_the_general_rod_and_both_schemes(rod, scheme):
    """Sliding: the flux H = n·r' + m·κ − W is the same on both sides, with stretch, shear and natural curvature."""
    held = (
        Ring([0.3, 0.03, 0.05], [1, 0, 0.2], 0.0035),
        Sleeve([0.6, -0.02, 0.05], [1, 0.1, 0]),
    )
    solution = find_equilibrium(bench(held, 5.0, rod=rod, scheme=scheme)).raise_for_status()
    law = solution.scene.rod
    soft = (
        np.array([1 / law.shear_stiffness] * 2 + [1 / law.axial_stiffness])
        if law.axial_stiffness
        else 0
    )
    scale = max(np.linalg.norm(load.force) for load in solution.support_reactions)
    for node, load in zip(solution.support_nodes, solution.support_reactions, strict=True):
        frame = rotation.matrix(solution.quaternion[node])
        found = []
        for share in (0, 1):
            n = frame.T @ (solution.force[node] - share * load.force)
            m = frame.T @ (solution.moment[node] - share * load.moment)
            bend = m / law.stiffness
            strain = n * soft
            energy = (m @ bend + n @ strain) / 2
            found.append(n @ ([0, 0, 1] + strain) + m @ (law.natural_curvature + bend) - energy)
        # The discrete flux is that of the true one to the order of the scheme, at the mesh's 1e-4.
        assert found[0] == pytest.approx(found[1], abs=1e-2 * scale)


def test_many_supports_close_to_each_other_and_to_the_ends():
    rings = [
        Ring([0.08 * i, 0, 0.004 * (-1) ** i], [1, 0, 0], 0.006, place=f"supports[{i - 1}]")
        for i in range(1, 10)
    ]
    near = [
        Sleeve([0.005, 0, 0], [1, 0, 0]),
        Ring([0.4, 0, 0.05], [1, 0, 0], 0.0045),
        Ring([0.404, 0, 0.05], [1, 0, 0], 0.0045),
    ]
    for held in (rings, near):
        assert find_equilibrium(bench(held, 10.0)).status is Status.CONVERGED


@pytest.mark.parametrize("slides", [False, True])
def test_free_ends(slides):
    """A cable over a hook: a clip and, hanging, a ring or a clip; nothing at the ends."""
    ring = Ring([0.4, 0, 0], [1, 0, 0], 0.01, arc_length=None if slides else 0.7)
    clip = Clip([0, 0, 0], [1, 0, 0], arc_length=0.2)
    scene = bench([clip, ring], 20.0, start=Free(place="start"), end=Free())
    solution = find_equilibrium(scene).raise_for_status()
    for node in (0, -1):
        assert np.abs(solution.force[node]).max() < 1e-6
        assert np.abs(solution.moment[node]).max() < 1e-6
    lifted = sum(load.force for load in solution.support_reactions)
    assert lifted == pytest.approx([0, 0, 20.0], abs=1e-6)


@pytest.mark.parametrize("slides", [False, True])
@pytest.mark.parametrize("kind", KINDS)
def test_a_warm_start_carries_the_supports(table_1, kind, slides):
    scene = table_1(0.73)
    free = find_equilibrium(scene)
    held = beside(free, kind, slides=slides)
    first = find_equilibrium(replace(scene, supports=(held,))).raise_for_status()
    nudged = replace(held, position=held.position + [0.003, 0.0, 0.0])
    if not slides:
        nudged = replace(nudged, arc_length=held.arc_length + 0.002)
    nearby = replace(scene, supports=(nudged,))
    warm = find_equilibrium(nearby, start=first).raise_for_status()
    cold = find_equilibrium(nearby)
    assert warm.energy.total == pytest.approx(cold.energy.total, rel=1e-5)
    assert warm.solver["iterations"] < cold.solver["iterations"]
    # One with other supports, or that was elsewhere, is no start.
    far = replace(held, position=held.position + [0.0, 0.0, 0.1])
    for other in (scene, replace(scene, supports=(far,))):
        ignored = find_equilibrium(other, start=first)
        assert ignored.solver["iterations"] == find_equilibrium(other).solver["iterations"]
