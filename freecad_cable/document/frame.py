# SPDX-License-Identifier: LGPL-2.1-or-later
"""The frame that an edge, a face or an object gives to the end of a cable.

z points out of the part, the way a cable leaves it; x follows from the geometry and turns with the part,
so that the frame moves as a rigid body when the part does. All in the coordinates of the shapes, in mm.
"""

import math
from dataclasses import dataclass

import Part
from FreeCAD import Placement, Rotation, Vector

from ..errors import DocumentError

DIRECTION_TOLERANCE = 1e-6
"""[rad] and, of lengths, relative: below this a plane is square to an axis, and neither end is farther out."""

POINT_SIZE = 5.0
"""[mm] Half the size of the mark of a terminal whose reference has no size of its own."""

SMALLEST = 1e-7
"""[mm] Below this OCCT takes two points for one."""


@dataclass(frozen=True)
class Frame:
    """Where a cable leaves."""

    placement: Placement
    size: float
    """radius of the circle, or half the width of the face [mm]"""
    is_round: bool = False
    """whether ``size`` is the radius of a circle or a cylinder"""


def frame_of(found, axes=None, reverse=False) -> Frame:
    """The frame at ``found`` (``reference.Found``); a vertex takes its axes from ``axes``, another one.

    ``reverse`` turns the cable into the part; on a cylinder it leaves by the other end. Errors:
    ``DocumentError`` for geometry that gives no axis.
    """
    shape = found.element
    if axes is not None and (shape is None or shape.ShapeType != "Vertex"):
        raise DocumentError(
            f"{found.name} has axes of its own; only a vertex takes a second entry."
        )
    if shape is None:
        return Frame(_turned(found.placement, reverse), POINT_SIZE)
    if shape.ShapeType == "Vertex":
        rotation = (axes or found).placement.Rotation
        return Frame(_turned(Placement(shape.Point, rotation), reverse), POINT_SIZE)
    geometry = _geometry(shape)
    if isinstance(geometry, Part.Circle):
        return _on_circle(shape, found.whole, reverse)
    if isinstance(geometry, Part.Plane):
        return _on_plane(shape, reverse)
    if isinstance(geometry, Part.Cylinder):
        return _on_cylinder(shape, found.whole, reverse)
    raise DocumentError(
        f"{found.name} gives no direction for a cable; choose a circular edge, a flat or cylindrical face, "
        "a vertex, or an object with a placement such as a local coordinate system."
    )


def passage_of(found, axes=None) -> Frame:
    """The same for a cable that passes: on a cylinder halfway through it."""
    shape = found.element
    if axes is None and shape is not None and isinstance(_geometry(shape), Part.Cylinder):
        _, _, low, high = shape.ParameterRange
        surface = shape.Surface
        middle = surface.Center + surface.Axis * ((low + high) / 2)
        x = surface.value(0, 0) - surface.Center
        return _frame(middle, x, surface.Axis, surface.Radius, is_round=True)
    return frame_of(found, axes)


def _geometry(shape):
    """Curve or surface; None for an edge that is but a point."""
    try:
        return shape.Curve if shape.ShapeType == "Edge" else shape.Surface
    except (AttributeError, TypeError):
        return None


def _turned(placement, reverse):
    """Half a turn about x, if at all."""
    return placement * Placement(Vector(), Rotation(Vector(1, 0, 0), 180)) if reverse else placement


def _frame(origin, x, z, size, *, is_round=False):
    if not size > SMALLEST:
        raise DocumentError("leads to an edge or a face of no size; choose another.")
    return Frame(Placement(origin, Rotation(x, z.cross(x), z, "ZXY")), size, is_round)


def _on_circle(edge, whole, reverse):
    circle = edge.Curve
    z = _out_of_circle(edge, whole)
    x = circle.value(0) - circle.Center
    return _frame(circle.Center, x, -z if reverse else z, circle.Radius, is_round=True)


def _out_of_circle(edge, whole):
    """The axis, pointing away from the material: out of the flat face that the circle bounds, else away from
    the centre of the part, else as the circle runs."""
    centre, axis = edge.Curve.Center, edge.Curve.Axis
    for face in whole.ancestorsOfType(edge, Part.Face):
        if isinstance(face.Surface, Part.Plane) and whole.Solids:
            normal = face.normalAt(0, 0)
            if normal.cross(axis).Length < DIRECTION_TOLERANCE:
                return normal
    outwards = (centre - _middle(whole)).dot(axis)
    return -axis if outwards < -DIRECTION_TOLERANCE * edge.Curve.Radius else axis


def _on_plane(face, reverse):
    surface = face.Surface
    z = face.normalAt(0, 0)
    x = surface.value(1, 0) - surface.value(0, 0)
    return _frame(face.CenterOfMass, x, -z if reverse else z, math.sqrt(face.Area / math.pi))


def _on_cylinder(face, whole, reverse):
    """At the end of the cylinder that is farther from the middle of the part."""
    surface = face.Surface
    _, _, low, high = face.ParameterRange
    axis, middle = surface.Axis, (_middle(whole) - surface.Center).dot(surface.Axis)
    upwards = high - middle >= middle - low - DIRECTION_TOLERANCE * (high - low)
    if upwards != reverse:
        z, origin = axis, surface.Center + axis * high
    else:
        z, origin = -axis, surface.Center + axis * low
    return _frame(origin, surface.value(0, 0) - surface.Center, z, surface.Radius, is_round=True)


def _middle(whole):
    """Centre of mass of the solids, or of what there is."""
    parts = whole.Solids or whole.Faces or whole.Edges
    mass = sum(part.Mass for part in parts)
    return sum((part.CenterOfMass * part.Mass for part in parts), Vector()) * (1 / mass)
