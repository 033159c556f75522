# SPDX-License-Identifier: LGPL-2.1-or-later
"""A rod's nodes without units: what guesses, solutions and meshes hand to each other."""

from dataclasses import dataclass

import numpy as np

from ..geometry import rotation


@dataclass(frozen=True, eq=False)
class Shape:
    """Nodes of a rod of length 1. ``force`` and ``moment`` are None for a guess."""

    arc_length: np.ndarray
    """(n+1,) from 0 to 1"""
    position: np.ndarray
    """(n+1, 3)"""
    quaternion: np.ndarray
    """(n+1, 4) sign-continuous"""
    strain: np.ndarray
    """(n+1, 6) κ1, κ2, τ, γ1, γ2, ε at the nodes"""
    force: np.ndarray | None = None
    """(n+1, 3) what the part beyond the node exerts on the part before it"""
    moment: np.ndarray | None = None
    """(n+1, 3)"""

    @classmethod
    def from_frames(cls, arc_length, position, quaternion):
        """Nodes with curvature from the turn between neighbouring frames."""
        quaternion = rotation.continuous(quaternion)
        turns = rotation.logarithm(
            rotation.multiply(rotation.conjugate(quaternion[:-1]), quaternion[1:])
        )
        middle = turns / np.diff(arc_length)[:, None]
        nodes = np.vstack([middle[:1], (middle[1:] + middle[:-1]) / 2, middle[-1:]])
        return cls(arc_length, position, quaternion, np.hstack([nodes, np.zeros_like(nodes)]))

    @property
    def steps(self) -> np.ndarray:
        """(n,) element lengths"""
        return np.diff(self.arc_length)

    def on(self, arc_length) -> "Shape":
        """The same rod with nodes at other arc lengths; forces and moments go along."""
        if len(arc_length) == len(self.arc_length) and np.array_equal(arc_length, self.arc_length):
            return self

        def linear(values):
            if values is None:
                return None
            return np.stack(
                [np.interp(arc_length, self.arc_length, column) for column in values.T], axis=1
            )

        # Frames along the turn between neighbouring nodes, positions along the cubic that their
        # tangents define: linear ones would shorten the rod.
        k = np.clip(
            np.searchsorted(self.arc_length, arc_length, "right") - 1, 0, len(self.steps) - 1
        )
        h = self.steps[k]
        t = ((arc_length - self.arc_length[k]) / h)[:, None]
        a, b = self.quaternion[k], self.quaternion[k + 1]
        turn = rotation.logarithm(rotation.multiply(rotation.conjugate(a), b))
        quaternion = rotation.continuous(rotation.multiply(a, rotation.exponential(t * turn)))
        h = h[:, None]
        position = (
            (1 + 2 * t) * (1 - t) ** 2 * self.position[k]
            + t * (1 - t) ** 2 * h * rotation.tangent(a)
            + t**2 * (3 - 2 * t) * self.position[k + 1]
            + t**2 * (t - 1) * h * rotation.tangent(b)
        )
        return Shape(
            arc_length,
            position,
            quaternion,
            linear(self.strain),
            linear(self.force),
            linear(self.moment),
        )
