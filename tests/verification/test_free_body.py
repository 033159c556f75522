# SPDX-License-Identifier: LGPL-2.1-or-later
"""The reported loads hold the cable: a free-body balance that fixes every sign."""

import numpy as np
import pytest

from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.problem import Free, Pinned, Swivel


def ends(scene, kind):
    start, end = scene.start, scene.end
    return {
        "clamped": (start, end),
        "swivel": (start, Swivel(end.position, [1, 0, 0])),
        "pinned": (Pinned(start.position, place="start"), Pinned(end.position)),
        "free": (start, Free()),
    }[kind]


@pytest.mark.parametrize("kind", ["clamped", "swivel", "pinned", "free"])
def test_reactions_carry_the_weight(table_1, kind):
    from dataclasses import replace

    scene = table_1(0.73)
    start, end = ends(scene, kind)
    solution = find_equilibrium(replace(scene, start=start, end=end)).raise_for_status()
    weight = scene.weight * scene.rod.length
    forces = solution.start_reaction.force + solution.end_reaction.force
    # Exact in the discrete problem, so only the solver's tolerance remains.
    assert forces == pytest.approx(-weight, abs=1e-7)
    # Moments about the origin; the mean position of the nodes weighs each by its share of the length.
    share = np.gradient(solution.arc_length)
    share[[0, -1]] = np.diff(solution.arc_length)[[0, -1]] / 2
    centre = share @ solution.position / scene.rod.length
    moment = np.cross(centre, weight)
    for place, load in ((0, solution.start_reaction), (-1, solution.end_reaction)):
        moment = moment + load.moment + np.cross(solution.position[place], load.force)
    # The trapezoidal centre is wrong by h²/12 L² of the mean curvature: (1/32)²/12 · 2 rad · L · weight.
    assert np.abs(moment).max() < 2e-4 * np.linalg.norm(weight) * scene.rod.length
    if kind == "free":
        assert np.abs(solution.end_reaction.force).max() < 1e-7


def test_a_hanging_cable_is_pulled_up_at_its_start(table_1):
    from dataclasses import replace

    scene = replace(table_1(0.73), end=Free())
    solution = find_equilibrium(scene)
    assert solution.start_reaction.force[2] == pytest.approx(0.0446418 * 9.81 * 0.73, rel=1e-5)
    # What lies beyond the start pulls the part before it down.
    assert solution.force[0, 2] < 0
