# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a held curve can be, against the sum of distances that defines it."""

import numpy as np
import pytest
from numpy.linalg import norm
from scipy.optimize import minimize

from freecad_cable.geometry.spheroid import Spheroid

A, B = np.array([0.1, -0.2, 0.3]), np.array([0.26, -0.435, 0.63])
CHORD = norm(B - A)
LENGTHS = [1.0001 * CHORD, 1.1 * CHORD, 3 * CHORD]


@pytest.mark.parametrize("length", LENGTHS)
def test_nearest_points_lie_on_it_and_look_straight_out(random, length):
    reach = Spheroid.of(length, A, B)
    points = A + random.normal(size=(500, 3)) * 2
    points = points[norm(points - A, axis=1) + norm(points - B, axis=1) > length]
    found = reach.nearest(points)
    assert norm(found - A, axis=1) + norm(found - B, axis=1) == pytest.approx(
        np.full(len(points), length), rel=1e-12
    )
    out = (found - A) / norm(found - A, axis=1)[:, None] + (found - B) / norm(found - B, axis=1)[
        :, None
    ]
    way = points - found
    cosine = np.sum(out * way, axis=1) / norm(out, axis=1) / norm(way, axis=1)
    assert cosine == pytest.approx(np.ones(len(points)), abs=1e-6)


@pytest.mark.parametrize("length", LENGTHS)
def test_support_is_reached_and_not_passed(random, length):
    reach = Spheroid.of(length, A, B)
    directions = random.normal(size=(40, 3))
    directions /= norm(directions, axis=1)[:, None]
    surface = reach.nearest(reach.center + 9 * random.normal(size=(20_000, 3)))
    heights = surface @ directions.T
    support = reach.support(directions)
    assert (heights <= support + 1e-12).all()
    touching = reach.nearest(reach.center + 1e6 * directions)
    assert np.sum(touching * directions, axis=1) == pytest.approx(support, abs=1e-5)


def test_held_at_one_point_it_is_a_ball(random):
    reach = Spheroid.of(0.7, A)
    points = A + random.normal(size=(50, 3))
    away = norm(points - A, axis=1)
    assert norm(reach.nearest(points) - A, axis=1) == pytest.approx(np.minimum(away, 0.7))
    assert reach.far_from([[A + 0.5, A + 1]], 0.16)
    assert not reach.far_from([[A + 0.5, A + 1]], 0.17)


def test_a_taut_curve_reaches_its_chord_alone():
    reach = Spheroid.of(CHORD, A, B)
    middle, aside = (A + B) / 2, np.cross(B - A, (0, 0, 1)) / norm(np.cross(B - A, (0, 0, 1)))
    boxes = [[middle + aside * s, middle + aside * s] for s in (0.01, 0.1)]
    assert reach.far_from(boxes, 0.02).tolist() == [False, True]


@pytest.mark.parametrize("length", LENGTHS)
@pytest.mark.parametrize("margin", [0.0, 0.01, 0.3])
def test_far_is_far_and_near_is_near(random, length, margin):
    reach = Spheroid.of(length, A, B)
    low = random.uniform(A - 1, B + 0.7, (60, 3))
    bounds = np.stack([low, low + random.uniform(0, 0.4, (60, 3))], axis=1)
    gaps = np.array([_gap(length, box) for box in bounds])
    # The minimiser that is compared with works to 1e-6; decisions within 1e-4 of the margin may go either way.
    clear = np.abs(gaps - margin) > 1e-4
    far = reach.far_from(bounds, margin)
    assert np.array_equal(far[clear], gaps[clear] > margin)
    assert far.any() and not far.all()


@pytest.mark.parametrize("length", LENGTHS)
def test_never_far_from_what_it_can_touch(random, length):
    reach = Spheroid.of(length, A, B)
    inside = reach.nearest(reach.center + 2 * random.normal(size=(300, 3)))
    way = random.normal(size=(300, 3))
    corner = inside + 0.05 * way / norm(way, axis=1)[:, None]
    other = corner + np.sign(way) * random.uniform(0, 1, (300, 3))
    bounds = np.stack([np.minimum(corner, other), np.maximum(corner, other)], axis=1)
    assert not reach.far_from(bounds, 0.05 + 1e-12).any()


def test_boxes_without_end(random):
    reach = Spheroid.of(2 * CHORD, A, B)
    low, high = np.full(3, -np.inf), np.full(3, np.inf)
    everything, below = np.stack([low, high]), np.stack([low, (np.inf, np.inf, -5)])
    assert reach.far_from([everything, below], 0.1).tolist() == [False, True]


def _gap(length, box):
    """Distance between a box and all x with |x − A| + |x − B| ≤ length, by a general minimiser."""
    low, high = box
    start = np.concatenate([(A + B) / 2, np.clip((A + B) / 2, low, high)])
    within = {"type": "ineq", "fun": lambda v: length - norm(v[:3] - A) - norm(v[:3] - B)}
    limits = [(None, None)] * 3 + list(zip(low, high, strict=True))
    shift = start + np.repeat([1e-3, 0], 3)
    result = minimize(
        lambda v: np.sum((v[:3] - v[3:]) ** 2), shift, constraints=within, bounds=limits, tol=1e-14
    )
    return np.sqrt(result.fun)
