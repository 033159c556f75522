# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cable as an obstacle of its own: which of its nodes keep away from which of its elements.

A node and the point of the cable that is nearest to it, from the parts that follow, make a link. What the one exerts on
the other the other exerts on it, so both move: links are rows between distant stages of one program.
"""

from dataclasses import dataclass
from weakref import WeakKeyDictionary

import numpy as np

from ..geometry import rotation
from ..geometry.nearest import LINE, POINT, Nearest
from ..geometry.runs import runs
from ..geometry.self_contact import TIGHTEST, excused_by, self_penetrations
from ..transcription import contact
from .surroundings import PENETRATION, held_nodes

CROSSING = 0.2
"""Sine of the angle between two parts from which they are taken to cross, not to lie side by side."""
PLACES = 4
"""Places where a cable is in itself that a first mesh gathers at."""


@dataclass(frozen=True, eq=False)
class Links:
    """Of k links: ``pairs`` (node, first node of the element), the ``parameters`` (k, 13) of their rows, and the
    ``distance`` (k,) of node and element."""

    pairs: tuple[tuple[int, int], ...]
    parameters: np.ndarray
    distance: np.ndarray


@dataclass(frozen=True, eq=False)
class Touches:
    """Of the k links of a solved rod that push: nodes, elements and shares of these (k,), arc lengths ``here`` of the
    node and ``there`` on the element (k,), forces on the node (k, 3) and gaps (k,), without units."""

    nodes: np.ndarray
    elements: np.ndarray
    share: np.ndarray
    here: np.ndarray
    there: np.ndarray
    forces: np.ndarray
    gaps: np.ndarray

    @classmethod
    def of(cls, shape, links, push) -> "Touches":
        """``push`` (k,) of all links, 0 of those that do not act; ``links`` None if there are none."""
        if links is None:
            return NOWHERE
        acting = np.flatnonzero(push)
        nodes, elements = np.array(links.pairs, int)[acting].T
        given = links.parameters[acting]
        share, r = given[:, -1], shape.position
        away = r[nodes] - _between(r, elements, share)
        return cls(
            nodes,
            elements,
            share,
            shape.arc_length[nodes],
            shape.arc_length[elements] + share * shape.steps[elements],
            push[acting, None] * contact.slope(away, given),
            contact.value(away, given),
        )

    def on_nodes(self, count):
        """(count, 3) on each node; what acts on an element is shared by its nodes."""
        total, share = np.zeros((count, 3)), self.share[:, None]
        if not len(self.nodes):
            return total
        np.add.at(total, self.nodes, self.forces)
        np.add.at(total, self.elements, -(1 - share) * self.forces)
        np.add.at(total, self.elements + 1, -share * self.forces)
        return total

    def places(self, radius):
        """Links (index arrays) of each place where the rod touches itself."""
        parted = np.diff(self.nodes) > 1
        parted |= np.abs(np.diff(self.there)) > 4 * (np.diff(self.here) + radius)
        found = np.split(np.arange(len(self.nodes)), np.flatnonzero(parted) + 1)
        return [place for place in found if len(place)]


NOWHERE = Touches(*np.zeros((2, 0), int), *np.zeros((3, 0)), np.zeros((0, 3)), np.zeros(0))


class Own:
    """The cable of a scene, without units."""

    def __init__(self, scene, scaling):
        self.scene, self.radius = scene, scene.rod.radius / scaling.length
        self._seen = WeakKeyDictionary()

    def depths(self, shape):
        """Places where a shape is in itself by more than it may: (depth, arc length, other arc length), deepest
        first. Asked for often of one shape."""
        if shape not in self._seen:
            nodes = shape.arc_length, shape.position, shape.quaternion
            found = self_penetrations(*nodes, self.radius, held_nodes(self.scene, shape))
            self._seen[shape] = [each for each in found if each[0] > PENETRATION * self.radius]
        return self._seen[shape]

    def links(self, shape, reach, leaving=0) -> Links | None:
        """Of the nodes of a shape that are within a diameter and ``reach`` of another part of it, or None.

        ``leaving``, 1 or −1: parts that are in each other leave along one direction, the nearest way or the other."""
        nodes, elements, share, beyond = self._approaches(shape, reach)
        if not len(nodes):
            return None
        point, slope, _ = shape.cubic(elements, share)
        axis = slope / np.linalg.norm(slope, axis=1)[:, None]
        away = shape.position[nodes] - point
        distance = np.linalg.norm(away, axis=1)
        # Measured from the chord: between lookups a part of the cable moves as its chord does.
        bow = point - _between(shape.position, elements, share)
        kind, radius = np.where(beyond, POINT, LINE), np.full(len(nodes), self.radius)
        parameters = contact.parameters(
            Nearest(distance, away, kind, bow, axis, radius), self.radius
        )
        if leaving:
            arc_length = shape.arc_length[elements] + share * shape.steps[elements]
            tangents = rotation.tangent(shape.quaternion[nodes]), axis
            inside = distance < 2 * self.radius
            self._leave(parameters, inside, nodes, arc_length, away, tangents, leaving)
        return Links(
            tuple(zip(nodes.tolist(), elements.tolist(), strict=True)),
            np.column_stack([parameters, share]),
            distance,
        )

    def _approaches(self, shape, reach):
        """Nodes (k,), elements (k,) after them with a section in whose plane the node lies, nearer than those beside,
        the share of the element (k,) where that is, and whether the node is beyond the end of the cable (k,)."""
        r, s, tangents = shape.position, shape.arc_length, rotation.tangent(shape.quaternion)
        away = r[:, None] - r[None]
        ahead = np.einsum("ijk,jk->ij", away, tangents)
        near = np.einsum("ijk,ijk->ij", away, away)
        steps = shape.steps
        near = np.minimum(near[:, :-1], near[:, 1:]) < (2 * self.radius + reach + steps) ** 2
        passed = (ahead[:, :-1] > 0) & (ahead[:, 1:] <= 0)
        passed[:, -1] |= ahead[:, -1] > 0
        nodes, elements = np.nonzero(near & passed & (s[:-1] > s[:, None]))
        before, after = ahead[nodes, elements], ahead[nodes, elements + 1]
        beyond = after > 0
        share = np.where(beyond, 1.0, before / np.maximum(before - after, 1e-300))
        for _ in range(4):
            point, slope, bend = shape.cubic(elements, share)
            apart = r[nodes] - point
            missed = np.einsum("ki,ki->k", apart, slope)
            change = np.einsum("ki,ki->k", slope, slope) - np.einsum("ki,ki->k", apart, bend)
            good = ~beyond & (change > 0)
            share = share + np.where(good, missed / np.where(good, change, 1.0), 0.0)
            share = np.clip(share, 0.0, 1.0)
        apart = np.linalg.norm(r[nodes] - shape.cubic(elements, share)[0], axis=1)
        there = s[elements] + share * steps[elements]
        good = (apart < 2 * self.radius + reach) & (there - s[nodes] > TIGHTEST * self.radius)
        held = held_nodes(self.scene, shape)
        good &= ~excused_by(s[held], r[held], self.radius)(s[nodes], there)
        # What the program cannot move needs no row.
        fixed = np.isin(nodes, held) & np.isin(elements + share, held)
        good &= ~fixed
        return nodes[good], elements[good], share[good], beyond[good]

    def _leave(self, parameters, inside, nodes, there, away, tangents, sign):
        """Faces for the links inside, across the direction in which each run of them leaves."""
        for a, b in runs(inside):
            cuts = np.flatnonzero(
                (np.diff(nodes[a:b]) > 1) | (np.abs(np.diff(there[a:b])) > 8 * self.radius)
            )
            for run in np.split(np.arange(a, b), cuts + 1):
                worst = run[np.argmin(np.linalg.norm(away[run], axis=1))]
                across = rotation.cross(tangents[0][worst], tangents[1][worst])
                if np.linalg.norm(across) > CROSSING:
                    out = across * (-sign if across @ away[worst] < 0 else sign)
                else:
                    out = away[worst]
                if not out.any():
                    out = np.cross(tangents[0][worst], np.roll(tangents[0][worst], 1))
                parameters[run, 3:6] = out / np.linalg.norm(out)
                parameters[run, 6:11] = 0.0
                parameters[run, 11] = 2 * self.radius

    def mesh_places(self, shape):
        """Arc lengths where it is deepest in itself."""
        return [s for _, *both in self.depths(shape)[:PLACES] for s in both]


def _between(position, elements, share):
    share = share[:, None]
    return (1 - share) * position[elements] + share * position[elements + 1]
