# SPDX-License-Identifier: LGPL-2.1-or-later
"""The nearest feature of a surface: a flat face, an edge or axis, a corner or centre, a round hole."""

from dataclasses import dataclass

import numpy as np

from .rotation import cross

FLAT, LINE, POINT, HOLE = 0, 1, 2, 3

ROUNDING = 64 * np.finfo(float).eps
"""Relative to coordinates: distances below have no direction of their own."""


@dataclass(frozen=True, eq=False)
class Nearest:
    """Of m points x: the distance to a solid and the feature that is nearest.

    The distance to a feature is n·(x − c) if flat, |(x − c) − (n·(x − c)) n| − ρ about a line, and
    |x − c| − ρ about a point; within a hole it is that to its wall or rim (see ``geometry.bore``). Of the solid it is
    the distance where that feature is the nearest, and its gradient is the normal.
    """

    distance: np.ndarray
    """(m,) [m] signed, negative inside"""
    normal: np.ndarray
    """(m, 3) unit, the direction in which the distance grows"""
    feature: np.ndarray
    """(m,) FLAT, LINE, POINT or HOLE"""
    center: np.ndarray
    """(m, 3) [m] c: the point of the face, of the line or axis, or the point; nearest to x"""
    direction: np.ndarray
    """(m, 3) n: outward normal of the face, unit direction of the line, zeros for a point; of the axis
    of a hole, the way out of it"""
    radius: np.ndarray
    """(m,) [m] ρ: 0 for sharp edges and corners, and for faces; of a hole its own"""

    def taken(self, which) -> "Nearest":
        """That of some of the points."""
        return Nearest(*(each[which] for each in vars(self).values()))

    def joined(self, other: "Nearest") -> "Nearest":
        """With that of more points."""
        pairs = zip(vars(self).values(), vars(other).values(), strict=True)
        return Nearest(*(np.concatenate(pair) for pair in pairs))


def measured(points, feature, center, direction, radius, otherwise) -> Nearest:
    """Distances and normals of points (m, 3) from their nearest features.

    ``feature``, ``center``, ``direction`` and ``radius`` as in ``Nearest`` (or what broadcasts to it).
    ``otherwise`` (m, 3), unit, stands in where a point is on the line or at the point itself. If that is
    sharp (ρ = 0), the distance has a kink there, and the feature is the flat one with that normal.
    """
    radius, center = np.full(len(points), radius, float), np.zeros_like(points) + center
    away = points - center
    along = (away * direction).sum(axis=1)
    across = away - along[:, None] * direction
    length = np.sqrt((across * across).sum(axis=1))
    scale = np.maximum(np.abs(points).max(axis=1), np.abs(center).max(axis=1))
    on_it = (feature != FLAT) & (length <= ROUNDING * scale)
    on_sharp = on_it & (radius == 0)

    feature = np.where(on_sharp, FLAT, feature)
    direction = np.where(on_sharp[:, None], otherwise, direction)
    flat = feature == FLAT
    normal = across / np.maximum(length, 1e-300)[:, None]
    normal = np.where(on_it[:, None], otherwise, np.where(flat[:, None], direction, normal))
    distance = np.where(flat, along, length - radius)
    return Nearest(distance, normal, feature, center, direction, radius)


def perpendicular(directions):
    """For each unit vector (m, 3), a unit vector (m, 3) at right angles."""
    axes = np.eye(3)[np.argmin(np.abs(directions), axis=1)]
    across = cross(directions, axes)
    return across / np.linalg.norm(across, axis=1, keepdims=True)
