# SPDX-License-Identifier: LGPL-2.1-or-later
"""Obstacles: solids that the cable must not enter.

An obstacle tells of points (m, 3) [m] its ``nearest`` features: a flat face, a round or sharp edge, a ball or corner.
The distance to a feature is smooth, and for a solid made of features it is the exact distance to the solid
wherever that feature is the nearest. Inside a convex solid the nearest face is the feature.
"""

from dataclasses import dataclass, field
from functools import cached_property
from typing import ClassVar

import numpy as np

from ..errors import ProblemError
from ..geometry import rotation
from ..geometry.bore import Bore
from ..geometry.nearest import FLAT, LINE, POINT, ROUNDING, Nearest, measured, perpendicular
from .checked import direction, number, vector

EVERYWHERE = np.array([np.full(3, -np.inf), np.full(3, np.inf)])
"""Corners (2, 3) of a box without bounds."""


@dataclass(frozen=True, eq=False)
class Obstacle:
    """Common to all obstacles."""

    kind: ClassVar[str]
    place: str = field(default="obstacles", kw_only=True)
    """how error messages name it"""

    def nearest(self, points) -> Nearest:
        """Distance and nearest feature of points (m, 3) [m]."""
        raise NotImplementedError

    @property
    def bounds(self) -> np.ndarray:
        """(2, 3) [m] corners of a box around it, infinite where it is."""
        raise NotImplementedError

    def bore(self, center, axis, radius) -> Bore | None:
        """The round hole through it that a circle [m] is in, see ``Bore.around``; looked for once."""
        circle = (*center, *axis, radius)
        if circle not in self._bores:
            distance = lambda points: self.nearest(points).distance  # noqa: E731
            self._bores[circle] = Bore.around(center, axis, radius, distance)
        return self._bores[circle]

    @cached_property
    def _bores(self) -> dict:
        return {}

    def _keep(self, check, name, **bounds):
        """Replace a field by its checked value."""
        object.__setattr__(self, name, check(f"{self.place}.{name}", getattr(self, name), **bounds))


@dataclass(frozen=True, eq=False)
class HalfSpace(Obstacle):
    """All behind the plane through ``point`` (3,) [m] with outward ``normal`` (3,), normalised on input."""

    kind = "half_space"
    point: np.ndarray
    normal: np.ndarray

    def __post_init__(self):
        self._keep(vector, "point")
        self._keep(direction, "normal")

    def nearest(self, points) -> Nearest:
        height = (points - self.point) @ self.normal
        foot = points - height[:, None] * self.normal
        return measured(points, FLAT, foot, self.normal, 0.0, self.normal)

    @property
    def bounds(self):
        bounds = EVERYWHERE.copy()
        axis = np.argmax(np.abs(self.normal))
        if np.abs(self.normal[axis]) == 1:
            bounds[int(self.normal[axis] > 0), axis] = self.point[axis]
        return bounds


@dataclass(frozen=True, eq=False)
class Sphere(Obstacle):
    """A ball about ``center`` (3,) [m] with ``radius`` [m]."""

    kind = "sphere"
    center: np.ndarray
    radius: float

    def __post_init__(self):
        self._keep(vector, "center")
        self._keep(number, "radius", above=0, unit="m")

    def nearest(self, points) -> Nearest:
        return measured(points, POINT, self.center, np.zeros(3), self.radius, (0.0, 0.0, 1.0))

    @property
    def bounds(self):
        return np.array([self.center - self.radius, self.center + self.radius])


@dataclass(frozen=True, eq=False)
class Cylinder(Obstacle):
    """A cylinder with flat caps, its axis from ``start`` (3,) to ``end`` (3,) [m], with ``radius`` [m].

    A rim is a circle, and its feature the tangent line at its nearest point: right to first order, so it must be
    refreshed as the point moves along the rim.
    """

    kind = "cylinder"
    start: np.ndarray
    end: np.ndarray
    radius: float

    def __post_init__(self):
        self._keep(vector, "start")
        self._keep(vector, "end")
        self._keep(number, "radius", above=0, unit="m")
        if not np.linalg.norm(self.end - self.start) > 1e-12 * np.abs([self.start, self.end]).max():
            raise ProblemError(
                f"{self.place}.end",
                f"is {self.end.tolist()}, the same point as start; the axis must have a length",
            )

    def nearest(self, points) -> Nearest:
        span = self.end - self.start
        height = np.linalg.norm(span)
        axis = span / height
        along = (points - self.start) @ axis
        across = points - self.start - along[:, None] * axis
        off = np.linalg.norm(across, axis=1)
        # Distances over the wall, and over the cap on the point's side of the middle.
        side, top = (
            np.where(along > height / 2, 1.0, -1.0),
            np.where(along > height / 2, height, 0.0),
        )
        over_wall, over_cap = off - self.radius, side * (along - top)
        aside = off > ROUNDING * np.abs(along)
        outward = across / np.where(aside, off, 1.0)[:, None]
        outward = np.where(aside[:, None], outward, perpendicular(axis[None]))
        cap_normal = side[:, None] * axis

        at_rim = (over_wall > 0) & (over_cap > 0)
        at_cap = ~at_rim & (over_cap > over_wall)
        feature = np.where(at_cap, FLAT, LINE)
        line = np.where(at_rim[:, None], rotation.cross(axis, outward), axis)
        foot = self.start + np.where(feature == FLAT, top, along)[:, None] * axis
        rim = self.start + top[:, None] * axis + self.radius * outward
        center = np.where(at_rim[:, None], rim, foot + np.where(at_cap[:, None], across, 0.0))
        between = (outward + cap_normal) / np.sqrt(2)
        return measured(
            points,
            feature,
            center,
            np.where(at_cap[:, None], cap_normal, line),
            np.where(at_rim | at_cap, 0.0, self.radius),
            np.where(at_rim[:, None], between, outward),
        )

    @property
    def bounds(self):
        axis = (self.end - self.start) / np.linalg.norm(self.end - self.start)
        half = self.radius * np.sqrt(np.maximum(1 - axis**2, 0.0))
        ends = np.array([self.start, self.end])
        return np.array([ends.min(axis=0) - half, ends.max(axis=0) + half])


@dataclass(frozen=True, eq=False)
class Box(Obstacle):
    """A box about ``position`` (3,) [m] with full edge lengths ``size`` (3,) [m].

    The unit ``quaternion`` (4,), scalar first, normalised on input, turns it.
    """

    kind = "box"
    position: np.ndarray
    quaternion: np.ndarray
    size: np.ndarray

    def __post_init__(self):
        self._keep(vector, "position")
        self._keep(direction, "quaternion", size=4)
        self._keep(vector, "size")
        for i, edge in enumerate(self.size):
            number(f"{self.place}.size[{i}]", edge, above=0, unit="m")

    def nearest(self, points) -> Nearest:
        turn, half = rotation.matrix(self.quaternion), self.size / 2
        local = (points - self.position) @ turn
        side = np.where(local < 0, -1.0, 1.0)
        excess = np.abs(local) - half
        beyond = excess > 0
        count = beyond.sum(axis=1)

        row, nearest = np.arange(len(points)), excess.argmax(axis=1)
        center = np.clip(local, -half, half)
        center[row, nearest] = (side * half)[row, nearest]
        flat = np.eye(3)[nearest] * side
        line = np.eye(3)[beyond.argmin(axis=1)]
        normal = np.where(beyond, side, 0.0) / np.sqrt(np.maximum(count, 1))[:, None]
        normal = np.where(count[:, None] > 1, normal, flat)
        feature = np.choose(count, (FLAT, FLAT, LINE, POINT))
        local_direction = np.where(count[:, None] < 2, flat, line * (count == 2)[:, None])
        return measured(
            points,
            feature,
            self.position + center @ turn.T,
            local_direction @ turn.T,
            0.0,
            normal @ turn.T,
        )

    @cached_property
    def bounds(self):
        half = np.abs(rotation.matrix(self.quaternion)) @ self.size / 2
        return np.array([self.position - half, self.position + half])
