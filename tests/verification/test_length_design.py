# SPDX-License-Identifier: LGPL-2.1-or-later
"""The length as the answer: just shorter a requirement fails, and a length at which no solver finds anything is told as
such."""

from dataclasses import replace

import numpy as np
import pytest

from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.equilibrium.length_design import GROWTH, PRECISION, ROUGHLY, shortest
from freecad_cable.equilibrium.length_samples import FIRST, PATIENCE
from freecad_cable.errors import ProblemError
from freecad_cable.problem import Box, Free, Ring, Rod, Scene, Swivel
from freecad_cable.result import Solution
from freecad_cable.status import Status

LIMIT = 0.04


def scene(**more):
    """A cable that hangs from two swivels that look down, and is asked for its length."""
    rod = Rod(
        length=0.3,
        radius=0.003,
        mass_per_length=0.05,
        bending_stiffness=1e-3,
        torsional_stiffness=1e-3,
        min_bend_radius=LIMIT,
    )
    ends = Swivel([0, 0, 0], [0, 0, -1], place="start"), Swivel([0.2, 0, 0], [0, 0, 1])
    return Scene(rod=rod, start=ends[0], end=ends[1], asks_length=True, **more)


def at(found, length):
    rod = replace(found.scene.rod, length=length)
    return find_equilibrium(replace(found.scene, rod=rod), start=found)


@pytest.mark.parametrize("obstacles", [(), (Box([0.1, 0, -0.18], [1, 0, 0, 0], [0.3, 0.3, 0.1]),)])
def test_just_shorter_it_bends_too_sharply(obstacles):
    found = find_equilibrium(scene(obstacles=obstacles)).raise_for_status()
    low, high = found.feasible_lengths
    assert found.scene.rod.length == low.length < high.length
    assert low.requirement == "bend radius"
    assert found.bend_radius_margin >= 0
    # Twice the precision, for the ends of the interval are off by it, and so is each solve.
    assert at(found, low.length * (1 - 2 * PRECISION)).bend_radius_margin < 0


def pretended(margin, fails=lambda length: False, seconds=lambda length: 0.0, clock=None):
    """A solver whose cables of a length miss the limit by that, and which fails at some lengths."""
    asked = []

    def solve(scene, start=None):
        length = scene.rod.length
        asked.append((length, scene.options.time_limit))
        if clock is not None:
            clock[0] += seconds(length)
        if fails(length):
            return Solution(scene=scene, status=Status.NOT_CONVERGED, message="Nothing was found.")
        return Solution(
            scene=scene,
            status=Status.CONVERGED,
            message="Fine.",
            min_bend_radius=(LIMIT * (1 + margin(length)), 0.1),
        )

    return solve, asked


def test_one_length_that_no_solver_finds_is_no_end():
    gap = []

    def fails(length):
        gap.extend([length] if length > 0.4 and not gap else [])
        return length in gap

    solve, _ = pretended(lambda length: min(length - 0.25, 0.6 - length), fails)
    low, high = shortest(scene(), solve).feasible_lengths
    assert gap
    assert (low.length, high.length) == pytest.approx((0.25, 0.6), rel=PRECISION)
    assert low.requirement == high.requirement == "bend radius"


def test_where_no_equilibrium_is_found_it_is_said_and_not_looked_for_closely():
    solve, asked = pretended(lambda length: 1.0, lambda length: not 0.26 < length < 0.5)
    low, high = shortest(scene(), solve).feasible_lengths
    assert low.length == pytest.approx(0.26, rel=ROUGHLY)
    # The next length that is tried has so much more slack beyond the chord.
    assert high.length < 0.5 <= 0.2 + GROWTH * (high.length - 0.2)
    assert low.requirement == high.requirement == "equilibrium"
    assert high.sentence.startswith(f"{high.length:.6g} m is the longest at which an equilibrium")
    assert high.sentence.endswith("Nothing was found.")
    # 10 until both ends are passed, and of a bracket of 0.03 halves until it is ROUGHLY narrow, 7.
    assert len(asked) <= 10 + 7


def test_where_none_is_found_at_all_no_length_is_called_the_best():
    solve, asked = pretended(lambda length: 1.0, lambda length: True)
    found = shortest(scene(), solve)
    assert found.status is Status.INFEASIBLE
    first, last = (f"{lengths[0]:.4g} m" for lengths in (min(asked), max(asked)))
    said = f"From {first} to {last} no length was found at which it is in equilibrium."
    assert found.message.startswith(f"{Status.INFEASIBLE.value} {said} At {asked[0][0]:.6g} m: ")
    assert found.message.endswith("Nothing was found.")


def test_it_may_take_much_more_length_until_there_is_an_equilibrium():
    """The chord is 0.2 m, and the spline that is tried first 0.24 m long."""
    solve, _ = pretended(lambda length: 1.0, lambda length: not 0.4 < length < 0.6)
    low, _ = shortest(scene(), solve).feasible_lengths
    assert low.length == pytest.approx(0.4, rel=ROUGHLY)


def test_what_is_not_found_from_nothing_is_found_from_a_longer_cable():
    """The first length, 0.24 m, is solved from a solution only: it was no end, for which it was once taken."""
    solve, _ = pretended(lambda length: length - 0.21)

    def from_longer(scene, start=None):
        lost = scene.rod.length < 0.25 and start is None
        found = solve(scene)
        return replace(found, status=Status.INACCURATE) if lost else found

    low, _ = shortest(scene(), from_longer).feasible_lengths
    assert low.length == pytest.approx(0.21, rel=PRECISION)
    assert low.requirement == "bend radius"


def test_among_obstacles_nothing_is_tried_that_nobody_would_order():
    far = Box([0.1, 0, -9], [1, 0, 0, 0], [0.3, 0.3, 0.1])
    solve, asked = pretended(lambda length: length - 0.22)
    low, high = shortest(scene(obstacles=(far,)), solve).feasible_lengths
    assert high.requirement is None
    assert high.length == max(length for length, _ in asked) <= 1.5 * asked[0][0]
    # The longest without obstacles: four times the chord and half a circle of the bend radius.
    _, high = shortest(scene(), solve).feasible_lengths
    assert high.length == pytest.approx(4 * (0.2 + np.pi * LIMIT))


@pytest.mark.parametrize("limit", [0.21, 0.23])
def test_one_length_that_no_solver_finds_is_no_shortest(limit):
    """The next that is tried is feasible, or is not."""
    gap = []

    def fails(length):
        gap.extend([length] if length < 0.24 and not gap else [])
        return length in gap

    solve, _ = pretended(lambda length: length - limit, fails)
    low, _ = shortest(scene(), solve).feasible_lengths
    assert gap
    assert low.length == pytest.approx(limit, rel=PRECISION)
    assert low.requirement == "bend radius"


def test_the_equilibrium_that_long_cables_leave_for_is_followed_to_short_ones():
    """On its way up it keeps to one that is never feasible, until at 0.5 m it leaves for one that is from 0.25 m on."""
    solve, _ = pretended(lambda length: length - 0.25)

    def on_branch(scene, start=None):
        found = solve(scene)
        left = scene.rod.length > 0.5 or (start is not None and start.min_clearance == 1.0)
        if left:
            return replace(found, min_clearance=1.0)
        return replace(found, min_bend_radius=(0.5 * LIMIT, 0.1))

    low, _ = shortest(scene(), on_branch).feasible_lengths
    assert low.length == pytest.approx(0.25, rel=PRECISION)


def test_ends_beside_each_other_take_half_a_circle():
    """Their chord is 20 mm, of which four times would never do."""
    ends = Swivel([0, 0, 0], [0, 0, -1], place="start"), Swivel([0.02, 0, 0], [0, 0, 1])
    found = find_equilibrium(replace(scene(), start=ends[0], end=ends[1])).raise_for_status()
    low, _ = found.feasible_lengths
    assert low.requirement == "bend radius"
    assert np.pi * LIMIT < low.length < 4 * np.pi * LIMIT


def test_the_spline_may_be_longer_than_what_is_tried():
    """Down and back, through a ring that a cable need not reach far into."""
    ring = Ring([0.015, 0, -0.1], [1, 0, 0], 0.09)
    there = replace(scene(), end=Swivel([0.03, 0, 0], [0, 0, 1]), supports=(ring,))
    there = replace(there, rod=replace(there.rod, min_bend_radius=0.012))
    low, _ = find_equilibrium(there).raise_for_status().feasible_lengths
    assert low.length < 0.13


def test_no_length_to_find():
    with pytest.raises(ProblemError, match="an end is free"):
        find_equilibrium(replace(scene(), end=Free()))
    with pytest.raises(ProblemError, match="its ends are at one place"):
        at_one = replace(scene(), end=Swivel([0, 0, 0], [0, 0, 1]))
        find_equilibrium(replace(at_one, rod=replace(at_one.rod, min_bend_radius=None)))


def test_supports_at_given_places_bound_the_length():
    """A ring that is 0.25 m along the cable: ones that do not reach to the end from there are no error."""
    ring = Ring([0.1, 0, -0.1], [1, 0, 0], 0.01, arc_length=0.25)
    there = replace(scene(), rod=replace(scene().rod, length=0.5))
    low, _ = find_equilibrium(replace(there, supports=(ring,))).feasible_lengths
    assert low.length > 0.25 + np.hypot(0.1, 0.1) - 0.007


def test_an_end_is_closed_in_on_in_a_few_solves():
    """A margin that is nearly straight between two lengths: halves would take log₂(0.04/0.24/PRECISION) = 14."""
    solve, asked = pretended(lambda length: (length - 0.22) * (1 + length))
    low, _ = shortest(scene(), solve).feasible_lengths
    assert low.length == pytest.approx(0.22, rel=PRECISION)
    assert sum(0.2 < length < 0.23 for length, _ in asked) <= 7


def test_a_length_gets_the_time_that_others_took(monkeypatch):
    clock = [0.0]
    monkeypatch.setattr("time.perf_counter", lambda: clock[0])
    solve, asked = pretended(lambda length: length - 0.25, seconds=lambda _: 1.0, clock=clock)
    shortest(scene(), solve)
    assert asked[0][1] == FIRST * scene().options.time_limit
    assert {limit for _, limit in asked[1:]} == {PATIENCE}


def test_the_scene_of_the_answer_has_the_time_limit_that_was_given():
    found = find_equilibrium(scene())
    assert found.scene.options == scene().options
    assert np.isfinite(found.scene.rod.length)
