# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a cable runs through itself."""

import numpy as np
import pytest

from freecad_cable.geometry import rotation, self_contact
from freecad_cable.geometry.self_contact import self_penetrations

RADIUS = 0.01


def frames(tangents):
    return np.array([rotation.from_tangent(tangent) for tangent in tangents])


def loop(rise, nodes=81):
    """A helix of one turn and a quarter, of radius 0.1: nodes (n+1,), (n+1, 3), (n+1, 4), and its rise in a turn."""
    pitch = rise / (2 * np.pi)
    angle = np.linspace(0, 2.5 * np.pi, nodes)
    position = np.column_stack([0.1 * np.cos(angle), 0.1 * np.sin(angle), pitch * angle])
    tangent = np.column_stack(
        [-0.1 * np.sin(angle), 0.1 * np.cos(angle), np.full_like(angle, pitch)]
    )
    speed = np.hypot(0.1, pitch)
    return speed * angle, position, frames(tangent / speed), speed


@pytest.mark.parametrize("rise", [0.005, 0.015, 0.019])
def test_depth_and_place(rise):
    *nodes, speed = loop(rise)
    (depth, here, there), *_ = self_penetrations(*nodes, RADIUS)
    # One turn further the helix is ``rise`` higher, and nearest a little before that: the pitch makes it a cosine of
    # rise/0.2π nearer. Samples a quarter of a radius apart miss up to a 64th of that squared.
    nearest = rise * np.cos(np.arctan(rise / (0.2 * np.pi)))
    assert depth == pytest.approx(2 * RADIUS - nearest, abs=RADIUS**2 / 128 / nearest + 1e-6)
    assert there - here == pytest.approx(2 * np.pi * speed, abs=RADIUS)


def test_apart():
    *nodes, _ = loop(0.0205)
    assert self_penetrations(*nodes, RADIUS) == []


def test_a_sharp_bend_is_no_contact():
    """Parts that follow each other in a bend of the cable's own radius."""
    angle = np.linspace(0, np.pi, 61)
    position = RADIUS * np.column_stack([np.cos(angle), np.sin(angle), np.zeros_like(angle)])
    tangent = np.column_stack([-np.sin(angle), np.cos(angle), np.zeros_like(angle)])
    nodes = RADIUS * angle, position, frames(tangent)
    assert self_penetrations(*nodes, RADIUS) == []


@pytest.mark.parametrize("seed", range(40))
def test_what_cannot_come_back_is_not_in_itself(seed, monkeypatch):
    """Whether elements are compared before samples are makes no difference: tangled curves, the radii just below and
    above that at which they meet."""
    draw = np.random.default_rng(seed)
    s, waves = np.linspace(0, 1, draw.integers(6, 60)), draw.normal(size=(2, 3, 4))
    turns = np.einsum("tcw,tsw->sc", waves, _waves(s)) * draw.uniform(0.5, 3)
    tangent = np.column_stack([np.cos(turns[:, 0]), np.sin(turns[:, 0]), 0.3 * turns[:, 1]])
    tangent /= np.linalg.norm(tangent, axis=1)[:, None]
    middle = tangent[1:] + tangent[:-1]
    position = np.vstack([np.zeros(3), np.cumsum(middle * np.diff(s)[:, None] / 2, axis=0)])
    quaternion = frames(tangent)
    for radius in np.geomspace(0.002, 0.2, 25):
        found = self_penetrations(s, position, quaternion, radius)
        monkeypatch.setattr(self_contact, "FEW", 0)
        assert self_penetrations(s, position, quaternion, radius) == found
        monkeypatch.undo()


def _waves(s):
    angles = np.pi * np.outer(s, np.arange(1, 5))
    return np.stack([np.cos(angles), np.sin(angles)])
