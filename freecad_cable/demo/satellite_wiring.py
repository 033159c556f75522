# SPDX-License-Identifier: LGPL-2.1-or-later
"""The wiring list of the satellite: connectors, holes, P-clips, and which cable runs where and over what.

Example values. In mm, in the coordinates of the assembly in ``resources/demo/satellite.step``; its generator beside
it builds connectors, holes and P-clips from this list.
"""

from dataclasses import dataclass

from .harness import RADII, Connector
from .harness import TYPES as COMMON

BUNDLE = "Multi-core cable 7 mm"
"""of Table 1 of the paper, built in"""

TYPES = COMMON | {BUNDLE: {"min_bend_radius": "42 mm"}}
"""Properties of the cable types, as ``make.cable_type`` takes them; 6 diameters, NASA-STD-8739.4."""

THICKNESS = 10.0
"""[mm] of the plates"""

WEB, DECK = (1, 0, 0), (0, 0, 1)
"""Normals of the plates with holes: the web stands upright between the bays, the deck lies in one of them."""

CLIP_WIDTH = 10.0
"""[mm] along the cable"""

PLAY = 0.2
"""[mm] between the cable and the bore of a P-clip"""

RIM = 7.0
"""[mm] that a cable keeps from the edge of a hole"""


CLEARANCE = 1.0
"""[mm] that a cable keeps from plates and units, unless it lies on one"""


@dataclass(frozen=True)
class Hole:
    """Through a plate, known by the circular edge on the side that ``normal`` points to."""

    centre: tuple
    """of the edge [mm]"""
    normal: tuple
    radius: float
    """[mm]"""


@dataclass(frozen=True)
class Clip:
    """A P-clip, known by the edges of its bore."""

    centre: tuple
    """of the bore [mm]"""
    direction: tuple
    """unit vector along the bore"""
    outwards: tuple
    """unit vector out of the surface it is screwed to"""
    height: float
    """[mm] of the middle of the bore above the surface"""
    diameter: float
    """[mm] of the cable"""
    position: float | None = None
    """[mm] of cable from its start to the clip; None: it is tightened last, so the cable slides in it"""

    @property
    def bore(self):
        """Radius [mm]."""
        return self.diameter / 2 + PLAY


@dataclass(frozen=True)
class Run:
    """A cable from one connector to another."""

    start: str
    end: str
    type: str
    over: tuple = ()
    """holes and clips in order"""
    lies_on: tuple = ()
    """solids of the structure that it may touch; from all others it keeps clear"""


def _plug(kind, centre, direction):
    return Connector(centre, direction, RADII["SpaceWire" if kind == BUNDLE else kind])


UP, RIGHT, LEFT, FRONT = (0, 0, 1), (1, 0, 0), (-1, 0, 0), (0, -1, 0)

CONNECTORS = {
    # power unit
    "A1": _plug("Coax", (-106, 112, 55), RIGHT),
    "A2": _plug("Power", (-106, 150, 75), RIGHT),
    "A3": _plug("Coax", (-190, 115, 154), UP),
    "A4": _plug(BUNDLE, (-230, 140, 154), UP),
    "A5": _plug("Coax", (-106, 78, 90), RIGHT),
    # computer
    "B1": _plug("Coax", (-86, -90, 40), RIGHT),
    "B2": _plug(BUNDLE, (-175, -148, 134), UP),
    "B3": _plug("Coax", (-170, -110, 134), UP),
    "B4": _plug("SpaceWire", (-215, -90, 134), UP),
    # transponder
    "C1": _plug("Coax", (240, 85, 114), UP),
    "C2": _plug("SpaceWire", (156, 60, 45), LEFT),
    "C3": _plug("Coax", (250, -4, 40), FRONT),
    # gyroscope
    "D1": _plug(BUNDLE, (315, -128, 16), LEFT),
    # receiver
    "E1": _plug("Coax", (156, 145, 206), LEFT),
    "E2": _plug("SpaceWire", (156, 90, 206), LEFT),
    "E3": _plug("SpaceWire", (240, 26, 205), FRONT),
    "E4": _plug(BUNDLE, (270, 130, 269), UP),
    # filter
    "G1": _plug("Power", (216, 170, 100), LEFT),
}

HOLES = {
    "H1": Hole((5, 105, 85), WEB, 14),
    "H2": Hole((5, 160, 90), WEB, 20),
    "H3": Hole((5, 125, 225), WEB, 16),
    "H4": Hole((5, 170, 270), WEB, 18),
    "H5": Hole((5, -60, 35), WEB, 16),
    "H6": Hole((5, -135, 25), WEB, 16),
    "H7": Hole((5, -60, 215), WEB, 18),
    "H8": Hole((90, 70, 180), DECK, 24),
}

CLIPS = {
    "P1": Clip((80, 193.5, 105), RIGHT, FRONT, 6.5, 8),
    "P2": Clip((75, 135, 185), RIGHT, UP, 5, 4.3),
    "P3": Clip((120, 193.5, 285), RIGHT, FRONT, 6.5, 7),
    "P4": Clip((-10, 15, 140), FRONT, LEFT, 5, 4.3, position=150),
    "P5": Clip((110, -45, 5), RIGHT, UP, 5, 4.3),
    "P6": Clip((230, -130, 6), RIGHT, UP, 6, 7),
}

RUNS = {
    "W1": Run("A1", "C1", "Coax", ("H1",)),
    "W2": Run("A2", "G1", "Power", ("H2", "P1")),
    "W3": Run("C2", "E2", "SpaceWire", ("H8",)),
    "W4": Run("A3", "E1", "Coax", ("H3", "P2")),
    "W5": Run("B2", "D1", BUNDLE, ("H6", "P6"), lies_on=("Floor",)),
    "W6": Run("B1", "C3", "Coax", ("H5", "P5")),
    "W7": Run("A5", "B3", "Coax", ("P4",)),
    "W8": Run("B4", "E3", "SpaceWire", ("H7",)),
    "W9": Run("E4", "A4", BUNDLE, ("P3", "H4")),
}
