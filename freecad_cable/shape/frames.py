# SPDX-License-Identifier: LGPL-2.1-or-later
"""The moving frame along the cable, with its derivatives."""

from dataclasses import dataclass

import numpy as np

from ..errors import DocumentError
from ..geometry import rotation
from .nodes import in_millimetres

COARSE = 2.0
"""[rad] Largest turn of the frame between two nodes; there a quintic is within 2·10⁻³ of an arc."""


@dataclass(frozen=True, eq=False)
class Frames:
    """The moving frame at the nodes of a run of the cable over which curvature is continuous.

    The parameter is the length of the elongated centreline, so that r' = d3, d_i' = ω × d_i and
    d_i'' = ω' × d_i + ω × (ω × d_i). Everything in mm, in the frame of the positions.
    """

    parameter: np.ndarray
    """(n,) from the start of the cable [mm]"""
    position: np.ndarray
    """(n, 3) [mm]"""
    axes: np.ndarray
    """(n, 3, 3), columns d1, d2, d3"""
    spin: np.ndarray
    """(n, 3) ω [1/mm]"""
    spin_rate: np.ndarray
    """(n, 3) ω' [1/mm²]"""
    twist: np.ndarray
    """(n,) angle about d3 since the start of the cable [rad]"""

    @property
    def tangent(self):
        """(n, 3) d3."""
        return self.axes[:, :, 2]

    def axis(self, k):
        """d_k (k = 0, 1, 2) with its first and second derivative, each (n, 3)."""
        d = self.axes[:, :, k]
        first = rotation.cross(self.spin, d)
        second = rotation.cross(self.spin_rate, d) + rotation.cross(self.spin, first)
        return d, first, second

    def untwisted(self):
        """The same centreline with frames carried along without twist.

        For those ω = t × t', so ω' = t × t''.
        """
        t, first, second = self.axis(2)
        axes = _untwisted(self.axes, self.twist)
        spin, spin_rate = rotation.cross(t, first), rotation.cross(t, second)
        return Frames(
            self.parameter, self.position, axes, spin, spin_rate, np.zeros_like(self.twist)
        )


def frames(nodes) -> list[Frames]:
    """The frames of ``nodes`` (``Nodes`` or ``Solution``), in runs that meet at the supports, where curvature may jump.

    The elongation of a stretched rod is
    taken from the distances between the nodes. Errors: ``DocumentError`` if the nodes are missing,
    malformed, too far apart, or contradict each other.
    """
    s, position, quaternion, curvature, jumps = in_millimetres(nodes)
    step = np.diff(s)
    turn = rotation.logarithm(
        rotation.multiply(rotation.conjugate(quaternion[:-1]), quaternion[1:])
    )
    size = np.linalg.norm(turn, axis=1)
    k = int(np.argmax(size))
    if size[k] > COARSE:
        raise DocumentError(
            f"The cable turns by {size[k]:.2f} rad between its nodes {k} and {k + 1}; a shape needs "
            f"less than {COARSE:g} rad. Solve with more elements."
        )
    mean = turn / step[:, None]
    axes = rotation.matrix(quaternion)
    ends = [0, *jumps, len(step)]
    runs, parameter, twist = [], 0.0, 0.0
    for a, b in zip(ends[:-1], ends[1:], strict=True):
        run = slice(a, b + 1)
        local = _at_nodes(step[a:b], mean[a:b])
        if curvature is not None:
            # A node where curvature jumps has two; given is the one before.
            known = slice(1 if a > 0 else 0, None)
            local[known] = curvature[run][known]
        runs.append(_run(parameter, twist, s[run], position[run], axes[run], local))
        parameter, twist = runs[-1].parameter[-1], runs[-1].twist[-1]
    return runs


def _run(start, twist, s, position, axes, curvature) -> Frames:
    """The frames of one run that begins at the parameter ``start`` with ``twist``."""
    step = np.diff(s)
    bend_1, bend_2, third = curvature.T
    slope = _slopes(step, curvature[:, 2:])[:, 0]
    turns = step / 2 * (third[:-1] + third[1:]) + step**2 / 12 * (slope[:-1] - slope[1:])
    twist = twist + np.concatenate(([0.0], np.cumsum(turns)))
    # Differences between the nodes are taken in frames without twist, which may be fast.
    plain = _untwisted(axes, twist)
    cosine, sine = np.cos(twist), np.sin(twist)
    k = np.stack([cosine * bend_1 - sine * bend_2, sine * bend_1 + cosine * bend_2, third], axis=1)
    rate = _slopes(step, k) + rotation.cross(k * (1, 1, 0), k)
    spin, spin_rate = (np.einsum("nij,nj->ni", plain, x) for x in (k, rate))
    elongation = _elongation(Frames(s, position, axes, spin, spin_rate, twist))
    parameter = start + np.concatenate(([0.0], np.cumsum(step * elongation)))
    ratio = _at_nodes(step, elongation[:, None])
    return Frames(parameter, position, axes, spin / ratio, spin_rate / ratio**2, twist)


def _untwisted(axes, twist):
    """The axes (n, 3, 3) turned back by ``twist`` (n,) about d3."""
    cosine, sine = np.cos(twist)[:, None], np.sin(twist)[:, None]
    d1, d2 = axes[:, :, 0], axes[:, :, 1]
    return np.stack([cosine * d1 - sine * d2, sine * d1 + cosine * d2, axes[:, :, 2]], axis=2)


def _at_nodes(step, mean):
    """Values at the nodes (m+1, d) from the means (m, d) over the pieces between them, order 2."""
    if len(mean) == 1:
        return np.repeat(mean, 2, axis=0)
    weight = (step[:-1] / (step[:-1] + step[1:]))[:, None]
    inner = mean[:-1] + weight * (mean[1:] - mean[:-1])
    return np.concatenate((2 * mean[:1] - inner[:1], inner, 2 * mean[-1:] - inner[-1:]))


def _slopes(step, value):
    """Derivatives at the nodes (m+1, d) of values (m+1, d) there, order 2."""
    return _at_nodes(step, np.diff(value, axis=0) / step[:, None])


def _elongation(unstretched):
    """How many times longer than in ``unstretched`` the pieces between the nodes are: chord over ∫ d3 ds.

    Hermite's rule h (a + b) / 2 + h² (a' − b') / 10 + h³ (a'' + b'') / 120, of order 6.
    """
    h = np.diff(unstretched.parameter)[:, None]
    d, first, second = unstretched.axis(2)
    integral = (
        h / 2 * (d[:-1] + d[1:])
        + h**2 / 10 * (first[:-1] - first[1:])
        + h**3 / 120 * (second[:-1] + second[1:])
    )
    chord = np.linalg.norm(np.diff(unstretched.position, axis=0), axis=1)
    expected = np.linalg.norm(integral, axis=1)
    wrong = (chord < expected / 2) | (chord > 2 * expected)
    if wrong.any():
        k = int(np.argmax(wrong))
        raise DocumentError(
            f"The positions, tangents and arc lengths of the nodes do not belong together: two nodes are "
            f"{chord[k]:.4g} mm apart and should be {expected[k]:.4g} mm apart."
        )
    return chord / expected
