# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whoever watches a solve hears of each run of a solver, and can stop it there."""

from dataclasses import replace

import numpy as np
import pytest

from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.errors import StoppedError
from freecad_cable.problem import Clamp, Clamped


def plain(table_1):
    return table_1()


def asking(table_1):
    """for its length, which takes many solves"""
    scene = table_1()
    rod = replace(scene.rod, min_bend_radius=0.05)
    return replace(scene, rod=rod, asks_length=True)


def cut(table_1):
    """in two stretches"""
    scene = table_1(0.82)
    start, end = scene.start, scene.end
    middle = Clamp((start.position + end.position) / 2, start.quaternion, arc_length=0.41)
    return replace(scene, supports=(middle,), end=Clamped(end.position, start.quaternion))


@pytest.mark.parametrize("made", [plain, asking, cut])
def test_a_watched_solve_can_be_stopped_at_every_step(table_1, made):
    scene, heard = made(table_1), []
    solution = find_equilibrium(scene, watch=heard.append)
    assert np.array_equal(solution.position, find_equilibrium(scene).position)
    assert len(heard) > {plain: 0, asking: 15, cut: 1}[made]
    assert all(" m in " in sentence and "elements" in sentence for sentence in heard)

    for step in {1, (1 + len(heard)) // 2, len(heard)}:
        again = []

        def stop(sentence, again=again, step=step):
            again.append(sentence)
            if len(again) == step:
                raise StoppedError("enough")

        with pytest.raises(StoppedError):
            find_equilibrium(scene, watch=stop)
        assert again == heard[:step]
