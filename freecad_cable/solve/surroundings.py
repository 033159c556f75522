# SPDX-License-Identifier: LGPL-2.1-or-later
"""The obstacles around a cable: which it may touch, how far it is from them, and what its nodes keep away from."""

from dataclasses import replace
from functools import cached_property
from weakref import WeakKeyDictionary

import numpy as np

from ..geometry.bore import Bore
from ..geometry.box_tree import to_boxes
from ..problem import Free, Ring, Scene
from ..problem.surroundings import in_reach
from ..transcription import contact
from ..transcription.scaling import Scaling
from ..transcription.shape import Shape
from .leaving import Near, leave

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
CLOSER = 0.25
"""Distance between samples, in radii of the cable, where it may touch: of an edge 1/128 of a radius goes between."""
MOST_INSIDE = 64
"""Samples of an element where it may touch."""


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

    @cached_property
    def holes(self) -> list[tuple[int, int, Bore]]:
        """Round holes that rings are in: number of the support, number of the obstacle, the hole [m]. With less room
        than a cable needs they are left to the rings."""
        room, found = (1 + ROOM) * self.keep * self.scaling.length, []
        for j, ring in enumerate(self.scene.supports):
            if not self._by_rim(ring):
                continue
            center, radius = self.scaling.point(ring.position), ring.radius / self.scaling.length
            for i in np.flatnonzero(self._at_least(center[None])[0] <= 2 * radius):
                bore = self.obstacles[i].bore(ring.position, ring.axis, ring.radius)
                if bore is not None and bore.radius >= room:
                    found.append((j, i, bore))
        return found

    @cached_property
    def posed(self) -> Scene:
        """The scene with rings that leave the cable no more room than the holes that they are in."""
        if not self.holes:
            return self.scene
        supports, keep = list(self.scene.supports), self.keep * self.scaling.length
        for j, _, bore in self.holes:
            radius = bore.way(0.0, keep) + self.scene.rod.radius
            supports[j] = replace(supports[j], radius=min(radius, supports[j].radius))
        return replace(self.scene, supports=tuple(supports))

    def in_holes(self, shape) -> list[int]:
        """Nodes at the rings that are in holes."""
        return sorted({shape.joints[j].node for j, _, _ in self.holes})

    def nearest(self, points, within=np.inf, always=()) -> list[Near]:
        """Of the obstacles that may be ``within`` a distance (one, or m) of one of the points (m, 3), what is nearest
        to the points that may be so near, and to those with these numbers ``always``; without units."""
        farthest = np.max(within)
        low, high = points.min(axis=0) - farthest, points.max(axis=0) + farthest
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
        places = self.scaling.origin + points * length
        nearest = self.obstacles[i].nearest(places)
        for _, obstacle, bore in self.holes:
            if obstacle == i:
                nearest = bore.nearest(places, nearest)
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
        rings, obstructed = self._rings(shape)
        for node in held_nodes(self.scene, shape):
            if node in obstructed:
                continue
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
        """(radius by node of the rings whose rims are left to them, nodes of those whose rims are obstacles)."""
        alone, obstructed = {}, set()
        for support, joint in zip(self.scene.supports, shape.joints, strict=True):
            if self._by_rim(support):
                obstructed.add(joint.node)
            elif isinstance(support, Ring):
                alone[joint.node] = support.radius / self.scaling.length
        return alone, obstructed

    def _by_rim(self, support):
        """Whether a support is a ring whose rim is an obstacle."""
        return (
            self.rims
            and isinstance(support, Ring)
            and support.radius >= (1 + ROOM) * self.scene.rod.radius
        )

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
        fine = _fine(shape, np.full(len(shape.steps), INSIDE))
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

    def worst(self, shape: Shape):
        """(where, relative to the length, and which of the scene's obstacles) the cable enters most."""
        element = int(np.argmin(self.between(shape)))
        places = np.linspace(*shape.arc_length[element : element + 2], MOST_INSIDE)
        fine = shape.on(np.union1d(shape.arc_length, places))
        which, gaps = self.gaps(fine, self._close)
        row, node = np.unravel_index(np.argmin(gaps), gaps.shape)
        return float(fine.arc_length[node]), int(self.indices[which[row]])

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
            counts, apart = np.full(len(shape.steps), INSIDE), shape.steps / INSIDE
            least = self._least(shape, counts, np.maximum(self._close, self.keep + apart))
            # No gap between samples is less than that at the nearer of them by more than half their distance; a node
            # that is held says nothing of what is beside it.
            half = apart / 2
            for node in held_nodes(self.scene, shape):
                half[max(node - 1, 0) : node + 1] *= 2
            doubtful = least < half
            if doubtful.any():
                closer = np.ceil(shape.steps / (CLOSER * self.radius)).clip(INSIDE, MOST_INSIDE)
                counts = np.where(doubtful, closer, 1).astype(int)
                closely = self._least(shape, counts, np.where(doubtful, self._close, 0.0))
                least = np.where(doubtful, closely, least)
            self._seen[shape] = least
        return self._seen[shape]

    def _least(self, shape, counts, within):
        """(n,) smallest gap over each element, at so many (n,) samples each and at its ends; infinite where no obstacle
        is ``within`` a distance (n,)."""
        within = np.append(np.repeat(within, counts), within[-1])
        _, gaps = self.gaps(_fine(shape, counts), within)
        least = gaps.min(axis=0, initial=np.inf)
        begin = np.append(0, np.cumsum(counts))
        return np.minimum(np.minimum.reduceat(least[:-1], begin[:-1]), least[begin[1:]])

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
                leave(row, each, shape.position, left, self.keep, self._nearest)
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


def held_nodes(scene: Scene, shape: Shape) -> list[int]:
    """Those at supports and at ends that are not free, in order."""
    ends = [(scene.start, 0), (scene.end, len(shape.position) - 1)]
    held = [node for end, node in ends if not isinstance(end, Free)]
    return sorted({*held, *(joint.node for joint in shape.joints)})


def _fine(shape, counts):
    """A shape with samples between its nodes, so many (n,) for each element with its first node."""
    begin = np.append(0, np.cumsum(counts))
    part = np.arange(begin[-1]) - np.repeat(begin[:-1], counts)
    within = np.repeat(shape.arc_length[:-1], counts) + part * np.repeat(
        shape.steps / counts, counts
    )
    return shape.on(np.append(within, shape.arc_length[-1]))
