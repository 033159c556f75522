# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed outlines in the xy-plane [mm]."""

import math

import Part
from FreeCAD import Vector


def polygon(*points):
    return Part.makePolygon([Vector(*point) for point in (*points, points[0])])


def rectangle(width, height):
    x, y = width / 2, height / 2
    return polygon((-x, -y), (x, -y), (x, y), (-x, y))


def star(rays):
    angles = [k * math.pi / rays for k in range(2 * rays)]
    return polygon(
        *(
            ((4 - 2 * (k % 2)) * math.cos(a), (4 - 2 * (k % 2)) * math.sin(a))
            for k, a in enumerate(angles)
        )
    )


def circle(radius, x=0.0):
    return Part.Wire([Part.Circle(Vector(x, 0), Vector(0, 0, 1), radius).toShape()])


def disc(radius, hole=None):
    wires = [circle(radius)] if hole is None else [circle(radius), circle(hole)]
    return Part.makeFace(Part.makeCompound(wires), "Part::FaceMakerBullseye")


def slot(length, radius):
    """A straight slot with round ends, ``length`` between their centres."""
    x, y = length / 2, radius
    return Part.Wire(
        [
            Part.makeLine(Vector(-x, -y), Vector(x, -y)),
            Part.Arc(Vector(x, -y), Vector(x + y, 0), Vector(x, y)).toShape(),
            Part.makeLine(Vector(x, y), Vector(-x, y)),
            Part.Arc(Vector(-x, y), Vector(-x - y, 0), Vector(-x, -y)).toShape(),
        ]
    )


def rounded(width, height, radius):
    """A rectangle with round corners."""
    x, y = width / 2 - radius, height / 2 - radius
    edges, last = [], None
    for k, (cx, cy) in enumerate(((x, y), (-x, y), (-x, -y), (x, -y))):
        start, middle, end = (
            Vector(cx + radius * math.cos(a), cy + radius * math.sin(a))
            for a in ((k + share) * math.pi / 2 for share in (0, 0.5, 1))
        )
        if last is not None:
            edges.append(Part.makeLine(last, start))
        edges.append(Part.Arc(start, middle, end).toShape())
        last = end
    edges.append(Part.makeLine(last, edges[0].valueAt(edges[0].FirstParameter)))
    return Part.Wire(edges)
