# SPDX-License-Identifier: LGPL-2.1-or-later
"""Make ``satellite.step``: two bays of a small satellite, plates with holes, units, P-clips.

    PYTHONPATH=.:resources/demo freecadcmd resources/demo/make_satellite.py

Runs in the folder of the checkout. One product per unit, one solid per part, in mm.
"""

import sys

from solids import box, connectors, pin, unit, write

# isort: split
import Part
from FreeCAD import Placement, Rotation, Vector

from freecad_cable.demo.satellite_wiring import (
    CLIP_WIDTH,
    CLIPS,
    CONNECTORS,
    DECK,
    HOLES,
    THICKNESS,
    WEB,
)

BAND = 1.5
"""Thickness of a P-clip."""


def with_holes(plate, normal):
    """A plate with the holes of the wiring list that have this normal."""
    drills = []
    for hole in HOLES.values():
        if hole.normal == normal:
            along = Vector(*hole.normal)
            begin = Vector(*hole.centre) - along * THICKNESS
            drills.append(Part.makeCylinder(hole.radius, THICKNESS, begin, along))
    return plate.cut(Part.makeCompound(drills))


def structure():
    """The plates: floor, back, the web between the bays, the deck in the right one."""
    return {
        "Floor": box((-300, -200, -THICKNESS), (410, 200, 0)),
        "Back": box((-300, 200, -THICKNESS), (410, 200 + THICKNESS, 330)),
        "Web": with_holes(box((-5, -200, 0), (5, 200, 330)), WEB),
        "Deck": with_holes(box((5, 20, 180 - THICKNESS), (410, 200, 180)), DECK),
    }


def moved(solids, placement):
    found = {}
    for name, shape in solids.items():
        found[name] = shape.copy()
        found[name].Placement = placement * shape.Placement
    return found


def clip(given):
    """A loop and its foot with a screw, in the coordinates of the assembly."""
    outer, half = given.bore + BAND, CLIP_WIDTH / 2
    foot = box((0, -given.height, -half), (outer + 12, BAND - given.height, half))
    riser = box((outer - BAND, -given.height, -half), (outer, 0, half))
    loop = pin(0, 0, -half, half, outer).fuse([riser, foot]).cut(pin(0, 0, -half, half, given.bore))
    below = box((-100, -100, -half), (100, -given.height, half))
    head = Part.makeCylinder(3, 2, Vector(outer + 7, BAND - given.height, 0), Vector(0, 1, 0))
    solid = loop.cut(below).fuse(head).removeSplitter()
    z, y = Vector(*given.direction), Vector(*given.outwards)
    solid.Placement = Placement(Vector(*given.centre), Rotation(y.cross(z), y, z, "ZYX"))
    return solid


def at(x, y, z):
    return Placement(Vector(x, y, z), Rotation())


UNITS = {
    "Structure": ("", (0, 0, 0), structure()),
    "Power unit": ("A", (-210, 115, 0), unit((-270, 60), (-150, 170), 110)),
    "Computer": ("B", (-195, -110, 0), unit((-260, -170), (-130, -50), 90)),
    "Transponder": ("C", (250, 80, 0), unit((200, 40), (300, 120), 70)),
    "Gyroscope": ("D", (379, -128, 0), unit((359, -165), (399, -91), 50)),
    "Receiver": ("E", (255, 120, 180), moved(unit((200, 70), (310, 170), 45), at(0, 0, 180))),
    "Filter": (
        "G",
        (300, 200, 95),
        moved(
            unit((-40, -35), (40, 35), 60),
            Placement(Vector(300, 200, 95), Rotation(Vector(1, 0, 0), 90)),
        ),
    ),
}
"""Label: letter of its connectors, origin, solids."""


def main():
    units = []
    for label, (letter, origin, solids) in UNITS.items():
        own = [(name, shape, shape.Placement) for name, shape in solids.items()]
        units.append((label, origin, [*own, *connectors(CONNECTORS, letter)]))
    clips = [(name, clip(given), clip(given).Placement) for name, given in CLIPS.items()]
    write("Satellite", "satellite.step", [*units, ("Clips", (0, 0, 0), clips)])


main()
sys.exit(0)
