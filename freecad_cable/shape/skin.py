# SPDX-License-Identifier: LGPL-2.1-or-later
"""The surface of a cable as points to be drawn: quick, and with what is to be seen on it."""

from dataclasses import dataclass

import numpy as np

from .frames import frames
from .profile import circle, profile
from .units import from_si

BETWEEN = 4
"""Rows of points from node to node."""

AROUND = 16
"""Points of a round section."""

ABOVE = 1.02
"""Size of the skin over that of the solid, so that the one is seen and not the other."""


@dataclass(frozen=True, eq=False)
class Skin:
    """A grid of points: rows across the cable, columns along it."""

    points: np.ndarray
    """(m, k, 3) [mm]; the first of a row is repeated at its end"""
    bend_radius: np.ndarray
    """(m,) of the centreline, in each row [mm]; infinite where straight"""


def skin(nodes, radius, shape=None) -> Skin:
    """Of a round cable of ``radius`` [m] along ``nodes``, or of one with the section drawn by ``shape``. Errors:
    ``DocumentError``, as those of the sweep."""
    section = profile(shape) if shape else circle(from_si("length", radius))
    polygon = section.polygon if shape else section.polygon[:: 64 // AROUND]
    polygon = ABOVE * np.concatenate([polygon, polygon[:1]])
    rows, curvature = [], []
    for run in frames(nodes):
        place = np.arange(len(run.parameter))
        dense = np.arange(BETWEEN * (len(place) - 1) + 1) / BETWEEN
        d1, d2, bend = (
            _between(dense, place, values)
            for values in (run.axes[:, :, 0], run.axes[:, :, 1], run.axis(2)[1])
        )
        r = _hermite(dense, run.parameter, run.position, run.tangent)
        x, y = polygon.T[:, None, :, None]
        rows.append(r[:, None] + x * d1[:, None] + y * d2[:, None])
        curvature.append(np.linalg.norm(bend, axis=1))
    with np.errstate(divide="ignore"):
        return Skin(np.concatenate(rows), 1 / np.concatenate(curvature))


def _between(dense, place, values):
    return np.stack([np.interp(dense, place, column) for column in values.T], axis=1)


def _hermite(dense, parameter, position, tangent):
    """Cubics through the positions with the tangents."""
    i = np.minimum(dense.astype(int), len(parameter) - 2)
    t = (dense - i)[:, None]
    h = (parameter[i + 1] - parameter[i])[:, None]
    return (
        (1 + 2 * t) * (1 - t) ** 2 * position[i]
        + t * (1 - t) ** 2 * h * tangent[i]
        + t**2 * (3 - 2 * t) * position[i + 1]
        + t**2 * (t - 1) * h * tangent[i + 1]
    )
