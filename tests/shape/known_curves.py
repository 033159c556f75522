# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nodes of rods whose curvature is given: what the tests of this room start from."""

import functools
import math

import numpy as np

from freecad_cable.geometry import rotation
from freecad_cable.shape.nodes import Nodes

RADIUS = 0.004


def rod(parts, elements) -> Nodes:
    """About ``elements`` elements over ``parts``, (length [m], curvature(s) -> (3,) [1/m]) one after another.

    There is a node at every joint, where curvature may jump as at a support. r' = d3 and q' = q ∘ (0, κ) / 2 by the
    classical Runge–Kutta method, in steps over which the frame turns by less than 0.01 rad: the error of a step is
    about 0.01⁵/120, that of a cable below 10⁻⁹ rad.
    """
    total = sum(length for length, _ in parts)
    arc_length, state, curvatures = [0.0], [np.array([0.0, 0, 0, 1, 0, 0, 0])], []
    jumps = []
    for length, curvature in parts:
        count = max(1, round(elements * length / total))
        start = arc_length[-1]
        ends = np.linspace(0, length, count + 1)
        if not curvatures:
            curvatures.append(curvature(0.0))
        elif not np.allclose(curvatures[-1], curvature(0.0)):
            jumps.append(len(state) - 1)
        for a, b in zip(ends[:-1], ends[1:], strict=True):
            state.append(_runge_kutta(state[-1], curvature, a, b))
            arc_length.append(start + b)
            curvatures.append(curvature(b))
    state = np.array(state)
    return Nodes(
        np.array(arc_length), state[:, :3], state[:, 3:], np.array(curvatures), tuple(jumps)
    )


def picked(nodes, chosen) -> Nodes:
    """Some of the nodes of a rod without joints, by index or mask."""
    arrays = {name: x[chosen] for name, x in vars(nodes).items() if name != "support_nodes"}
    return Nodes(**arrays)


def _runge_kutta(state, curvature, start, end):
    def slope(s, x):
        turning = np.append(0.0, curvature(s))
        return np.concatenate([rotation.tangent(x[3:]), rotation.multiply(x[3:], turning) / 2])

    steps = max(2, math.ceil((end - start) * np.linalg.norm(curvature((start + end) / 2)) / 0.01))
    h = (end - start) / steps
    for k in range(steps):
        s = start + k * h
        a = slope(s, state)
        b = slope(s + h / 2, state + h / 2 * a)
        c = slope(s + h / 2, state + h / 2 * b)
        d = slope(s + h, state + h * c)
        state = state + h / 6 * (a + 2 * b + 2 * c + d)
        state[3:] /= np.linalg.norm(state[3:])
    return state


def arc(radius, angle):
    """A part: an arc of a circle about −d2 or, with a negative radius, d2."""
    return abs(radius) * angle, lambda s: np.array([0.0, 1 / radius, 0.0])


def straight(length):
    """A part: a straight line."""
    return length, lambda s: np.zeros(3)


def coil(radius, pitch, turns):
    """A part: a helix whose frame does not turn against its normal."""
    rise = pitch / (2 * math.pi)
    square = radius**2 + rise**2
    return 2 * math.pi * turns * math.sqrt(square), lambda s: np.array(
        [0.0, radius / square, rise / square]
    )


def sagging(s):
    """Curvature of a freely sagging cable, 0.73 m long, with twist."""
    return np.array(
        [6 * math.cos(2 * math.pi * s / 0.73), 4 * math.sin(6 * s / 0.73) + 2, 1.5 - 2 * s]
    )


@functools.cache
def sag(elements=50) -> Nodes:
    return rod([(0.73, sagging)], elements)


@functools.cache
def rod_like() -> dict:
    """Cables with continuous curvature, 50 elements or so each."""
    planar = (0.8, lambda s: np.array([0.0, 8 * math.cos(2 * math.pi * s / 0.8), 0.0]))
    return {
        "sag in space": sag(),
        "planar sag": rod([planar], 50),
        "coil of three turns": rod([coil(0.05, 0.02, 3)], 60),
        "straight line": rod([straight(0.6)], 50),
    }


@functools.cache
def with_jumps() -> dict:
    """Cables whose curvature jumps: exactly straight leads into arcs."""
    quarter = math.pi / 2
    leads = straight(0.2)
    return {
        "S-bend": rod([leads, arc(0.1, quarter), arc(-0.1, quarter), leads], 60),
        "tight U-bend": rod([straight(0.3), arc(0.006, math.pi), straight(0.3)], 120),
    }


def turning(nodes):
    """Angle by which the tangent of ``nodes`` turns in all [rad]."""
    bend = np.linalg.norm(nodes.curvature[:, :2], axis=1)
    return float(np.sum((bend[1:] + bend[:-1]) / 2 * np.diff(nodes.arc_length)))


def changed(nodes, **fields) -> Nodes:
    """``nodes`` with other values in some fields."""
    return Nodes(**{**vars(nodes), **fields})


def scaled(nodes, factor) -> Nodes:
    """The same rod, ``factor`` times as large."""
    return Nodes(
        nodes.arc_length * factor,
        nodes.position * factor,
        nodes.quaternion,
        nodes.curvature / factor,
    )
