# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rotations as quaternions. Tolerance: a few roundings of numbers of order one."""

import numpy as np
import pytest

from freecad_cable.geometry import rotation

ROUNDING = 1e-14
RANDOM = np.random.default_rng(3)


def unit(size):
    v = RANDOM.normal(size=size)
    return v / np.linalg.norm(v)


def test_product_is_the_product_of_matrices():
    a, b = unit(4), unit(4)
    product = rotation.matrix(a) @ rotation.matrix(b)
    assert rotation.matrix(rotation.multiply(a, b)) == pytest.approx(product, abs=ROUNDING)


def test_exponential_and_logarithm():
    for size in (0.0, 1e-12, 1e-3, 1.0, 3.1):
        theta = size * unit(3)
        assert rotation.logarithm(rotation.exponential(theta)) == pytest.approx(theta, abs=1e-13)
    quarter = rotation.rotate(rotation.exponential([0, 0, np.pi / 2]), [1.0, 0, 0])
    assert quarter == pytest.approx([0, 1, 0], abs=ROUNDING)


@pytest.mark.parametrize(
    "angle", [0.0, 1e-9, 1e-3, 1.0, 3.0, np.pi - 1e-3, np.pi - 1e-5, np.pi - 1e-9, np.pi]
)
def test_shortest_arc_arrives(angle):
    a = unit(3)
    across = np.cross(a, unit(3))
    b = np.cos(angle) * a + np.sin(angle) * across / np.linalg.norm(across)
    q = rotation.shortest_arc(a, b)
    assert np.linalg.norm(q) == pytest.approx(1, abs=ROUNDING)
    assert rotation.rotate(q, a) == pytest.approx(b, abs=1e-13)
    # The least rotation: its angle is the angle between them.
    assert 2 * np.arctan2(np.linalg.norm(q[1:]), abs(q[0])) == pytest.approx(angle, abs=1e-7)


@pytest.mark.parametrize("t", [[0, 0, 1], [0, 0, -1], [1e-3, 0, -1], [0, 1e-6, -1], [1, 2, 3]])
def test_a_frame_along_a_tangent(t):
    t = np.array(t) / np.linalg.norm(t)
    assert rotation.tangent(rotation.from_tangent(t)) == pytest.approx(t, abs=1e-13)


def test_transport_turns_as_little_as_it_must():
    angle = np.linspace(0, 2 * np.pi, 401)
    circle = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    frames = rotation.transport(rotation.from_tangent(circle[0]), circle)
    assert rotation.tangent(frames) == pytest.approx(circle, abs=1e-12)
    # In a plane a frame carried once round comes back as it was, but for the sign of its quaternion.
    assert abs(frames[0] @ frames[-1]) == pytest.approx(1, abs=1e-12)
    assert (np.sum(frames[1:] * frames[:-1], axis=1) > 0).all()


@pytest.mark.parametrize("count", [2, 3, 8, 33])
def test_transport_goes_on_from_frame_to_frame(count):
    """Whatever its number of steps: each frame is the one before, turned by the least that its tangent needs. One of
    the tangents turns back, where the least is no longer one."""
    tangents = np.random.default_rng(7).normal(size=(count, 3))
    tangents /= np.linalg.norm(tangents, axis=1)[:, None]
    tangents[-1] = -tangents[-2]
    frame = rotation.from_tangent(tangents[0])
    found = rotation.transport(frame, tangents)
    for k in range(1, count):
        frame = rotation.multiply(rotation.shortest_arc(*tangents[k - 1 : k + 1]), frame)
        assert abs(frame @ found[k]) == pytest.approx(1, abs=1e-12)
    assert rotation.tangent(found) == pytest.approx(tangents, abs=1e-12)


def test_between_frames_goes_the_short_way():
    a = rotation.exponential([[0, 0, 0], [0, 0, 0.2]])
    b = rotation.exponential([[0, 0, 1.0], [0, 0, 0.2]])
    there = rotation.between(a, -b, [0.25, 0.5])
    assert np.abs(there[0] @ rotation.exponential([0, 0, 0.25])) == pytest.approx(1, abs=ROUNDING)
    assert np.abs(there[1] @ a[1]) == pytest.approx(1, abs=ROUNDING)
    assert rotation.between(a[0], b[0], 1.0) == pytest.approx(b[0], abs=ROUNDING)
