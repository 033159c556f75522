# SPDX-License-Identifier: LGPL-2.1-or-later
"""Circular edges of an imported assembly, found by where they are.

The names of edges differ between importers and versions; centre and radius do not.
"""

import Part
from FreeCAD import Vector

from ..errors import DocumentError

NEAR = 1e-3
"""[mm] STEP files are exact to 10⁻⁷ mm or so; different connectors are centimetres apart."""


class Circles:
    """All full circles under ``root``, in the coordinates of its container."""

    def __init__(self, root):
        self.root = root
        self._found = list(_circles(root, ""))

    def reference(self, centre, radius):
        """The pair (root, path) that a terminal refers to. Errors: ``DocumentError`` unless one edge fits.

        centre (3,) and radius in mm.
        """
        place = Vector(*centre)
        fitting = [
            path
            for path, circle in self._found
            if abs(circle.Radius - radius) < NEAR and circle.Center.distanceToPoint(place) < NEAR
        ]
        if len(fitting) != 1:
            raise DocumentError(
                f"{self.root.Label} has {len(fitting)} circular edges of radius {radius:g} mm at "
                f"({place.x:g}, {place.y:g}, {place.z:g}) mm; one was expected."
            )
        return self.root, fitting[0]


def _circles(root, path):
    """Path and curve of every full circle in what ``path`` leads to."""
    inside = root.getSubObject(path, retType=1).getSubObjects() if path else root.getSubObjects()
    for name in inside:
        yield from _circles(root, path + name)
    if inside:
        return
    shape = Part.getShape(root, path)
    for k, edge in enumerate(shape.Edges, 1):
        if edge.Closed and not edge.Degenerated and isinstance(edge.Curve, Part.Circle):
            yield f"{path}Edge{k}", edge.Curve
