# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cable beside its spline route: the numbers of the tables and the lines of the pictures.

Read from the objects of the document, so that what is reported is what the file holds.
"""

import math
from dataclasses import dataclass

import numpy as np

SAMPLES = 240
"""Points on a line of a picture."""


@dataclass(frozen=True, eq=False)
class Line:
    """A sampled curve."""

    points: np.ndarray
    """(n, 3) [mm]"""
    arc_length: np.ndarray
    """(n,) from the start, over the chords [mm]"""
    curvature: np.ndarray
    """(n,) [1/mm]"""

    @classmethod
    def of(cls, shape):
        """Of a shape with one edge, whose parameter runs evenly."""
        (edge,) = shape.Edges
        places = np.linspace(edge.FirstParameter, edge.LastParameter, SAMPLES).tolist()
        points = np.array([edge.valueAt(place) for place in places], float)
        chords = np.linalg.norm(np.diff(points, axis=0), axis=1)
        curvature = np.array([edge.curvatureAt(place) for place in places])
        return cls(points, np.concatenate(([0.0], np.cumsum(chords))), curvature)


@dataclass(frozen=True, kw_only=True, eq=False)
class Comparison:
    """Lengths and radii in mm, of the centreline."""

    label: str
    type: str
    diameter: float
    allowed: float
    """smallest bend radius allowed"""
    length: float
    spline_length: float
    difference: float
    """how much longer the spline is"""
    relative_difference: float
    """[%] of the length of the spline"""
    radius: float
    """smallest bend radius"""
    margin: float
    """``radius`` less ``allowed``"""
    spline_radius: float
    clearance: float | None
    """between the surface of the cable and the obstacles in reach; None if there are none"""
    solve_time: float
    """[s]"""
    cable: Line
    spline: Line


def compare(cable, route):
    """The ``Comparison`` of two objects of a document."""
    radius, clearance = cable.SmallestBendRadius.Value, cable.SmallestClearance.Value
    return Comparison(
        label=cable.Label,
        type=cable.CableType.Label,
        diameter=cable.CableType.OuterDiameter.Value,
        allowed=radius - cable.BendRadiusMargin.Value,
        length=cable.SolvedLength.Value,
        spline_length=route.Length.Value,
        difference=route.LengthDifference.Value,
        relative_difference=100 * route.LengthDifference.Value / route.Length.Value,
        radius=radius,
        margin=cable.BendRadiusMargin.Value,
        spline_radius=route.SmallestBendRadius.Value,
        clearance=clearance if math.isfinite(clearance) else None,
        solve_time=cable.SolveTime,
        cable=Line.of(cable.Centreline.Shape),
        spline=Line.of(route.Shape),
    )
