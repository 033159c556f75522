# SPDX-License-Identifier: LGPL-2.1-or-later
"""The obstacles around a cable: which it may touch, how far it is from them, and what its nodes keep away from.

A node that is inside an obstacle leaves along a direction that its whole run of nodes agrees on: left to itself each
would take the nearest side, and fold the cable around the obstacle.
"""

from dataclasses import replace
from weakref import WeakKeyDictionary

import numpy as np

from ..geometry.box_tree import to_boxes
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
INSIDE = 4
"""Samples of an element between its nodes."""
FARTHEST = 4.0
"""Distance, in lengths, beyond which no obstacle in reach is."""


class Surroundings:
    """The obstacles that a scene's cable may touch."""

    def __init__(self, scene: Scene, scaling: Scaling):
        self.scene, self.scaling = scene, scaling
        self.radius = scene.rod.radius / scaling.length
        self.keep = self.radius + scene.clearance / scaling.length
        self.indices = np.flatnonzero(in_reach(scene, scene.obstacles))
        self.obstacles = [scene.obstacles[i] for i in self.indices]
        bounds = np.array([each.bounds for each in self.obstacles]).reshape(-1, 2, 3)
        self._seen = WeakKeyDictionary()
        self.boxes = (bounds - scaling.origin) / scaling.length

    def nearest(self, points, within=np.inf):
        """(which, what): indices of the obstacles that may be ``within`` a distance of one of the points (m, 3), and of
        each what is nearest to the points; without units."""
        which = np.flatnonzero(self._at_least(points) <= within)
        world = self.scaling.origin + points * self.scaling.length
        return which, [self._scaled(self.obstacles[i].nearest(world)) for i in which]

    def _at_least(self, points):
        """(obstacles,) lower bounds of their distances from points (m, 3): those of the boxes around them."""
        if not self.obstacles:
            return np.zeros(0)
        low, high = self.boxes.swapaxes(0, 1)
        return np.sqrt(to_boxes(points, low, high).min(axis=0, initial=np.inf))

    def _scaled(self, nearest):
        length = self.scaling.length
        return replace(
            nearest,
            distance=nearest.distance / length,
            center=self.scaling.point(nearest.center),
            radius=nearest.radius / length,
        )

    def gaps(self, shape: Shape, within):
        """(which, gaps (len(which), n+1)) what is left of the distance to keep, of the obstacles ``within`` a distance;
        infinite where a node is held inside it, and near such a node: a cable that comes out of a connector begins at
        its face."""
        which, found = self.nearest(shape.position, within)
        return which, self._gaps(shape, found)

    def _gaps(self, shape, found):
        gap = np.array([each.distance for each in found]).reshape(-1, len(shape.position))
        gap = gap - self.keep
        scene = self.scene
        held = [joint.node for joint in shape.joints]
        held += [0] * (not isinstance(scene.start, Free))
        held += [len(shape.position) - 1] * (not isinstance(scene.end, Free))
        allowed = gap.copy()
        rings = dict(self._rings(shape))
        for node in held:
            away = np.abs(shape.arc_length - shape.arc_length[node])
            missing = np.maximum(-gap[:, node], 0.0)
            # What is as near to a ring as its rim is what the ring is in: there the ring is the contact.
            around = gap[:, node] + self.keep <= rings.get(node, 0.0) * (1 + 1e-6)
            missing = np.where(around, self.keep, missing)[:, None]
            allowed[(missing > 0) & (away <= 2 * missing + 1e-12)] = np.inf
            allowed[:, node] = np.inf
        return allowed

    def _rings(self, shape):
        """(node, radius) of the rings."""
        for support, joint in zip(self.scene.supports, shape.joints, strict=True):
            if isinstance(support, Ring):
                yield joint.node, support.radius / self.scaling.length

    def gap(self, point):
        """What is left at a point (3,) of the distance to keep from the nearest obstacle, and its normal (3,)."""
        _, found = self.nearest(point[None])
        closest = min(found, key=lambda each: each.distance[0])
        return closest.distance[0] - self.keep, closest.normal[0]

    def clearance(self, shape: Shape) -> float:
        """Smallest distance between the surfaces of cable and obstacles, without units."""
        within = 2 * self.keep
        smallest = float(self.between(shape).min(initial=np.inf)) + self.keep
        while self.obstacles and not smallest <= within and within < FARTHEST / 2:
            within *= 4
            smallest = float(self._between(shape, within).min()) + self.keep
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
            self._seen[shape] = self._between(shape, 2 * self.keep)
        return self._seen[shape]

    def _between(self, shape, within):
        share = np.arange(INSIDE) / INSIDE
        fine = (shape.arc_length[:-1, None] + shape.steps[:, None] * share).ravel()
        fine = shape.on(np.append(fine, shape.arc_length[-1]))
        _, gaps = self.gaps(fine, within)
        smallest = gaps.min(axis=0, initial=np.inf)
        return np.minimum(smallest[:-1].reshape(-1, INSIDE).min(axis=1), smallest[INSIDE::INSIDE])

    def features(self, shape: Shape, reach=NEAR, leaving=False):
        """(n+1, contacts, 12) of a shape's nodes, those nearer than ``reach``, and which of the scene's obstacles
        (n+1, contacts) each belongs to, −1 for none; or None."""
        which, found = self.nearest(shape.position, reach + self.keep)
        gap = self._gaps(shape, found)
        near = gap < reach
        count = int(near.sum(axis=0).max(initial=0))
        if count == 0:
            return None
        count = next(n for n in (1, 2, MOST) if n >= min(count, MOST))
        rows = np.array([contact.parameters(each, self.keep) for each in found])
        if leaving:
            for i, each in enumerate(found):
                self._leave(rows[i], which[i], each, shape.position, gap[i])
        order = np.argsort(gap, axis=0)[:count].T
        nodes = np.arange(len(gap[0]))[:, None]
        if order.shape[1] < count:
            order = np.pad(order, ((0, 0), (0, count - order.shape[1])), mode="edge")
        chosen = rows[order, nodes]
        unused = ~near[order, nodes]
        unused[:, 1:] |= order[:, 1:] == order[:, :-1]
        chosen[unused] = contact.NONE
        return chosen, np.where(unused, -1, self.indices[which[order]])

    def _leave(self, rows, i, nearest, points, gap):
        """Faces for the nodes inside an obstacle, across the direction in which each run of them leaves."""
        inside = (nearest.distance < 0) & np.isfinite(gap)
        for a, b in runs(inside):
            run = slice(a, b)
            depth = -nearest.distance[run]
            out = (depth[:, None] * nearest.normal[run]).sum(axis=0)
            if np.linalg.norm(out) < 0.1 * depth.sum():
                out = nearest.normal[run][np.argmin(depth)]
            out = out / np.linalg.norm(out)
            place = points[run].copy()
            for _ in range(30):
                world = self.scaling.origin + place * self.scaling.length
                distance = self._scaled(self.obstacles[i].nearest(world)).distance
                if (distance >= 0).all():
                    break
                place += np.outer(np.maximum(-distance, 0) + 1e-4 * (distance < 0), out)
            rows[run] = 0.0
            rows[run, :3], rows[run, 3:6], rows[run, 11] = place, out, self.keep
