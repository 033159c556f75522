# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cable in contact that is moved farther than an iteration follows: it keeps its side of an obstacle, or says that it
does not."""

from dataclasses import replace

import numpy as np
import pytest

from freecad_cable.equilibrium import find, find_equilibrium
from freecad_cable.problem import Clamped, Cylinder, Pinned, Rod, Scene

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


def test_what_starts_from_nothing_is_not_anew():
    assert not find_equilibrium(below(BAR, TAUT)).anew
    far = replace(below(BAR), end=Pinned([0.3, 0.2, 0.0]))
    assert not find_equilibrium(far, start=find_equilibrium(below(BAR))).anew
