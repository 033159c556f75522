# SPDX-License-Identifier: LGPL-2.1-or-later
"""The centreline of a cable as one B-spline, usable as the spine of a native ``Part::Sweep``."""

import Part
from FreeCAD import Vector

from .frames import frames
from .spline import DEGREE, Quintic, joined

ACCURACY = 1e-6
"""Largest distance of the curve from a node, relative to the length: a hundredth of the default accuracy
of the solve."""


def centreline(nodes) -> Part.BSplineCurve:
    """The curve [mm] with the positions, tangents and curvatures of ``nodes`` (``Nodes`` or ``Solution``).

    C2, but C1 where curvature jumps. Its parameter is its length from the start [mm]. Errors:
    ``DocumentError``, see ``frames``.
    """
    runs = frames(nodes)
    tolerance = ACCURACY * runs[-1].parameter[-1]
    pieces = []
    for run in runs:
        tangent, bend, _ = run.axis(2)
        pieces.append(Quintic(run.parameter, run.position, tangent, bend).thinned(tolerance))
    knots, multiplicities, poles = joined(pieces, continuity=1)
    curve = Part.BSplineCurve()
    curve.buildFromPolesMultsKnots(
        [Vector(*pole) for pole in poles.tolist()], multiplicities, knots, False, DEGREE
    )
    return curve


def centreline_wire(nodes) -> Part.Wire:
    """The same as a wire of one edge."""
    return Part.Wire([centreline(nodes).toShape()])
