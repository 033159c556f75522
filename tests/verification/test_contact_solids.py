# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contact with solids: the same solid said in other words, balance, and what must not change the answer."""

from dataclasses import replace

import numpy as np
import pytest

from benchmarks.among import curve
from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.geometry import rotation
from freecad_cable.problem import (
    Box,
    Clamped,
    Cylinder,
    HalfSpace,
    Mesh,
    Pinned,
    Rod,
    Scene,
    Sleeve,
    Sphere,
    Tube,
    round_section,
)

FLOOR = HalfSpace([0, 0, -0.05], [0, 0, 1])
ACROSS = Cylinder([-0.3, -0.24, -0.12], [0.4, -0.24, -0.12], 0.05)
BALL = Sphere([0.045, -0.24, -0.1], 0.05)
CASES = {
    "floor": FLOOR,
    "slope": HalfSpace([0, 0, -0.04], [0.3, 0.2, 1]),
    "sphere": BALL,
    "sphere in the way": Sphere([0.02, -0.2, -0.04], 0.08),
    "cylinder": ACROSS,
    "box in the way": Box([0.045, -0.22, -0.05], [1, 0, 0, 0], [0.1, 0.1, 0.1]),
    "thin plate": Box([0.045, -0.22, -0.05], [1, 0, 0, 0], [0.3, 0.3, 0.002]),
    "long bar": Cylinder([0.03, -1, -0.06], [0.03, 1, -0.06], 0.05),
}


@pytest.fixture(scope="module")
def solved():
    return {}


@pytest.fixture
def solve(table_1, solved):
    """Solution of Table 1 (0.73 m) among obstacles; solved once for all tests."""

    def find(*obstacles, **more):
        key = (*map(id, obstacles), *sorted(more.items()))
        if key not in solved:
            scene = replace(table_1(0.73), obstacles=obstacles, **more)
            solved[key] = find_equilibrium(scene).raise_for_status(), obstacles
        return solved[key][0]

    return find


def fine(solution):
    """Points between the nodes, on the cubic that positions and tangents define."""
    s = solution.arc_length
    return curve(solution)(np.interp(np.linspace(0, len(s) - 1, 16 * len(s)), np.arange(len(s)), s))


def of_cylinder(sides):
    """A mesh in a cylinder along x as long and as thick as ``ACROSS``."""
    angle = 2 * np.pi * np.arange(sides) / sides
    ring = np.column_stack([np.zeros(sides), np.cos(angle), np.sin(angle)]) * ACROSS.radius
    vertices = np.vstack([ring + ACROSS.start, ring + ACROSS.end, [ACROSS.start, ACROSS.end]])
    i = np.arange(sides)
    j = (i + 1) % sides
    first, last = np.full(sides, 2 * sides), np.full(sides, 2 * sides + 1)
    sheets = [(i, j + sides, i + sides), (i, j, j + sides), (first, j, i)]
    sheets.append((last, i + sides, j + sides))
    triangles = np.vstack([np.column_stack(sheet) for sheet in sheets])
    mesh = [triangles, triangles[:, ::-1]]
    volume = np.einsum(
        "ti,ti->t",
        vertices[triangles[:, 0]] - ACROSS.start,
        np.cross(
            vertices[triangles[:, 1]] - ACROSS.start, vertices[triangles[:, 2]] - ACROSS.start
        ),
    )
    return Mesh(vertices, mesh[int(volume.sum() < 0)])


@pytest.mark.parametrize("name", CASES)
def test_no_penetration_and_balance(solve, name):
    obstacle = CASES[name]
    solution = solve(obstacle)
    scene = solution.scene
    gap = obstacle.nearest(fine(solution)).distance - scene.rod.radius
    # In contact, and nowhere deeper than 1 % of the radius.
    assert abs(gap.min()) < 0.01 * scene.rod.radius
    assert solution.min_clearance == pytest.approx(gap.min(), abs=0.01 * scene.rod.radius)
    assert solution.stable
    carried = sum(contact.force for contact in solution.contacts)
    forces = solution.start_reaction.force + solution.end_reaction.force + carried
    # Exact in the discrete problem, but for the bounds that do not act: those push less than they are far, so with
    # 1e-10 as what the solver leaves of the product at most 1e-5 each; fewer than twenty are as near as that.
    assert np.abs(forces + scene.weight * scene.rod.length).max() < 2e-4 * np.linalg.norm(
        scene.weight * scene.rod.length
    )
    for contact in solution.contacts:
        place = [np.interp(contact.arc_length, solution.arc_length, c) for c in solution.position.T]
        assert obstacle.nearest(np.array([place])).normal[0] @ contact.force > 0


@pytest.mark.parametrize("name", ["sphere", "sphere in the way"])
def test_a_ball_pushes_from_its_centre(solve, name):
    ball = CASES[name]
    for contact in solve(ball).contacts:
        solution = solve(ball)
        place = [np.interp(contact.arc_length, solution.arc_length, c) for c in solution.position.T]
        lever = place - ball.center
        moment = np.linalg.norm(np.cross(lever, contact.force))
        # The place is the mean of the force along the cable, which lies on the ball over some of it.
        assert moment < 0.05 * np.linalg.norm(lever) * np.linalg.norm(contact.force)


def test_the_top_of_a_box_is_a_plane(solve):
    box = Box([0, 0, -0.15], [1, 0, 0, 0], [2, 2, 0.2])
    one, other = solve(FLOOR), solve(box)
    # Both to the tolerance of 1e-4 of the length.
    there = np.stack([np.interp(one.arc_length, other.arc_length, c) for c in other.position.T], 1)
    assert np.abs(there - one.position).max() < 2e-4 * 0.73
    assert other.energy.total == pytest.approx(one.energy.total, rel=1e-4)


def test_a_mesh_of_a_cylinder(solve):
    exact = solve(ACROSS)
    force = sum(np.linalg.norm(contact.force) for contact in exact.contacts)
    energies = []
    for sides in (16, 48):
        solution = solve(of_cylinder(sides))
        sagitta = ACROSS.radius * (1 - np.cos(np.pi / sides))
        # Lowering the obstacle by δ frees at most the work of its force over δ; the mesh is between the cylinder and
        # one thinner by the sagitta. The rest is what both solutions leave, 1e-5 of the energy.
        freed = exact.energy.total - solution.energy.total
        assert -1e-5 * exact.energy.total < freed < force * sagitta + 1e-5 * exact.energy.total
        energies.append(solution.energy.total)
    assert abs(energies[1] - exact.energy.total) < abs(energies[0] - exact.energy.total)


def test_clearance_is_a_thicker_obstacle(solve):
    one = solve(BALL, clearance=0.01)
    other = solve(Sphere(BALL.center, BALL.radius + 0.01))
    # Places are looked for within the distance to keep, which is not the same.
    assert np.abs(one.position - other.position).max() < one.position_error + other.position_error
    assert one.min_clearance == pytest.approx(0.01, abs=0.01 * 0.0035)


@pytest.mark.parametrize("seed", [0, 30, 76, 95, 153, 159])
def test_the_clearance_is_that_of_the_nearest_of_many(table_1, solved, seed):
    """Boxes around the free cable, turned so that those around which their own boxes are nearer may be farther."""
    if "free" not in solved:
        solved["free"] = find_equilibrium(table_1(0.73)).raise_for_status()
    free, random, boxes = solved["free"], np.random.default_rng(seed), []
    places = curve(free)(np.linspace(0, 0.73, 20001))
    while len(boxes) < 6:
        centre = places[random.integers(len(places))] + 0.08 * random.normal(size=3)
        turn, size = random.normal(size=4), random.uniform(0.005, 0.12, 3)
        box = Box(centre, turn / np.linalg.norm(turn), size)
        away = box.nearest(places).distance
        # What is nearest to an end is that to which the end is fastened.
        if away.min() > 0.0036 and 300 < np.argmin(away) < 19700:
            boxes.append(box)
    solution = find_equilibrium(replace(free.scene, obstacles=tuple(boxes)))
    true = min(box.nearest(places).distance.min() for box in boxes) - 0.0035
    # Between two of 64 samples of one of 32 elements nothing is nearer by more than half their distance.
    assert solution.min_clearance - true == pytest.approx(0, abs=0.73 / 32 / 128)


def test_obstacles_out_of_the_way_change_nothing(solve, table_1):
    alone = find_equilibrium(table_1(0.73))
    out_of_reach = Sphere([5, 5, 5], 0.1)
    beside = Sphere([0.3, 0.3, 0.3], 0.05)
    for obstacle in (out_of_reach, beside):
        solution = solve(obstacle)
        assert (solution.position == alone.position).all()
        assert solution.solver["iterations"] == alone.solver["iterations"]
        assert any("obstacles" in sentence for sentence in solution.left_out)
    one, other = solve(FLOOR), solve(FLOOR, out_of_reach)
    assert (one.position == other.position).all()


def test_the_order_of_obstacles(solve):
    wall = HalfSpace([0, -0.22, 0], [0, 1, 0.5])
    one, other = solve(FLOOR, wall, BALL), solve(BALL, FLOOR, wall)
    assert np.abs(one.position - other.position).max() < 1e-6
    assert {c.obstacle for c in other.contacts} == {(c.obstacle + 1) % 3 for c in one.contacts}


def test_rigid_motion(solve):
    shift, turn = np.array([3.0, -1.0, 2.0]), rotation.exponential([0.4, -1.1, 0.8])
    there = lambda point: rotation.rotate(turn, np.asarray(point)) + shift  # noqa: E731
    here = solve(BALL)
    scene = here.scene
    start, end = (
        Clamped(there(e.position), rotation.multiply(turn, e.quaternion))
        for e in (scene.start, scene.end)
    )
    moved = replace(
        scene,
        start=start,
        end=end,
        gravity=rotation.rotate(turn, scene.gravity),
        obstacles=(Sphere(there(BALL.center), BALL.radius),),
    )
    solution = find_equilibrium(moved).raise_for_status()
    # The start is swayed along an eigenvector, which rounding turns: each is within the tolerance of the answer, and
    # its nodes are gathered elsewhere.
    assert np.abs(curve(solution)(here.arc_length) - there(here.position)).max() < 2e-4 * 0.73
    assert solution.energy.total == pytest.approx(here.energy.total, rel=1e-5)


ROUND = {
    "ball": BALL,
    "aside": Sphere([-0.0368, -0.0959, -0.0276], 0.0645),
    "before": Sphere([0.0869, -0.2622, 0.0804], 0.069),
    "slanted": Cylinder([0.1524, -0.0509, 0.2184], [-0.117, -0.6904, 0.1667], 0.0465),
    "short": Cylinder([0.1331, -0.1891, 0.1752], [-0.0123, -0.3278, 0.2007], 0.0318),
}
"""On these a cable slides almost without resistance: where it touches, and so its shape, follows from little."""


@pytest.mark.parametrize("name", ROUND)
def test_the_estimate_is_no_less_than_the_error(solve, distance, name):
    coarse = solve(ROUND[name])
    options = replace(coarse.scene.options, tolerance=1e-6)
    best = find_equilibrium(replace(coarse.scene, options=options), start=coarse)
    assert distance(coarse, best) <= coarse.position_error + best.position_error
    assert best.position_error < coarse.position_error / 2


def test_another_cable_is_not_moved_and_that_is_said(solve):
    """A tube where the straight bar is: the same answer, and what the other cable would feel."""
    bar = CASES["long bar"]
    other = Tube([bar.start, bar.end], bar.radius, place="obstacles[0]")
    solution, as_a_bar = solve(other), solve(bar)
    # Each within its own tolerance of the same answer.
    assert solution.energy.total == pytest.approx(as_a_bar.energy.total, rel=1e-5)
    (contact,) = solution.contacts
    (said,) = (each for each in solution.left_out if each.startswith("obstacles[0]"))
    assert f"up to {np.linalg.norm(contact.force):.2g} N" in said
    assert not any("taken as rigid: pushed" in each for each in as_a_bar.left_out)


@pytest.mark.parametrize("lift", [0.005, -0.01])
def test_a_cable_that_slides_and_touches(table_1, lift):
    """Where it slides, supports are at other arc lengths from mesh to mesh; that is no change of the shape."""
    free = find_equilibrium(table_1(0.73))
    place, tangent = free.position[20] + [0, 0, lift], rotation.tangent(free.quaternion[20])
    ball = Sphere([0.02, -0.2, -0.04], 0.05)
    scene = replace(table_1(0.73), supports=(Sleeve(place, tangent),), obstacles=(ball,))
    assert find_equilibrium(scene).raise_for_status().contacts


def test_no_clearance_however_large_lets_a_cable_through():
    """What is beside a connector need not keep the clearance that the connector itself has not, but be outside."""
    rib = Box([0.02, 0, -0.032], [1, 0, 0, 0], [0.024, 0.2, 0.07])
    rod = Rod(length=0.05, **round_section(0.003, 10e6, 20e6, 1160.0))
    along = rotation.from_tangent(np.array([1.0, 0, 0]))
    start, end = Clamped([0, 0, 0], along), Clamped([0.04, 0, 0], along)
    down = [0, 0, -9.81]
    scene = Scene(rod=rod, start=start, end=end, gravity=down, obstacles=(rib,), clearance=0.02)
    found = find_equilibrium(scene)
    assert not found.status.success
    assert "than its radius allows" in found.message
    assert found.min_clearance < -0.01


@pytest.mark.parametrize("share", [0.31, 0.505, 0.717])
def test_the_clearance_of_a_thin_wire_beside_a_pellet(share):
    """On elements a hundred times as long as the wire is thin, between whose samples a pellet hides."""
    rod = Rod(length=1.0, **round_section(5e-4, 1e10, 2e10, 1160.0))
    ends = {"start": Pinned([0, 0, 0]), "end": Pinned([0.9, 0, 0])}
    alone = Scene(rod=rod, gravity=[0, 0, -9.81], **ends)
    wire = curve(find_equilibrium(alone).raise_for_status())
    pellet, gap = 2 * rod.radius, 1.5 * rod.radius
    center = wire(share) + [0, pellet + gap + rod.radius, 0]
    beside = replace(alone, obstacles=(Sphere(center, pellet),))
    found = find_equilibrium(beside).raise_for_status()
    away = np.linalg.norm(curve(found)(np.linspace(0, 1, 200_001)) - center, axis=1)
    assert found.min_clearance == pytest.approx(away.min() - pellet - rod.radius, abs=0.01 * gap)
