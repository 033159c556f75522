# SPDX-License-Identifier: LGPL-2.1-or-later
"""Make ``equipment.step``: the units on an equipment panel of a small satellite, with their connectors.

    PYTHONPATH=.:resources/demo freecadcmd resources/demo/make_equipment.py

Runs in the folder of the checkout. One product per unit, one solid per part, in mm.
"""

import math
import sys

from solids import REACH, box, connectors, facing, pin, turned, unit, write

# isort: split
import Part
from FreeCAD import Placement, Vector

from freecad_cable.demo.harness import CONNECTORS


def plate():
    """The panel, with a row of holes along its edge."""
    solid = box((-250, -200, -12), (250, 200, 0), 15)
    holes = [pin(x, y, -12, 0, 2.6) for x in range(-235, 236, 94) for y in (-187, 187)]
    holes += [pin(x, y, -12, 0, 2.6) for x in (-235, 235) for y in (-94, 0, 94)]
    return solid.cut(Part.makeCompound(holes))


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
    units = []
    for label, (letter, origin, solids) in UNITS.items():
        own = [(name, shape, Placement()) for name, shape in solids.items()]
        units.append((label, origin, [*own, *connectors(CONNECTORS, letter)]))
    write("Equipment", "equipment.step", units)


main()
sys.exit(0)
