# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a cable goes through in a motion."""

from dataclasses import replace

import numpy as np
import pytest
from scenes import strip, table_1

from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.errors import ProblemError
from freecad_cable.result import LengthBound
from freecad_cable.study import Parameter, follow, motion, needed_length
from freecad_cable.study.motion import apart, close_together, envelope

HINGE = Parameter(field="end", how="turn", axis=[0, 1, 0], point=[0.1, -0.235, 0.33])


def hinged(angle):
    return HINGE.of(table_1(min_bend_radius=0.045), angle)


def test_the_worst_of_a_hinge():
    steps = list(follow(hinged, np.linspace(-0.6, 0.6, 7)))
    found = motion(steps)
    radii = {step.value: step.solution.min_bend_radius[0] for step in steps}
    forces = {
        step.value: max(
            np.linalg.norm(load.force)
            for load in (step.solution.start_reaction, step.solution.end_reaction)
        )
        for step in steps
    }
    assert found.smallest_bend_radius == min(radii.items(), key=lambda item: item[1])
    assert found.largest_end_force == pytest.approx(max(forces.items(), key=lambda item: item[1]))
    assert found.smallest_clearance is None and found.jumps == () and found.unsolved == ()


def test_the_length_that_the_worst_position_needs():
    values = [0.0, 0.5]
    found = needed_length(hinged, values)
    alone = [
        find_equilibrium(replace(hinged(v), asks_length=True)).feasible_lengths for v in values
    ]
    assert found.length == max(low.length for low, _ in alone)
    assert found.longest == min(high.length for _, high in alone)
    assert found.feasible == (found.length <= found.longest)
    with pytest.raises(ProblemError, match="at 0:"):
        needed_length(lambda angle: HINGE.of(table_1(min_bend_radius=0.3), angle), values)


@pytest.mark.parametrize(
    ("requirement", "radius", "allowed"),
    [(None, 0.05, 0.9), ("equilibrium", 0.05, 0.9), (None, 0.03, 0.6), ("bend radius", 0.05, 0.6)],
)
def test_a_length_that_was_not_tried_is_no_limit(requirement, radius, allowed):
    """One position takes 0.9 m of cable; at the other the search ended at 0.6 m, for this requirement, and with 0.9 m
    it bends to this radius."""
    ends = {0.0: (0.4, 0.6), 1.0: (0.9, 1.2)}

    def solve(scene, start=None):
        found = find_equilibrium(replace(table_1(), asks_length=False))
        if start is not None:
            return replace(found, scene=scene, min_bend_radius=(radius, 0.1))
        low, high = ends[scene.clearance]
        bounds = LengthBound(low, "bend radius", 0.1, ""), LengthBound(high, requirement, None, "")
        return replace(found, scene=scene, feasible_lengths=bounds)

    def scene_at(value):
        return replace(table_1(min_bend_radius=0.045), clearance=value)

    found = needed_length(scene_at, [0.0, 1.0], solve=solve)
    assert (found.length, found.value) == (0.9, 1.0)
    assert (found.longest, found.longest_value) == (allowed, 0.0)
    assert found.feasible == (allowed == 0.9)


def test_the_search_for_the_needed_length_can_be_stopped():
    asked = []

    def pressed():
        if len(asked) == 2:
            raise KeyboardInterrupt

    def scene_at(angle):
        asked.append(angle)
        return hinged(angle)

    with pytest.raises(KeyboardInterrupt):
        needed_length(scene_at, [0.0, 0.1, 0.2, 0.3], tick=pressed)
    assert asked == [0.0, 0.1]


def test_a_motion_without_any_shape():
    with pytest.raises(ProblemError, match="no value at which"):
        motion(follow(table_1, [0.1, 0.2]))


def test_an_envelope_is_close_where_the_cable_moves_fast_and_open_where_it_jumps():
    """A clamp that turns once round to where it was, and an arch that falls through."""
    roll = Parameter(field="end", how="turn", axis=[0, 1, 0])
    there = lambda turns: roll.of(table_1(), 2 * np.pi * turns)  # noqa: E731
    steps = list(follow(there, [0.0, 0.12, 0.2]))
    close = close_together(there, steps, 0.01)
    assert len(close) > 10
    assert apart(close, 0.01) == []
    arch = lambda q: strip(0.998, weight=q)  # noqa: E731
    steps = list(follow(arch, [-8.0, 16.0]))
    (jump,) = steps[1].jumps
    ((before, after, moved),) = apart(close_together(arch, steps, 0.005), 0.005)
    assert before <= jump.after and jump.before <= after
    assert after - before <= 1e-3 * (16.0 + 8.0)
    assert moved > 0.03


def test_the_envelope_covers_every_shape():
    solutions = [step.solution for step in follow(hinged, [0.0, 0.1])]
    points = envelope(solutions, 0.002)
    for solution in solutions:
        away = np.linalg.norm(solution.position[:, None] - points[None], axis=2).min(axis=1)
        assert away.max() <= 0.001 * 1.01
    assert len(points) == 2 * 366
    assert envelope([], 1.0).shape == (0, 3)
