# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cable in contact that is moved farther than an iteration follows: it keeps its side of an obstacle, or says that it
does not."""

from dataclasses import replace

import numpy as np
import pytest

from freecad_cable.equilibrium import find, find_equilibrium
from freecad_cable.problem import Clamp, Clamped, Cylinder, Pinned, Rod, Scene

ROD = Rod(
    length=0.5,
    radius=0.003,
    mass_per_length=0.01,
    bending_stiffness=0.005,
    torsional_stiffness=0.004,
)
BAR = Cylinder([0.3, -0.2, -0.1], [0.3, 0.2, -0.12], 0.005)
LEVEL = Cylinder([0.31, -0.2, -0.11], [0.31, 0.2, -0.11], 0.005)
TAUT, TOO_FAR = 0.023, 0.03
"""Lifts of the end [m]: the first takes nearly all the slack that is left around the bar, of the second the way around
it is longer than the cable."""


def below(bar, lift=0.0) -> Scene:
    """A cable that passes below a bar, its end lifted."""
    start, end = Clamped([0, 0, 0], [1, 0, 1, 0]), Pinned([0.4, 0, lift])
    return Scene(rod=ROD, start=start, end=end, obstacles=(bar,))


def is_below(solution, bar):
    axis = bar.end - bar.start
    away = np.cross(solution.position - bar.start, axis / np.linalg.norm(axis))
    nearest = solution.position[np.linalg.norm(away, axis=1).argmin()]
    along = (nearest - bar.start) @ axis / (axis @ axis)
    return nearest[2] < (bar.start + along * axis)[2]


def test_it_stays_below(monkeypatch):
    before = find_equilibrium(below(BAR)).raise_for_status()
    found = find_equilibrium(below(BAR, TAUT), start=before).raise_for_status()
    assert is_below(before, BAR) and is_below(found, BAR)
    assert not found.anew
    small = before
    for lift in np.linspace(0, TAUT, 12)[1:]:
        small = find_equilibrium(below(BAR, lift), start=small).raise_for_status()
    gap = np.linalg.norm(found.contacts[0].force - small.contacts[0].force)
    # Slack δ gives a tension like 1/√δ or more, so a position error of 1e-4 L weighs some 10 times as much in it.
    assert gap < 1e-2 * np.linalg.norm(small.contacts[0].force)
    # In one step it is not found.
    monkeypatch.setattr(find, "by_steps", lambda *_: None)
    assert find_equilibrium(below(BAR, TAUT), start=before).anew


@pytest.mark.parametrize("bar", [BAR, LEVEL])
@pytest.mark.parametrize("lift", [TOO_FAR, 0.0335, 0.05])
def test_what_it_is_too_short_for_is_said(bar, lift):
    """Also where the bar is then out of its reach."""
    before = find_equilibrium(below(bar)).raise_for_status()
    found = find_equilibrium(below(bar, lift), start=before).raise_for_status()
    assert is_below(before, bar) and not is_below(found, bar)
    assert found.anew
    # From there on it is as it is.
    assert not find_equilibrium(below(bar, lift), start=found).anew


@pytest.mark.parametrize("way", [0.01, 0.02])
def test_a_bar_that_is_moved_takes_along_what_it_touches(way):
    """Seen from the bar it is the same to lower it or to raise what holds the cable."""
    touched = below(BAR, 0.01)
    before = find_equilibrium(touched).raise_for_status()
    assert len(before.contacts) == 1
    lower = Cylinder(BAR.start - [0, 0, way], BAR.end - [0, 0, way], BAR.radius)
    found = find_equilibrium(replace(touched, obstacles=(lower,)), start=before).raise_for_status()
    assert is_below(found, lower) != found.anew
    assert found.anew == (way == 0.02)


def test_what_it_hangs_below_and_is_then_out_of_its_reach():
    """A cable that touches nothing, and then is too short even to come near to where it was."""
    ends = lambda x: {"start": Pinned([0, 0, 0]), "end": Pinned([x, 0, 0])}  # noqa: E731
    rod = replace(ROD, length=0.45, radius=0.002)
    free = find_equilibrium(Scene(rod=rod, **ends(0.405))).raise_for_status()
    lowest = free.position[:, 2].min()
    bar = Cylinder([0.2, -0.3, lowest + 0.005], [0.2, 0.3, lowest + 0.005], 0.002)
    near = find_equilibrium(Scene(rod=rod, **ends(0.405), obstacles=(bar,))).raise_for_status()
    assert not near.contacts and is_below(near, bar)
    far = Scene(rod=rod, **ends(0.445), obstacles=(bar,))
    assert not is_below(find_equilibrium(far), bar)
    assert find_equilibrium(far, start=near).anew


def test_a_model_that_is_tried_first_leaves_nothing_behind():
    """What the cable cannot do as long as it does not stretch, it can when it does."""
    rod = replace(ROD, axial_stiffness=1000.0)
    before = find_equilibrium(replace(below(LEVEL), rod=rod)).raise_for_status()
    found = find_equilibrium(replace(below(LEVEL, 0.028), rod=rod), start=before)
    assert is_below(found.raise_for_status(), LEVEL)
    assert "stretch" in found.kept and not found.anew


def test_a_free_cable_keeps_its_turns():
    """It has two equilibria with 0.4 and 1.8 rad of twist; from one step it falls into the other."""
    rod = replace(ROD, radius=0.005, bending_stiffness=[0.02, 0.02], torsional_stiffness=0.002)
    first, last = (
        Scene(rod=rod, start=Clamped([0, 0, 0], [1, 0, 1, 0]), end=Clamped(place, [a, -b, a, -b]))
        for place, a, b in (
            ([0.20652979, 0, 0], 0.36688095, 0.6044819),
            ([0.2075927, -0.00038833, -0.00752648], 0.37589634, 0.59891731),
        )
    )
    before = find_equilibrium(first).raise_for_status()
    found = find_equilibrium(last, start=before).raise_for_status()
    assert abs(found.twist - before.twist) < 0.1
    assert not found.anew


@pytest.mark.parametrize("factor", [2.0, 0.5])
def test_stiffness_may_double_and_halve(factor):
    before = find_equilibrium(below(BAR)).raise_for_status()
    raised = find_equilibrium(below(BAR, 0.02), start=before).raise_for_status()
    rod = replace(ROD, bending_stiffness=factor * ROD.bending_stiffness)
    scene = replace(below(BAR, 0.02), rod=rod)
    assert not is_below(find_equilibrium(scene), BAR)
    found = find_equilibrium(scene, start=raised).raise_for_status()
    assert is_below(found, BAR) and not found.anew


def test_a_start_in_one_piece_is_cut_where_the_cable_is():
    """As after undo, where only its nodes are known."""
    rod = replace(ROD, length=0.9)
    clamp = Clamp([0.4, 0, 0], [1, 0, 1, 0], arc_length=0.5)

    def held(height, end=0.0):
        bar = Cylinder([0.25, -0.2, height], [0.25, 0.2, height], 0.005)
        return Scene(
            rod=rod,
            start=Clamped([0, 0, 0], [1, 0, 1, 0]),
            end=Pinned([0.7, 0, end]),
            supports=(clamp,),
            obstacles=(bar,),
        )

    on = None
    for height in np.linspace(-0.13, -0.07, 16):
        on = find_equilibrium(held(height), start=on).raise_for_status()
    assert not is_below(on, on.scene.obstacles[0])
    found = find_equilibrium(held(-0.07, 0.005), start=replace(on, stretches=()))
    assert not is_below(found.raise_for_status(), found.scene.obstacles[0])
    again = find_equilibrium(held(-0.07, 0.005), start=on)
    assert found.energy.total == pytest.approx(again.energy.total, rel=1e-4)


def test_what_starts_from_nothing_is_not_anew():
    assert not find_equilibrium(below(BAR, TAUT)).anew
    far = replace(below(BAR), end=Pinned([0.3, 0.2, 0.0]))
    assert not find_equilibrium(far, start=find_equilibrium(below(BAR))).anew
