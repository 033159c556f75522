# SPDX-License-Identifier: LGPL-2.1-or-later
"""Round holes through solids, as a cable inside them meets them: by their wall and its two rims.

A triangulation makes a hole of many faces and edges of which each is the nearest for a little of the way around only,
so that what keeps clear of one slides off to the next. The hole itself is smooth.
"""

from dataclasses import dataclass

import numpy as np

from . import rotation
from .nearest import HOLE, Nearest

ON_CIRCLE = 0.05
"""Distance, in radii, up to which what is around a circle is taken for a hole: that of a triangulation in 12 parts."""
NARROWER = 1e-3
"""Distance, in radii, by which what is around the axis may be nearer than the wall: else it is no part of the hole."""
STEP, NEAR, FARTHEST = 0.25, 1.0, 12.0
"""Places along the axis at which the hole and its ends are looked for, in radii of the circle."""
MOSTLY = 2 / 3
"""Share of the wall that is there: a hole may have a slot."""
NARROWEST = 0.4
"""Radius of a hole, in those of the circle, which may be at the rim of its countersink."""


@dataclass(frozen=True, eq=False)
class Bore:
    """The wall |x − center| = ``radius`` across ``axis`` (3,), unit, from ``low`` to ``high`` along it [m]."""

    center: np.ndarray
    axis: np.ndarray
    radius: float
    low: float
    high: float

    @classmethod
    def around(cls, center, axis, radius, distance) -> "Bore | None":
        """The hole that a circle is on the wall or at the rim of, or at the rim of its chamfer, if that is what is
        around it; ``distance`` of a solid from points (m, 3)."""
        along = radius * np.arange(-FARTHEST, FARTHEST + STEP / 2, STEP)
        there = distance(center + along[:, None] * axis)
        narrowest = int(np.argmin(np.where(np.abs(along) <= NEAR * radius, there, np.inf)))
        inner = there[narrowest]
        wider = there > inner * (1 + ON_CIRCLE)
        if not NARROWEST < inner / radius < 1 + ON_CIRCLE or not (
            wider[:narrowest].any() and wider[narrowest:].any()
        ):
            return None
        below = np.flatnonzero(wider[:narrowest])[-1]
        above = narrowest + np.argmax(wider[narrowest:])
        if there[below + 1 : above].min() < inner - NARROWER * radius:
            return None
        # From the axis beyond an end, its rim is what is nearest.
        low, high = (
            along[k] + side * np.sqrt(there[k] ** 2 - inner**2)
            for k, side in ((below, 1), (above, -1))
        )
        found = cls(center, axis, inner, low, high)
        on_wall = distance(found.circle((low + high) / 2)) < ON_CIRCLE * inner
        return found if on_wall.mean() > MOSTLY else None

    def circle(self, along) -> np.ndarray:
        """(24, 3) points of its wall, at a place along its axis."""
        angle = np.linspace(0, 2 * np.pi, 24, endpoint=False)
        across = rotation.matrix(rotation.from_tangent(self.axis))[:, :2]
        around = np.stack([np.cos(angle), np.sin(angle)], axis=1) @ across.T
        return self.center + along * self.axis + self.radius * around

    def way(self, along, keep) -> float:
        """How far from the axis is as far from the hole as one must ``keep``, at a place along the axis."""
        beyond = self._beyond(along)
        if abs(beyond) >= keep:
            return np.inf
        return self.radius - np.sqrt(keep**2 - beyond**2)

    def _beyond(self, along):
        """Way past the nearer rim, negative past the lower one, 0 between them."""
        return along - np.clip(along, self.low, self.high)

    def nearest(self, points, outside: Nearest) -> Nearest:
        """What is nearest to points (m, 3), of which ``outside`` knows the nearest feature of the whole solid: that, or
        the hole where it is the same place."""
        away = points - self.center
        along = away @ self.axis
        foot = self.center + along[:, None] * self.axis
        across = points - foot
        aside = np.linalg.norm(across, axis=1)
        inward = -across / np.maximum(aside, 1e-300)[:, None]
        beyond = self._beyond(along)
        inside = aside <= self.radius
        distance = np.where(inside, np.hypot(self.radius - aside, beyond), self.radius - aside)
        farther = (outside.distance - distance) / self.radius
        same = (farther > -NARROWER) & (farther < 2 * ON_CIRCLE)
        # Inside a thin plate the face is nearer than the hole that the cable is to go back into.
        sunk = (outside.distance < 0) & (beyond == 0) & (aside < 2 * self.radius)
        here = np.where(inside, same, sunk)
        normal = (self.radius - aside)[:, None] * inward + beyond[:, None] * self.axis
        normal /= np.where(distance == 0, 1.0, distance)[:, None]
        normal[distance == 0] = inward[distance == 0]
        outward = np.where(beyond < 0, -1.0, 1.0)[:, None] * self.axis
        where = here[:, None]
        return Nearest(
            np.where(here, distance, outside.distance),
            np.where(where, normal, outside.normal),
            np.where(here, HOLE, outside.feature),
            np.where(where, foot, outside.center),
            np.where(where, outward, outside.direction),
            np.where(here, self.radius, outside.radius),
        )
