# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the assemblies of the demo are made of, and how they become STEP files. In mm.

Import this before ``Part``.
"""

import os
from functools import cache

import FreeCAD
from FreeCAD import Placement, Rotation, Vector

# Without curves in the parameters of the faces the file is half as large; Part asks when it is loaded.
SETTINGS = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/Part/General")
BEFORE = SETTINGS.GetInt("WriteSurfaceCurveMode", 1)
SETTINGS.SetInt("WriteSurfaceCurveMode", 0)

import Import  # noqa: E402
import Part  # noqa: E402

SETTINGS.SetInt("WriteSurfaceCurveMode", BEFORE)

REACH = 44
"""From the wall of a unit to the edge where the cable leaves."""

Z = Vector(0, 0, 1)


def box(low, high, rounding=0.0):
    """A box with its upright edges rounded."""
    solid = Part.makeBox(*(Vector(*high) - Vector(*low)), Vector(*low))
    if not rounding:
        return solid
    upright = [e for e in solid.Edges if abs(e.tangentAt(e.FirstParameter).z) > 0.5]
    return solid.makeFillet(rounding, upright)


def pin(x, y, low, high, radius):
    return Part.makeCylinder(radius, high - low, Vector(x, y, low))


def unit(low, high, top, lid=6):
    """A housing with four feet, and its lid with screws."""
    (x0, y0), (x1, y1) = low, high
    housing = box((x0, y0, 0), (x1, y1, top - lid), 4)
    for x, side in ((x0, -1), (x1, 1)):
        for y in (y0 + 14, y1 - 14):
            foot = box((min(x, x + 11 * side), y - 8, 0), (max(x, x + 11 * side), y + 8, 5))
            housing = housing.fuse(foot).cut(pin(x + 6 * side, y, 0, 5, 2.3))
    lid_solid = box((x0, y0, top - lid), (x1, y1, top), 4)
    heads = [pin(x, y, top - 1.5, top, 3) for x in (x0 + 7, x1 - 7) for y in (y0 + 7, y1 - 7)]
    return {"Housing": housing.removeSplitter(), "Lid": lid_solid.cut(Part.makeCompound(heads))}


def turned(outline):
    """The solid of revolution about z of an outline of points (radius, z)."""
    points = [Vector(r, 0, z) for r, z in outline]
    return Part.Face(Part.makePolygon([*points, points[0]])).revolve(Vector(), Z, 360)


def facing(centre, direction):
    return Placement(centre, Rotation(Z, direction))


@cache
def receptacle(r):
    """On the wall at z = −REACH: a square flange with four screw holes, and the shell."""
    half = 1.3 * r + 5.5
    flange = box((-half, -half, -REACH), (half, half, 3 - REACH), 2)
    at = half - 2.6
    holes = [pin(x, y, -REACH, 3 - REACH, 1.3) for x in (-at, at) for y in (-at, at)]
    shell = turned([(0, 3 - REACH), (1.15 * r + 3, 3 - REACH), (1.15 * r + 3, -34), (0, -34)])
    return flange.cut(Part.makeCompound(holes)).fuse(shell)


@cache
def plug(r):
    """Coupling nut, backshell, and the edge where the cable leaves: a circle of radius r at z = 0."""
    nut, body = 1.3 * r + 4, 1.15 * r + 2
    outline = [(0, -34), (nut - 0.8, -34), (nut, -33.2), (nut, -22.8), (nut - 0.8, -22)]
    outline += [(body, -22), (body, -13), (r, -6), (r, 0), (0, 0)]
    return turned(outline)


def connectors(found, letter):
    """Label, solid and placement of what makes the connectors of a unit; ``found``: name to connector."""
    for name, connector in found.items():
        if name[0] == letter:
            place = facing(Vector(*connector.centre), Vector(*connector.direction))
            yield "Receptacle", receptacle(connector.radius), place
            yield "Plug", plug(connector.radius), place


def write(label, step, units):
    """An assembly into a STEP file beside this one.

    ``units``: label, origin, and (label, solid, placement) of all its solids, for each.
    """
    document = FreeCAD.newDocument(label)
    assembly = document.addObject("App::Part", label)
    for unit_label, origin, solids in units:
        part = document.addObject("App::Part", "Unit")
        part.Label = unit_label
        part.Placement.Base = Vector(*origin)
        assembly.addObject(part)
        for name, shape, place in solids:
            assert shape.isValid() and len(shape.Solids) == 1, name
            feature = document.addObject("Part::Feature", "Solid")
            feature.Label = name
            feature.Shape = shape.Solids[0]
            feature.Placement = part.Placement.inverse() * place
            part.addObject(feature)
    document.recompute()
    # The file names itself in its head: without a folder.
    os.chdir(os.path.dirname(os.path.abspath(__file__)))
    Import.export([assembly], step)
