# SPDX-License-Identifier: LGPL-2.1-or-later
"""Make ``equipment.step``: the units on an equipment panel of a small satellite, with their connectors.

    PYTHONPATH=. freecadcmd resources/demo/make_equipment.py

Runs in the folder of the checkout. One product per unit, one solid per part, in mm.
"""

import math
import os
import sys
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

from freecad_cable.demo.harness import CONNECTORS  # noqa: E402

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


def plate():
    """The panel, with a row of holes along its edge."""
    solid = box((-250, -200, -12), (250, 200, 0), 15)
    holes = [pin(x, y, -12, 0, 2.6) for x in range(-235, 236, 94) for y in (-187, 187)]
    holes += [pin(x, y, -12, 0, 2.6) for x in (-235, 235) for y in (-94, 0, 94)]
    return solid.cut(Part.makeCompound(holes))


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


def wheel():
    """A round housing on a foot, with a flat where its connector sits at 45 degrees."""
    x, y, radius, height = -165, -105, 66, 60
    foot = pin(x, y, 0, 8, radius + 12)
    bolts = [
        pin(x + 72 * math.cos(a), y + 72 * math.sin(a), 0, 8, 2.3)
        for a in (math.pi / 8 + k * math.pi / 4 for k in range(8))
    ]
    drum = pin(x, y, 8, height, radius)
    rim = [e for e in drum.Edges if e.Closed and e.CenterOfMass.z > height - 1]
    drum = drum.makeChamfer(5, rim)
    out = Vector(1, 1, 0).normalize()
    beyond = Part.makeBox(200, 200, 200, Vector(-100, -100, 0))
    beyond.Placement = facing(Vector(*CONNECTORS["D2"].centre) - out * REACH, out)
    return {"Foot": foot.cut(Part.makeCompound(bolts)), "Drum": drum.cut(beyond)}


def tracker():
    """A camera: a housing with a sloping connector face, and a baffle that looks up and away."""
    x0, x1, y0, y1, top = 130, 210, -155, -85, 50
    slope = [Vector(x0, 0, 20), Vector(x0 + 30, 0, top), Vector(x1, 0, top), Vector(x1, 0, 0)]
    profile = Part.makePolygon([Vector(x0, 0, 0), *slope, Vector(x0, 0, 0)])
    profile.translate(Vector(0, y0, 0))
    housing = Part.Face(profile).extrude(Vector(0, y1 - y0, 0))
    outline = [(0, -25), (24, -25), (24, 8), (38, 62), (35, 62), (21, 8), (0, 8)]
    baffle = turned(outline)
    baffle.Placement = facing(Vector(188, -120, top + 6), Vector(0.35, -0.2, 1))
    return {"Housing": housing, "Baffle": baffle.cut(housing)}


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


def connectors(letter):
    """Label, solid and placement of what makes the connectors of a unit."""
    for name, connector in CONNECTORS.items():
        if name[0] == letter:
            place = facing(Vector(*connector.centre), Vector(*connector.direction))
            yield "Receptacle", receptacle(connector.radius), place
            yield "Plug", plug(connector.radius), place


UNITS = {
    "Panel": ("", (0, 0, 0), {"Plate": plate()}),
    "Power unit": ("A", (-165, 102.5, 0), unit((-235, 40), (-95, 165), 100)),
    "Computer": ("B", (30, 125, 0), unit((-45, 75), (105, 175), 120)),
    "Transponder": ("C", (197.5, 107.5, 0), unit((155, 50), (240, 165), 70)),
    "Reaction wheel": ("D", (-165, -105, 0), wheel()),
    "Gyroscope": ("E", (15, -82.5, 0), unit((-25, -120), (55, -45), 55)),
    "Star tracker": ("F", (170, -120, 0), tracker()),
}
"""Label: letter of its connectors, origin, solids."""


def main():
    document = FreeCAD.newDocument("Equipment")
    assembly = document.addObject("App::Part", "Equipment")
    for label, (letter, origin, solids) in UNITS.items():
        part = document.addObject("App::Part", "Unit")
        part.Label = label
        part.Placement.Base = Vector(*origin)
        assembly.addObject(part)
        own = ((name, shape, Placement()) for name, shape in solids.items())
        for name, shape, place in (*own, *connectors(letter)):
            assert shape.isValid() and len(shape.Solids) == 1, name
            feature = document.addObject("Part::Feature", "Solid")
            feature.Label = name
            feature.Shape = shape.Solids[0]
            feature.Placement = part.Placement.inverse() * place
            part.addObject(feature)
    document.recompute()
    # The file names itself in its head: without a folder.
    os.chdir("resources/demo")
    Import.export([assembly], "equipment.step")


main()
sys.exit(0)
