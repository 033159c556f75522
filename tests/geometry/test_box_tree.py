# SPDX-License-Identifier: LGPL-2.1-or-later
"""The nearest of many things: none is overlooked, whatever their sizes and wherever the points."""

import numpy as np
import pytest
from numpy.linalg import norm

from freecad_cable.geometry import box_tree
from freecad_cable.geometry.box_tree import BoxTree


@pytest.mark.parametrize("count", [1, 2, 8, 9, 64, 65, 700, 5000])
@pytest.mark.parametrize("spread", [0.0, 1.0, 100.0])
def test_the_nearest_segment(random, count, spread):
    start = random.normal(size=(count, 3))
    # Lengths over four decades: a few segments cross everything, as the long triangles of a plain part do.
    span = random.normal(size=(count, 3)) * 10 ** random.uniform(-4, 0, (count, 1))
    points = spread * random.normal(size=(50, 3))
    found = _tree(start, span).nearest(points, _between(start, span))
    everything = np.array(
        [_between(start, span)(np.repeat(p[None], count, 0), np.arange(count)) for p in points]
    )
    assert everything[np.arange(50), found] == pytest.approx(everything.min(axis=1), rel=1e-12)


def test_few_are_looked_at(random):
    start = random.uniform(size=(20_000, 3))
    span = random.normal(size=start.shape) * 1e-3
    looked_at = []

    def counted(points, things):
        looked_at.append(len(things))
        return _between(start, span)(points, things)

    points = random.uniform(size=(100, 3))
    _tree(start, span).nearest(points, counted)
    # A leaf holds 5, some thirty leaves surround a point, and three rounds look.
    assert sum(looked_at) < 100 * 5 * 33


def test_slanted_things_are_told_apart(random):
    start = random.uniform(size=(20_000, 3))
    span = np.full(start.shape, 0.5)
    looked_at = []

    def counted(points, things):
        looked_at.append(len(things))
        return _between(start, span)(points, things)

    points = 0.5 + random.uniform(size=(100, 3))
    _tree(start, span).nearest(points, counted)
    # The boxes of slanted things overlap and let some 400 leaves a point pass; cylinders, 15.
    assert sum(looked_at) < 100 * 5 * 40


def test_few_are_looked_at_from_inside(random):
    """Of a point that things surround, as of one inside a solid, the box that seems nearest at first is no bound."""
    start = random.uniform(size=(40_000, 3))
    face = random.integers(3, size=len(start))
    start[np.arange(len(start)), face] = np.round(start[np.arange(len(start)), face])
    span = random.normal(size=start.shape) * 1e-3
    looked_at = []

    def counted(points, things):
        looked_at.append(len(things))
        return _between(start, span)(points, things)

    points = random.uniform(0.2, 0.8, size=(100, 3))
    _tree(start, span).nearest(points, counted)
    # Some 8; without bounds from the boxes on the way down, 80 to 400.
    assert sum(looked_at) < 100 * 20


def test_all_at_one_distance_are_searched_in_parts(random, monkeypatch):
    direction = random.normal(size=(3000, 3))
    start = direction / norm(direction, axis=1)[:, None]
    monkeypatch.setattr(box_tree, "MOST_PAIRS", 1000)
    tree, span = _tree(start, 0.5 * start), 0.5 * start
    points = 1e-3 * random.normal(size=(9, 3))
    found = tree.nearest(points, _between(start, span))
    least = norm(start - points[:, None], axis=2).min(axis=1)
    assert norm(start[found] - points, axis=1) == pytest.approx(least, rel=1e-12)


def test_no_points(random):
    start = random.normal(size=(100, 3))
    assert _tree(start, start).nearest(np.empty((0, 3)), _between(start, start)).shape == (0,)


def _tree(start, span):
    return BoxTree(np.stack([start, start + span], axis=1), span / norm(span, axis=1)[:, None])


def _between(start, span):
    def squared(points, things):
        away, along = points - start[things], span[things]
        part = np.sum(away * along, axis=1) / np.sum(along**2, axis=1)
        return np.sum((away - np.clip(part, 0, 1)[:, None] * along) ** 2, axis=1)

    return squared
