# SPDX-License-Identifier: LGPL-2.1-or-later
"""The obstacles around a cable: which it may touch, how far it is from them, and what its nodes keep away from."""

from dataclasses import replace
from functools import cached_property
from weakref import WeakKeyDictionary

import numpy as np

from ..geometry.bore import Bore
from ..geometry.box_tree import to_boxes
from ..geometry.nearest import Nearest
from ..problem import Free, Ring, Scene
from ..problem.surfaces import nearest_each
from ..problem.surroundings import in_reach
from ..transcription.arms import Places
from ..transcription.scaling import Scaling
from ..transcription.shape import Shape
from .looking import CLOSER, Look, Near, sampled
from .placing import places

NEAR = 0.3
"""Gap, in lengths, up to which a feature is given to a node that may yet move far."""
BESIDE = 0.01
"""The same for a node of a shape that is nearly the answer."""
PENETRATION = 0.01
"""Depth between nodes, in radii of the cable, that is left."""
LEAVING = 10.0
"""Bend radius, in radii of the cable, with which it gets out of an obstacle in which it is held."""
ROOM = 0.2
"""Play of a ring, in radii of the cable, from which the rim of its hole is an obstacle as any other; with less the
cable is squeezed by a rim that it passes at an angle."""
ASKED_FIRST = 2
"""Obstacles that are asked for the clearance before the others: those whose boxes are nearest leave few of them."""
CLOSELY = 1.01 * CLOSER
"""Distance between samples, in radii of the cable, up to which an element has been looked at closely."""
INSIDE = (4, 0.0), (16, 0.0), (16, CLOSER)
"""How the clearance is looked for in an element, and then between samples where it may be: so many samples for one, if
they are more than so many radii of the cable apart."""


class Surroundings:
    """The obstacles that a scene's cable may touch."""

    def __init__(self, scene: Scene, scaling: Scaling, rims=True, more=False):
        """``rims``: whether the rims of rings are obstacles, too. ``more`` (k,): obstacles beside those in reach."""
        self.scene, self.scaling, self.rims = scene, scaling, rims
        self.strict = self
        """the same with the rims of rings"""
        self.radius = scene.rod.radius / scaling.length
        self.keep = self.radius + scene.clearance / scaling.length
        self.indices = np.flatnonzero(in_reach(scene, scene.obstacles) | more)
        self.obstacles = [scene.obstacles[i] for i in self.indices]
        bounds = np.array([each.bounds for each in self.obstacles]).reshape(-1, 2, 3)
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
    def bare(self) -> "Surroundings":
        """The same without clearance: what is beside a node that is held need not keep it, but be outside all the
        same."""
        if not self.scene.clearance:
            return self
        return Surroundings(replace(self.scene, clearance=0.0), self.scaling, self.rims)

    def in_reach_of(self, other: Scene) -> "Surroundings":
        """With what the cable of another scene could reach, too."""
        more = in_reach(other, self.scene.obstacles)
        if np.isin(np.flatnonzero(more), self.indices).all():
            return self
        return Surroundings(self.scene, self.scaling, self.rims, more)

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
        asked, where = [], []
        for i, at_least in zip(beside, self._at_least(points, beside).T, strict=True):
            near = at_least <= within
            if near.any():
                near[list(always)] = True
                asked.append(i)
                where.append(np.flatnonzero(near))
        return self._near(points, asked, where)

    def _near(self, points, numbers, where):
        """Of obstacles by their numbers here, what is nearest to the points with numbers ``where``, each its own."""
        what = self._nearest_of(numbers, [points[each] for each in where])
        return [Near(*each) for each in zip(numbers, where, what, strict=True)]

    def nearest_of(self, i, points) -> Nearest:
        """What of an obstacle, by its number here, is nearest to points (m, 3)."""
        return self._nearest_of([i], [points])[0]

    def _nearest_of(self, numbers, points):
        """The same of several, each with points of its own."""
        length = self.scaling.length
        places = [self.scaling.origin + each * length for each in points]
        found = nearest_each([self.obstacles[i] for i in numbers], places)
        for k, i in enumerate(numbers):
            for _, obstacle, bore in self.holes:
                if obstacle == i:
                    found[k] = bore.nearest(places[k], found[k])
        return [
            replace(
                each,
                distance=each.distance / length,
                center=self.scaling.point(each.center),
                radius=each.radius / length,
            )
            for each in found
        ]

    def _at_least(self, points, obstacles=slice(None)):
        """(m, obstacles) lower bounds of their distances from points (m, 3): those of the boxes around them."""
        low, high = self.boxes[obstacles].swapaxes(0, 1)
        return np.sqrt(to_boxes(points, low, high))

    def held(self, shape: Shape) -> list[int]:
        """Nodes of a shape that are held."""
        return held_nodes(self.scene, shape)

    def gaps(self, shape: Shape, found: list[Near]) -> np.ndarray:
        """(len(found), n+1) what is left of the distance to keep from what was ``found``; infinite where it was not
        looked for, and where a node is held inside it and near such a node: a cable that comes out of a connector
        begins at its face."""
        gap = np.full((len(found), len(shape.position)), np.inf)
        for row, each in zip(gap, found, strict=True):
            row[each.where] = each.what.distance - self.keep
        allowed = gap.copy()
        rings, obstructed = self._rings(shape)
        for node in self.held(shape):
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
        return allowed

    def at_rims(self, shape: Shape) -> set[int]:
        """Nodes at the rings whose rims are obstacles."""
        return self._rings(shape)[1]

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
        if not self.obstacles:
            return np.inf
        look = self.look(shape)
        smallest, at = float(look.least.min()), shape.arc_length
        within = self._at_least(shape.position).min(axis=0) - self.keep - shape.steps.max() / 2
        numbers = np.flatnonzero(within < smallest)
        # What may touch has been looked at inside, but no farther than twice the distance to keep, and in long elements
        # not closely; of other elements the inside may yet be nearer than any node.
        known, apart = np.minimum(look.least, self.keep), shape.steps / np.diff(look.begin)
        known = np.where(apart > CLOSELY * self.radius, known - apart / 2, known)
        bound = np.where(look.bound < 0, known, look.bound)
        for count, finest in INSIDE:
            apart = np.diff(at)
            doubtful = (bound < smallest) & (apart > finest * self.radius)
            if not doubtful.any():
                break
            counts = np.where(doubtful, count, 1)
            fine, _ = sampled(shape, at, counts)
            doubtful, half = np.repeat(doubtful, counts), apart[doubtful].max() / count / 2
            samples = np.flatnonzero(np.append(doubtful, False) | np.append(False, doubtful))
            smallest, least, numbers = self._smallest(fine, samples, numbers, smallest, half)
            at, least = fine.arc_length, np.minimum(least, smallest + half)
            bound = np.where(doubtful, (least[:-1] + least[1:] - np.diff(at)) / 2, np.inf)
        return smallest + self.keep - self.radius

    def _smallest(self, fine, samples, numbers, smallest, half):
        """At these ``samples`` of a shape, by their numbers, and for obstacles by theirs: the smallest gap, if it is
        smaller than ``smallest``; the gap at each sample of the shape, infinite where it is larger than that by more
        than ``half``; and those obstacles that are nowhere farther than that."""
        at_least = self._at_least(fine.position[samples], numbers) - self.keep
        nearest, least = at_least.min(axis=0), np.full(len(fine.position), np.inf)
        for some in np.split(np.argsort(nearest), [ASKED_FIRST]):
            some = some[nearest[some] < smallest + half]
            near = [samples[at_least[:, k] < smallest + half] for k in some]
            gaps = self.gaps(fine, self._near(fine.position, numbers[some], near))
            least = np.minimum(least, gaps.min(axis=0, initial=np.inf))
            smallest = min(smallest, float(least.min()))
        return smallest, least, numbers[nearest < smallest + half]

    def deepest(self, shape: Shape) -> float:
        """How far the cable enters the distance to keep, without units; 0 if no more than it may."""
        depth = -float(self.between(shape).min())
        return depth if depth > PENETRATION * self.radius else 0.0

    def worst(self, shape: Shape):
        """(where, relative to the length, and which of the scene's obstacles) the cable enters most."""
        look = self.look(shape)
        row, sample = np.unravel_index(np.argmin(look.gaps), look.gaps.shape)
        return float(look.fine.arc_length[sample]), int(self.indices[look.found[row].obstacle])

    def intrusion(self, shape: Shape, weighted=True) -> float:
        """Share of the length that is nearer to an obstacle than it may be, ``weighted`` by how much."""
        gap = self.between(shape)
        return float(shape.steps @ np.where(gap < 0, -gap if weighted else 1.0, 0.0))

    def between(self, shape: Shape) -> np.ndarray:
        """(n,) smallest gap over each element, its inside included if it may touch; infinite where no obstacle is
        near."""
        if not self.obstacles:
            return np.full(len(shape.steps), np.inf)
        return self.look(shape).least

    def look(self, shape: Shape, reach=0.0) -> Look:
        """At all that is nearer than ``reach`` to a shape, and at all that it may touch. Asked for often of one
        shape."""
        seen = self._seen.get(shape)
        if seen is None or seen.reach < reach:
            seen = self._seen[shape] = Look.at(self, shape, reach)
        return seen

    def places(self, shape: Shape, reach=NEAR, leaving=False, pushed=None) -> Places | None:
        """Where the elements of a shape keep away from what is nearer than ``reach``; None if nothing is (see
        ``placing``)."""
        return places(self, self.look(shape, reach), reach, leaving, pushed)


def held_nodes(scene: Scene, shape: Shape) -> list[int]:
    """Those at supports and at ends that are not free, in order."""
    ends = [(scene.start, 0), (scene.end, len(shape.position) - 1)]
    held = [node for end, node in ends if not isinstance(end, Free)]
    return sorted({*held, *(joint.node for joint in shape.joints)})
