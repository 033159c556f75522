# SPDX-License-Identifier: LGPL-2.1-or-later
"""Heavy and taut rods in the limit of narrow bending layers."""

import numpy as np
import pytest

from freecad_cable.geometry.layers import Layered

FIRST, LAST = (np.array(t) / np.linalg.norm(t) for t in ([0.95, 0.1, 0.29], [0.3, -0.8, 0.15]))


def layered(ratio, weight):
    """Length 1 over a chord of 1/``ratio`` along x, held in two directions."""
    return Layered([0, 0, 0], FIRST, [1 / ratio, 0, 0], LAST, 1.0, np.array([0, 0, -weight]))


def nodes(rod):
    near = np.concatenate([[0.0], np.geomspace(1e-3 * min(rod.widths), 0.5, 4000)])
    s = np.unique(np.concatenate([near, 1 - near]))
    return s, *rod.at(s)


@pytest.mark.parametrize("ratio", (1.00001, 1.001, 1.1, 2.0))
@pytest.mark.parametrize("weight", (0.0, 1e5, 1e7))
def test_a_curve_from_end_to_end_that_runs_along_its_tangents(ratio, weight):
    rod = layered(ratio, weight)
    if weight == 0 and ratio > 1.01:
        assert not rod.valid  # bends everywhere
        return
    s, position, tangent, _ = nodes(rod)
    width = max(rod.widths)
    assert position[0] == pytest.approx([0, 0, 0], abs=1e-9)
    assert position[-1] == pytest.approx([1 / ratio, 0, 0], abs=1e-9)
    # The chain turns by about a width over its length within a layer, which the limit leaves out.
    turning = 10 * width * max(1.0, abs(np.arccos(tangent[:, 2])).max())
    assert np.abs(tangent[0] - FIRST).max() < turning
    assert np.abs(tangent[-1] - LAST).max() < turning
    rate = np.diff(position, axis=0) / np.diff(s)[:, None]
    along = (tangent[1:] + tangent[:-1]) / 2
    assert np.linalg.norm(rate - along, axis=1).max() < turning


def test_the_pull_of_a_taut_rod_without_weight():
    """All slack is in the layers: 4 λ (sin²(φ₁/4) + sin²(φ₂/4)) with angles from the line between the ends, T = 1/λ².
    The line turns by about the width, and the pull with it."""
    rod = layered(1 / (1 - 1e-6), 0.0)
    angles = np.arccos([FIRST[0], LAST[0]])
    width = 1e-6 / (4 * np.sin(angles / 4) ** 2).sum()
    assert np.linalg.norm(rod.pull) == pytest.approx(width**-2, rel=1e-4)


def test_the_pull_of_a_heavy_rod_is_that_of_its_chain():
    """Catenary with a length of 1.5 over a chord of 1 (Irvine 1981): the pull at its end is 0.810869731384 of the
    weight of a chord; the layers change that by about their width."""
    rod = layered(1.5, 1e8)
    assert np.linalg.norm(rod.pull) * 1.5 / 1e8 == pytest.approx(0.810869731384, rel=1e-3)


def test_between_places_that_are_next_to_each_other_there_is_no_limit():
    assert not layered(1e7, 1e20).valid
