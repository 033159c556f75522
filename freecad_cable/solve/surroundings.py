# SPDX-License-Identifier: LGPL-2.1-or-later
"""The obstacles around a cable: which it may touch, how far it is from them, and what its nodes keep away from.

A node that is inside an obstacle leaves along a direction that its whole run of nodes agrees on: left to itself each
would take the nearest side, and fold the cable around the obstacle.
"""

from dataclasses import dataclass, replace
from weakref import WeakKeyDictionary

import numpy as np

from ..geometry.box_tree import to_boxes
from ..geometry.nearest import Nearest
from ..geometry.runs import runs
from ..problem import Free, Ring, Scene
from ..problem.surroundings import in_reach
from ..transcription import contact
from ..transcription.scaling import Scaling
from ..transcription.shape import Shape

NEAR = 0.3
"""Gap, in lengths, up to which a feature is given to a node that may yet move far."""
BESIDE = 0.03
"""The same for a node of a shape that is nearly the answer."""
MOST = 4
"""Features of a node."""
PENETRATION = 0.01
"""Depth between nodes, in radii of the cable, that is left."""
LEAVING = 10.0
"""Bend radius, in radii of the cable, with which it gets out of an obstacle in which it is held."""
ROOM = 0.2
"""Play of a ring, in radii of the cable, from which the rim of its hole is an obstacle as any other; with less the
cable is squeezed by a rim that it passes at an angle."""
INSIDE = 4
"""Samples of an element between its nodes."""


@dataclass(frozen=True, eq=False)
class Near:
    """What is nearest of an obstacle, its number among those of the surroundings, to points with numbers ``where``."""

    obstacle: int
    where: np.ndarray
    what: Nearest


class Surroundings:
    """The obstacles that a scene's cable may touch."""

    def __init__(self, scene: Scene, scaling: Scaling, rims=True):
        """``rims``: whether the rims of rings are obstacles, too."""
        self.scene, self.scaling, self.rims = scene, scaling, rims
        self.strict = self
        """the same with the rims of rings"""
        self.radius = scene.rod.radius / scaling.length
        self.keep = self.radius + scene.clearance / scaling.length
        self.indices = np.flatnonzero(in_reach(scene, scene.obstacles))
        self.obstacles = [scene.obstacles[i] for i in self.indices]
        bounds = np.array([each.bounds for each in self.obstacles]).reshape(-1, 2, 3)
        self._close = 2 * self.keep
        self._seen = WeakKeyDictionary()
        self.boxes = (bounds - scaling.origin) / scaling.length

    def without_rims(self) -> "Surroundings":
        """The same where the rims of rings are left to the rings, which let pass what has room in their plane."""
        if not self.rims or not any(isinstance(each, Ring) for each in self.scene.supports):
            return self
        other = Surroundings(self.scene, self.scaling, rims=False)
        other.strict = self
        return other

    def nearest(self, points, within=np.inf, always=()) -> list["Near"]:
        """Of the obstacles that may be ``within`` a distance of one of the points (m, 3), what is nearest to the points
        that may be so near, and to those with these numbers ``always``; without units."""
        low, high = points.min(axis=0) - within, points.max(axis=0) + within
        beside = np.flatnonzero(
            ((self.boxes[:, 0] <= high) & (self.boxes[:, 1] >= low)).all(axis=1)
        )
        found = []
        for i, at_least in zip(beside, self._at_least(points, beside).T, strict=True):
            near = at_least <= within
            if near.any():
                near[list(always)] = True
                found.append(self._near(i, points, np.flatnonzero(near)))
        return found

    def _near(self, i, points, where):
        return Near(i, where, self._nearest(i, points[where]))

    def _nearest(self, i, points):
        length = self.scaling.length
        nearest = self.obstacles[i].nearest(self.scaling.origin + points * length)
        return replace(
            nearest,
            distance=nearest.distance / length,
            center=self.scaling.point(nearest.center),
            radius=nearest.radius / length,
        )

    def _at_least(self, points, obstacles=slice(None)):
        """(m, obstacles) lower bounds of their distances from points (m, 3): those of the boxes around them."""
        low, high = self.boxes[obstacles].swapaxes(0, 1)
        return np.sqrt(to_boxes(points, low, high))

    def gaps(self, shape: Shape, within):
        """(which, gaps (len(which), n+1)) what is left of the distance to keep, of the obstacles ``within`` a distance;
        infinite beyond it, where a node is held inside it, and near such a node: a cable that comes out of a connector
        begins at its face."""
        found = self.nearest(shape.position, within, held_nodes(self.scene, shape))
        return np.array([each.obstacle for each in found], int), self._gaps(shape, found)

    def _gaps(self, shape, found):
        gap = np.full((len(found), len(shape.position)), np.inf)
        for row, each in zip(gap, found, strict=True):
            row[each.where] = each.what.distance - self.keep
        allowed = gap.copy()
        rings = dict(self._rings(shape))
        for node in held_nodes(self.scene, shape):
            away = np.abs(shape.arc_length - shape.arc_length[node])
            missing = np.maximum(-gap[:, node], 0.0)
            # What is as near to a ring as its rim is what the ring is in: there the ring is the contact.
            around = gap[:, node] + self.keep <= rings.get(node, 0.0) * (1 + 1e-6)
            missing = np.where(around, self.keep, missing)[:, None]
            # One that is held a little inside a surface along which it leaves bends out of it.
            bent_out = np.minimum(np.sqrt(2 * missing * LEAVING * self.radius), 2 * self.radius)
            beside = away <= np.maximum(2 * missing, bent_out) + 1e-12
            allowed[(missing > 0) & beside] = np.inf
            allowed[:, node] = np.inf
        return allowed

    def _rings(self, shape):
        """(node, radius) of the rings whose rims are left to them."""
        for support, joint in zip(self.scene.supports, shape.joints, strict=True):
            if isinstance(support, Ring):
                radius = support.radius / self.scaling.length
                if not self.rims or radius < (1 + ROOM) * self.radius:
                    yield joint.node, radius

    def gap(self, point):
        """What is left at a point (3,) of the distance to keep from the nearest obstacle, and its normal (3,)."""
        found = [each.what for each in self.nearest(point[None])]
        closest = min(found, key=lambda each: each.distance[0])
        return closest.distance[0] - self.keep, closest.normal[0]

    def clearance(self, shape: Shape) -> float:
        """Smallest distance between the surfaces of cable and obstacles, without units."""
        smallest = float(self.between(shape).min(initial=np.inf)) + self.keep
        if not self.obstacles or smallest < self._close:
            return smallest - self.radius
        fine = _fine(shape)
        at_least = self._at_least(fine.position)
        nearest = at_least.min(axis=0)
        for i in np.argsort(nearest):
            if nearest[i] >= smallest:
                break
            near = np.flatnonzero(at_least[:, i] < smallest)
            gap = self._gaps(fine, [self._near(i, fine.position, near)])
            smallest = min(smallest, float(gap.min()) + self.keep)
        return smallest - self.radius

    def deepest(self, shape: Shape) -> float:
        """How far the cable enters the distance to keep, without units; 0 if no more than it may."""
        depth = -float(self.between(shape).min())
        return depth if depth > PENETRATION * self.radius else 0.0

    def intrusion(self, shape: Shape, weighted=True) -> float:
        """Share of the length that is nearer to an obstacle than it may be, ``weighted`` by how much."""
        gap = self.between(shape)
        return float(shape.steps @ np.where(gap < 0, -gap if weighted else 1.0, 0.0))

    def between(self, shape: Shape) -> np.ndarray:
        """(n,) smallest gap over each element, its inside included; infinite where no obstacle is within twice the
        distance to keep. Asked for often of one shape."""
        if not self.obstacles:
            return np.full(len(shape.steps), np.inf)
        if shape not in self._seen:
            _, gaps = self.gaps(_fine(shape), self._close)
            least = gaps.min(axis=0, initial=np.inf)
            inside = least[:-1].reshape(-1, INSIDE).min(axis=1)
            self._seen[shape] = np.minimum(inside, least[INSIDE::INSIDE])
        return self._seen[shape]

    def features(self, shape: Shape, reach=NEAR, leaving=False):
        """(n+1, contacts, 12) of a shape's nodes, those nearer than ``reach``, and which of the scene's obstacles
        (n+1, contacts) each belongs to, −1 for none; or None."""
        found = self.nearest(shape.position, reach + self.keep, held_nodes(self.scene, shape))
        gap = self._gaps(shape, found)
        near = gap < reach
        count = int(near.sum(axis=0).max(initial=0))
        if count == 0:
            return None
        count = next(n for n in (1, 2, MOST) if n >= min(count, MOST))
        rows = np.tile(contact.NONE, (*gap.shape, 1))
        for row, each, left in zip(rows, found, gap, strict=True):
            row[each.where] = contact.parameters(each.what, self.keep)
            if leaving:
                self._leave(row, each, shape.position, left)
        order = np.argsort(gap, axis=0)[:count].T
        nodes = np.arange(len(gap[0]))[:, None]
        if order.shape[1] < count:
            order = np.pad(order, ((0, 0), (0, count - order.shape[1])), mode="edge")
        chosen = rows[order, nodes]
        unused = ~near[order, nodes]
        unused[:, 1:] |= order[:, 1:] == order[:, :-1]
        chosen[unused] = contact.NONE
        which = self.indices[[each.obstacle for each in found]]
        return chosen, np.where(unused, -1, which[order])

    def _leave(self, rows, near, points, gap):
        """Faces for the nodes inside an obstacle, across the direction in which each run of them leaves."""
        distance, normal = np.full(len(points), np.inf), np.zeros((len(points), 3))
        distance[near.where], normal[near.where] = near.what.distance, near.what.normal
        inside = (distance < 0) & np.isfinite(gap)
        for a, b in runs(inside):
            run = slice(a, b)
            depth = -distance[run]
            out = (depth[:, None] * normal[run]).sum(axis=0)
            if np.linalg.norm(out) < 0.1 * depth.sum():
                out = normal[run][np.argmin(depth)]
            out = out / np.linalg.norm(out)
            place = points[run].copy()
            for _ in range(30):
                left = self._nearest(near.obstacle, place).distance
                if (left >= 0).all():
                    break
                place += np.outer(np.maximum(-left, 0) + 1e-4 * (left < 0), out)
            rows[run] = 0.0
            rows[run, :3], rows[run, 3:6], rows[run, 11] = place, out, self.keep


def held_nodes(scene: Scene, shape: Shape) -> list[int]:
    """Those at supports and at ends that are not free, in order."""
    ends = [(scene.start, 0), (scene.end, len(shape.position) - 1)]
    held = [node for end, node in ends if not isinstance(end, Free)]
    return sorted({*held, *(joint.node for joint in shape.joints)})


def _fine(shape):
    """A shape with samples between its nodes."""
    share = np.arange(INSIDE) / INSIDE
    within = (shape.arc_length[:-1, None] + shape.steps[:, None] * share).ravel()
    return shape.on(np.append(within, shape.arc_length[-1]))
