# SPDX-License-Identifier: LGPL-2.1-or-later
"""The wiring list of the demo: connectors, cable types, and which cable runs from where to where.

Example values, of the size that satellite units have. In mm, in the coordinates of the assembly in
``resources/demo/equipment.step``; its generator beside it builds the connectors from this list.
"""

from dataclasses import dataclass

DIAGONAL = 0.5**0.5


@dataclass(frozen=True)
class Connector:
    """A plug in its receptacle, known by the circular edge where the cable leaves."""

    centre: tuple
    """of the edge [mm]"""
    direction: tuple
    """unit vector in which the cable leaves"""
    radius: float
    """of the edge [mm]"""


@dataclass(frozen=True)
class Run:
    """A cable from one connector to another."""

    start: str
    end: str
    type: str
    length: float
    """[mm]"""


TYPES = {
    "Power": {
        "outer_diameter": "8 mm",
        "mass_per_length": "130 g/m",
        "bending_stiffness": "0.050 N*m^2",
        "torsional_stiffness": "0.035 N*m^2",
        "min_bend_radius": "48 mm",
        "provenance": "Example values; bend radius: 6 diameters, NASA-STD-8739.4",
    },
    "SpaceWire": {
        "outer_diameter": "7.5 mm",
        "mass_per_length": "85 g/m",
        "bending_stiffness": "0.020 N*m^2",
        "torsional_stiffness": "0.015 N*m^2",
        "min_bend_radius": "45 mm",
        "provenance": "Datasheet of Gore SpaceWire, ESCC 3902/003, AWG 28; stiffness: example values",
    },
    "Coax": {
        "outer_diameter": "4.3 mm",
        "mass_per_length": "29 g/m",
        "bending_stiffness": "0.004 N*m^2",
        "torsional_stiffness": "0.003 N*m^2",
        "min_bend_radius": "25 mm",
        "provenance": "Datasheet of Belden H123; stiffness: example values",
    },
}
"""Properties of the cable types, as ``make.cable_type`` takes them."""

RADII = {"Power": 6.0, "SpaceWire": 5.5, "Coax": 3.2}
"""[mm] of the edge of a plug for a cable of this type"""

UP, FRONT, RIGHT = (0, 0, 1), (0, -1, 0), (1, 0, 0)


def _connector(kind, centre, direction):
    return Connector(centre, direction, RADII[kind])


CONNECTORS = {
    # power unit
    "A1": _connector("Power", (-205, 130, 144), UP),
    "A2": _connector("Power", (-150, 130, 144), UP),
    "A3": _connector("SpaceWire", (-165, 75, 144), UP),
    # computer
    "B1": _connector("Power", (-15, 140, 164), UP),
    "B2": _connector("SpaceWire", (75, 140, 164), UP),
    "B3": _connector("Coax", (42, 110, 164), UP),
    "B4": _connector("Coax", (-20, 31, 80), FRONT),
    "B5": _connector("Coax", (18, 31, 80), FRONT),
    "B6": _connector("SpaceWire", (75, 31, 80), FRONT),
    # transponder
    "C1": _connector("SpaceWire", (200, 140, 114), UP),
    "C2": _connector("SpaceWire", (200, 85, 114), UP),
    "C3": _connector("Coax", (197, 6, 38), FRONT),
    # reaction wheel
    "D1": _connector("SpaceWire", (-145, -125, 104), UP),
    "D2": _connector("Coax", (-90, -30, 32), (DIAGONAL, DIAGONAL, 0)),
    "D3": _connector("Power", (-195, -90, 104), UP),
    # gyroscope
    "E1": _connector("SpaceWire", (-8, -75, 99), UP),
    "E2": _connector("Coax", (18, -100, 99), UP),
    "E3": _connector("Coax", (42, -65, 99), UP),
    "E4": _connector("Coax", (99, -80, 28), RIGHT),
    # star tracker
    "F1": _connector("SpaceWire", (114, -120, 66), (-DIAGONAL, 0, DIAGONAL)),
}

RUNS = {
    "W1": Run("A2", "B1", "Power", 215),
    "W2": Run("B2", "C1", "SpaceWire", 220),
    "W3": Run("A3", "C2", "SpaceWire", 450),
    "W4": Run("D1", "E1", "SpaceWire", 215),
    "W5": Run("B4", "D2", "Coax", 115),
    "W6": Run("B6", "F1", "SpaceWire", 185),
    "W7": Run("E4", "C3", "Coax", 140),
    "W8": Run("B5", "E2", "Coax", 165),
    "W9": Run("A1", "D3", "Power", 315),
    "W10": Run("B3", "E3", "Coax", 245),
}
"""Every cable is about as short as its bend radius allows, in steps of 5 mm."""
