# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contact against closed forms: a cable laid down on a floor, and one drawn over a cylinder."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.geometry import rotation
from freecad_cable.options import SolveOptions
from freecad_cable.problem import Clamped, Cylinder, Free, HalfSpace, Mesh, Rod, Scene, Sphere

RADIUS = 0.01
ALONG_X = rotation.exponential([0, np.pi / 2, 0])

# Height of the clamp over the floor; arc length and x of the touch-down, force of the floor at it. From the first
# integral of the planar rod and shooting on the arc length, with EI = w = 1.
LAID_DOWN = [
    (0.1, 1.639645195245, 1.635456410325, 0.545849190069),
    (1.0, 3.006510963490, 2.766575251021, 0.960150222923),
]


def rod(length, **more):
    return Rod(length=length, radius=RADIUS, bending_stiffness=1.0, torsional_stiffness=1.0, **more)


def laid_down(height, tolerance=1e-5):
    return Scene(
        rod=rod(5.0, mass_per_length=1.0),
        start=Clamped([0, 0, height + RADIUS], ALONG_X, place="start"),
        end=Free(),
        gravity=[0, 0, -1.0],
        obstacles=(HalfSpace([0, 0, 0], [0, 0, 1]),),
        options=SolveOptions(tolerance=tolerance),
    )


@pytest.mark.parametrize(("height", "arc_length", "x", "force"), LAID_DOWN)
def test_laid_down_on_a_floor(height, arc_length, x, force):
    solution = find_equilibrium(laid_down(height)).raise_for_status()
    # A node lies where the floor begins to push, to the width of the last mesh there, 5/64/6² = 2e-3; the moment at
    # the clamp changes by its square, the force by 1e-3 of it.
    assert np.linalg.norm(solution.start_reaction.moment) == pytest.approx(
        np.sqrt(2 * height), rel=1e-3
    )
    assert solution.start_reaction.force[2] == pytest.approx(arc_length - force, rel=1e-3)
    carried = sum(contact.force for contact in solution.contacts)
    assert carried[2] == pytest.approx(5.0 - arc_length + force, rel=1e-3)
    assert np.abs(carried[:2]).max() < 1e-9
    # What lies on the floor is carried by it; before that the rod carries the point force.
    last = np.flatnonzero(np.abs(solution.force[:, 2]) > force / 2)[-1]
    assert solution.arc_length[last] == pytest.approx(arc_length, abs=1e-2)
    assert solution.position[last, 0] == pytest.approx(x, abs=1e-2)


@pytest.mark.parametrize("tolerance", [1e-3, 1e-4, 1e-5])
@pytest.mark.parametrize(("height", "arc_length", "x", "force"), LAID_DOWN)
def test_the_tolerance_is_kept_over_a_floor(height, arc_length, x, force, tolerance):
    solution = find_equilibrium(laid_down(height, tolerance)).raise_for_status()

    def slope(s, y):
        angle, curvature = y[2:]
        return np.cos(angle), np.sin(angle), curvature, (arc_length - force - s) * np.cos(angle)

    # The moment at the clamp bends the rod down.
    first = [0, height + RADIUS, 0, -np.sqrt(2 * height)]
    s = np.minimum(solution.arc_length, arc_length)
    exact = solve_ivp(slope, (0, arc_length), first, dense_output=True, rtol=1e-11, atol=1e-12)
    plane = exact.sol(s)[:2]
    plane[0] += solution.arc_length - s
    error = np.hypot(*(solution.position[:, [0, 2]].T - plane)).max()
    assert error < tolerance * 5.0
    assert solution.position_error <= tolerance * 5.0


# Effective radius 0.2, pull 200, EI = 1, clamps that point down 2 below the axis: far against the bending length
# √(EI/T), so that the pull is that of an infinitely long rod to 1e-12.
PULL, EFFECTIVE = 200.0, 0.2
HALF_ANGLE = np.pi / 2 - np.arccos(1 - 1 / (2 * PULL * EFFECTIVE**2))


def draped(height=0.0):
    """The scene, its cylinder ``height`` higher than the closed form has it."""
    reach, lift = 2.0, np.pi / 2 - HALF_ANGLE
    a = EFFECTIVE * np.cos(lift) + 1 / (EFFECTIVE * PULL)
    straight = reach + EFFECTIVE * np.sin(lift) + 2 / np.sqrt(PULL) * (1 - np.cos(lift / 2))
    length = 2 * (EFFECTIVE * HALF_ANGLE + straight)
    up, down = [1, 0, 0, 0], rotation.exponential([0, np.pi, 0])
    return Scene(
        rod=rod(length, mass_per_length=0.0),
        start=Clamped([-a, 0, -reach], up, place="start"),
        end=Clamped([a, 0, -reach], down),
        obstacles=(Cylinder([0, -1, height], [0, 1, height], EFFECTIVE - RADIUS),),
    )


@pytest.fixture(scope="module")
def over():
    """By itself the cable hangs below the top of the cylinder; it is caught when that comes from below."""
    solution = None
    for height in (-0.25, -0.15, -0.05, 0.0):
        solution = find_equilibrium(draped(height), start=solution).raise_for_status()
    fine = replace(draped(), options=SolveOptions(tolerance=5e-8))
    return find_equilibrium(fine, start=solution).raise_for_status()


def test_drawn_over_a_cylinder(over):
    solution, scene, half_angle = over, over.scene, HALF_ANGLE
    assert scene.rod.length == pytest.approx(4.629798653446, abs=1e-11)
    assert half_angle == pytest.approx(1.215375125105, abs=1e-11)
    assert solution.energy.total == pytest.approx(6.967774492147, rel=1e-4)
    assert solution.start_reaction.force[2] == pytest.approx(-PULL, rel=1e-2)
    assert sum(c.force for c in solution.contacts)[2] == pytest.approx(2 * PULL, rel=1e-2)
    # The rod lies on the cylinder between the points of lift-off; from there the gap grows like 69.6 s³/6, so that it
    # is seen 0.01 rad later.
    angle = np.arctan2(solution.position[:, 0], solution.position[:, 2])
    lies = np.hypot(solution.position[:, 0], solution.position[:, 2]) < EFFECTIVE + 1e-7
    assert np.abs(angle[lies]).max() == pytest.approx(half_angle, rel=2e-2)
    # The point force at lift-off, with what the pressure adds over the window in which it is caught.
    s, middle, window = solution.arc_length, scene.rod.length / 2, 0.02
    lift_off = middle - EFFECTIVE * half_angle
    at = lambda s0: np.array([np.interp(s0, s, column) for column in solution.force.T])  # noqa: E731
    caught = np.linalg.norm(at(lift_off + window) - at(lift_off - window))
    # The pressure acts on nodes: at either end of the window a node's share of it may be in or out.
    inside = np.abs(s - lift_off) < window
    share = 937.5 * np.diff(s)[inside[:-1]].max()
    assert caught - 937.5 * window == pytest.approx(69.597054535, abs=2 * share)
    assert 2 * share < 0.25 * 69.6


def test_a_cable_slides_off_the_top_of_a_ball(over):
    """Drawn over a ball it is in balance as over a cylinder, but any path beside the top is shorter."""
    there = (Sphere([0, 0, 0], EFFECTIVE - RADIUS),)
    ball = replace(over.scene, obstacles=there, options=SolveOptions())
    solution = find_equilibrium(ball, start=over).raise_for_status()
    assert solution.energy.total < 0.9 * over.energy.total
    assert np.abs(solution.position[:, 1]).max() > EFFECTIVE / 2


@pytest.mark.parametrize("inside", [0.05, 0.1])
def test_held_a_little_inside_the_floor(inside):
    """By ``inside`` radii, along it. Over the first √(2 δ 10 r) it may be as deep, and there it lies on the floor: a
    clamped beam that rises by δ over a length d has the curvature 3 δ/d² at the clamp, and so a radius of 10 r / 1.5.
    """
    solution = find_equilibrium(laid_down(-inside * RADIUS, 2e-5)).raise_for_status()
    # A beam shortens by (dδ/dx)², 1 % at most; the moment at the clamp is of an element of 1e-3 d.
    assert solution.min_bend_radius == pytest.approx((10 * RADIUS / 1.5, 0.0), rel=0.02)


@pytest.mark.parametrize("length", [0.2, 2.0])
def test_the_clearance_is_that_of_an_end_where_this_is_nearest(length):
    """A ball behind the start of a cable that leads away from it, whatever the length of an element."""
    ball = Sphere([-0.01 - RADIUS, 0, 0], 0.5 * RADIUS)
    straight = Scene(
        rod=rod(length, mass_per_length=0.0),
        start=Clamped([0, 0, 0], ALONG_X),
        end=Free(),
        obstacles=[ball],
    )
    assert find_equilibrium(straight).min_clearance == pytest.approx(0.01 - 0.5 * RADIUS)


def test_behind_an_open_mesh_is_inside_at_any_depth():
    """A sheet over the middle of a cable that would hang behind it: it comes to the front."""
    corners = [[x, y, 0.02] for x, y in ((0.1, -0.2), (0.4, -0.2), (0.4, 0.2), (0.1, 0.2))]
    sheet = Mesh(corners, [[0, 1, 2], [0, 2, 3]])
    scene = Scene(
        rod=Rod(
            length=0.6,
            radius=0.004,
            mass_per_length=0.08,
            bending_stiffness=0.01,
            torsional_stiffness=8e-3,
        ),
        start=Clamped([0, 0, 0], ALONG_X),
        end=Clamped([0.5, 0.02, 0], ALONG_X),
        gravity=[0, 0, -9.81],
        obstacles=[sheet],
    )
    solution = find_equilibrium(scene).raise_for_status()
    assert solution.contacts
    assert solution.min_clearance > -0.01 * scene.rod.radius
    beside = solution.position[np.abs(solution.position[:, 0] - 0.25) < 0.1]
    assert (beside[:, 2] > 0.02).all()


def test_what_holds_the_cable_inside_an_obstacle_is_named():
    held = Scene(
        rod=rod(0.3, mass_per_length=0.1),
        start=Clamped([0, 0, 0], ALONG_X, place="start"),
        end=Clamped([0.2, 0, 0], ALONG_X, place="end"),
        gravity=[0, 0, -9.81],
        obstacles=[HalfSpace([0, 0, 5 * RADIUS], [0, 0, 1])],
    )
    message = find_equilibrium(held).message
    assert "start holds the cable 0.05 m inside obstacles:" in message
