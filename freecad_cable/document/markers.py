# SPDX-License-Identifier: LGPL-2.1-or-later
"""The shapes that show where a cable is held: lines, in a frame whose z runs along the cable; sizes in mm."""

import Part
from FreeCAD import Vector

SMALLEST = 1e-3
"""Half-width that can be drawn: points closer than 1e-7 are one for OCCT."""


def terminal(size):
    """A square of half-width ``size``, an arrow out of it along z, and a tick along x."""
    s = size
    arrow = _line((0, 0, 0), (0, 0, 2 * s))
    head = _line((s / 4, 0, 1.5 * s), (0, 0, 2 * s), (-s / 4, 0, 1.5 * s))
    return Part.makeCompound([_square(s, 0), arrow, head, _line((0, 0, 0), (s, 0, 0))])


def clamp(size):
    """A block of half-width ``size``, and a tick along x."""
    edges = [_line((x, y, -size / 2), (x, y, size / 2)) for x, y in _corners(size)]
    squares = [_square(size, z) for z in (-size / 2, size / 2)]
    return Part.makeCompound([*squares, *edges, _line((0, 0, 0), (size, 0, 0))])


def sleeve(size):
    """A tube of radius ``size``."""
    edges = [
        _line((x, y, -size), (x, y, size))
        for x, y in ((size, 0), (0, size), (-size, 0), (0, -size))
    ]
    return Part.makeCompound([*(_circle(size, z) for z in (-size, size)), *edges])


def clip(size):
    """A tube of radius ``size``, open at its top."""
    arcs = [_circle(size, z, 120, 420) for z in (-size / 2, size / 2)]
    lips = [Vector(arc.Vertexes[i].Point) for arc in arcs for i in (0, 1)]
    lines = [Part.makePolygon([lips[i], lips[i + 2]]) for i in (0, 1)]
    return Part.makeCompound([*arcs, *lines])


def ring(radius):
    """The circle, and a cross in its middle."""
    s = radius / 4
    cross = [_line((-s, 0, 0), (s, 0, 0)), _line((0, -s, 0), (0, s, 0))]
    return Part.makeCompound([_circle(radius, 0), *cross])


def _line(*points):
    return Part.makePolygon([Vector(*point) for point in points])


def _corners(s):
    return ((s, s), (-s, s), (-s, -s), (s, -s))


def _square(s, z):
    return _line(*((x, y, z) for x, y in (*_corners(s), (s, s))))


def _circle(radius, z, first=0, last=360):
    return Part.makeCircle(radius, Vector(0, 0, z), Vector(0, 0, 1), first, last)
