# SPDX-License-Identifier: LGPL-2.1-or-later
"""A rod's nodes without units: what guesses, solutions and meshes hand to each other."""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ..geometry import rotation


@dataclass(frozen=True, eq=False)
class Joint:
    """A node at a support, beyond which loads and strain differ from those before it."""

    node: int
    strain: np.ndarray
    """(6,) beyond the node"""
    force: np.ndarray | None = None
    """(3,) what the support exerts on the rod; None for a guess"""
    moment: np.ndarray | None = None
    """(3,) likewise, about the node"""


@dataclass(frozen=True, eq=False)
class Shape:
    """Nodes of a rod of length 1. ``force`` and ``moment`` are None for a guess. At a joint, strain, force and moment
    are those just before it."""

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
    joints: tuple[Joint, ...] = ()
    error: float | None = None
    """of an earlier solution in contact, its estimate"""

    @classmethod
    def from_frames(cls, arc_length, position, quaternion, joints=()):
        """Nodes with curvature from the turn between neighbouring frames; ``joints`` are nodes."""
        quaternion = rotation.continuous(quaternion)
        turns = rotation.logarithm(
            rotation.multiply(rotation.conjugate(quaternion[:-1]), quaternion[1:])
        )
        middle = turns / np.diff(arc_length)[:, None]
        nodes = np.vstack([middle[:1], (middle[1:] + middle[:-1]) / 2, middle[-1:]])
        beyond = []
        for node in joints:
            nodes[node] = middle[node - 1]
            beyond.append(Joint(node, np.append(middle[node], np.zeros(3))))
        strain = np.hstack([nodes, np.zeros_like(nodes)])
        return cls(arc_length, position, quaternion, strain, joints=tuple(beyond))

    @cached_property
    def steps(self) -> np.ndarray:
        """(n,) element lengths"""
        return np.diff(self.arc_length)

    @property
    def ends(self) -> list[int]:
        """Nodes where stretches begin and end."""
        return [0, *(joint.node for joint in self.joints), len(self.steps)]

    @property
    def stretches(self) -> tuple[int, ...]:
        """Elements between one joint and the next."""
        return tuple(b - a for a, b in zip(self.ends, self.ends[1:], strict=False))

    def parts(self) -> list["Shape"]:
        """The stretches, each with what is true between its own first and last node."""
        if not self.joints:
            return [self]
        return [
            self._part(a, b, joint)
            for a, b, joint in zip(self.ends, self.ends[1:], (None, *self.joints), strict=False)
        ]

    def _part(self, a, b, joint):
        def cut(values, change):
            if values is None or change is None:
                return None if values is None else values[a : b + 1]
            values = values[a : b + 1].copy()
            values[0] = change(values[0])
            return values

        known = joint is not None and joint.force is not None
        return Shape(
            self.arc_length[a : b + 1],
            self.position[a : b + 1],
            self.quaternion[a : b + 1],
            cut(self.strain, None if joint is None else lambda _: joint.strain),
            cut(self.force, (lambda n: n - joint.force) if known else None),
            cut(self.moment, (lambda m: m - joint.moment) if known else None),
        )

    def strains_at_ends(self) -> tuple[np.ndarray, np.ndarray]:
        """(n, 6) at the first and at the last node of each element"""
        first = self.strain[:-1].copy()
        for joint in self.joints:
            first[joint.node] = joint.strain
        return first, self.strain[1:]

    def strains_between(self) -> np.ndarray:
        """(n, 6) constant over each element: curvature and twist that turn one node's frame into the next."""
        first, last = self.strains_at_ends()
        strain = (first + last) / 2
        turns = rotation.multiply(rotation.conjugate(self.quaternion[:-1]), self.quaternion[1:])
        strain[:, :3] = rotation.logarithm(turns) / self.steps[:, None]
        return strain

    def cubic(self, elements, share):
        """Point, first and second derivative (…, 3) over the share (…) of elements, by their numbers (…), of the cubic
        that the positions and tangents of their nodes define."""
        u, h = share[..., None], self.steps[elements][..., None]
        begin, tangents = self.position[elements], rotation.tangent(self.quaternion)
        span = self.position[elements + 1] - begin
        t0, t1 = h * tangents[elements], h * tangents[elements + 1]
        c2, c3 = 3 * span - 2 * t0 - t1, t0 + t1 - 2 * span
        return (
            begin + u * (t0 + u * (c2 + u * c3)),
            t0 + u * (2 * c2 + 3 * u * c3),
            2 * c2 + 6 * u * c3,
        )

    def elements_at(self, arc_length):
        """Numbers (…) of the elements that arc lengths (…) are on, and the share of each up to there."""
        k = np.searchsorted(self.arc_length, arc_length, "right") - 1
        k = np.clip(k, 0, len(self.steps) - 1)
        return k, (arc_length - self.arc_length[k]) / self.steps[k]

    def in_units(self, force, length=1.0) -> "Shape":
        """A solved shape in other units: of ``force`` and of ``length`` so many times as many."""
        curved, moment = np.repeat([1 / length, 1.0], 3), force * length
        joints = tuple(
            Joint(each.node, curved * each.strain, force * each.force, moment * each.moment)
            for each in self.joints
        )
        return replace(
            self,
            position=length * self.position,
            strain=curved * self.strain,
            force=force * self.force,
            moment=moment * self.moment,
            joints=joints,
        )

    def on(self, arc_length) -> "Shape":
        """The same rod with nodes at other arc lengths, those of the joints among them; forces and moments go
        along."""
        if arc_length is self.arc_length or np.array_equal(arc_length, self.arc_length):
            return self
        places = [self.arc_length[joint.node] for joint in self.joints]
        nodes = [0, *np.searchsorted(arc_length, np.array(places) - 1e-12), len(arc_length) - 1]
        parts = [
            part._between_joints(arc_length[a : b + 1])
            for part, a, b in zip(self.parts(), nodes, nodes[1:], strict=False)
        ]

        def joined(name):
            values = [getattr(part, name) for part in parts]
            if values[0] is None:
                return None
            return np.vstack([values[0], *(later[1:] for later in values[1:])])

        return Shape(
            arc_length,
            joined("position"),
            joined("quaternion"),
            joined("strain"),
            joined("force"),
            joined("moment"),
            tuple(
                replace(joint, node=int(node))
                for joint, node in zip(self.joints, nodes[1:-1], strict=True)
            ),
        )

    def _between_joints(self, arc_length) -> "Shape":
        def linear(values):
            if values is None:
                return None
            return np.stack(
                [np.interp(arc_length, self.arc_length, column) for column in values.T], axis=1
            )

        # Frames along the turn between neighbouring nodes, positions along the cubic: linear ones would be shorter.
        k, share = self.elements_at(arc_length)
        quaternion = rotation.between(self.quaternion[k], self.quaternion[k + 1], share)
        return Shape(
            arc_length,
            self.cubic(k, share)[0],
            rotation.continuous(quaternion),
            linear(self.strain),
            linear(self.force),
            linear(self.moment),
        )
