# SPDX-License-Identifier: LGPL-2.1-or-later
"""Between FreeCAD's internal units and SI: the only place with a factor between mm and m.

FreeCAD computes in mm, kg, s: a force is in mN, a pressure in kPa, a density in kg/mm³. The core
computes in m, kg, s.
"""

import re

import FreeCAD
import numpy as np

FREECAD_PER_SI = {
    "length": 1e3,  # mm
    "curvature": 1e-3,  # 1/mm
    "acceleration": 1e3,  # mm/s²
    "mass_per_length": 1e-3,  # kg/mm
    "density": 1e-9,  # kg/mm³
    "pressure": 1e-3,  # kg/(mm s²) = kPa
    "force": 1e3,  # kg mm/s² = mN
    "moment": 1e6,  # kg mm²/s²
    "energy": 1e6,  # kg mm²/s²
    "stiffness": 1e9,  # EI, GJ: kg mm³/s²
}
"""What one SI unit of each kind of quantity is in FreeCAD's internal unit."""

METRES = re.compile(r"(?<![\w.])([-−]?\d+(?:\.\d+)?(?:e[-+]?\d+)?) m(?![\w²³/·*^])")
"""A length in a sentence; not an acceleration, a moment or a volume."""


def to_si(kind, value):
    """``value`` in FreeCAD's internal unit (number, array or ``Quantity``) in SI; ``kind`` as above."""
    return getattr(value, "Value", value) / FREECAD_PER_SI[kind]


def from_si(kind, value):
    """``value`` in SI (number or array) in FreeCAD's internal unit; ``kind`` as above."""
    return value * FREECAD_PER_SI[kind]


def vector_to_si(vector, kind="length"):
    """A FreeCAD vector as an array (3,) in SI."""
    return to_si(kind, np.array(vector, float))


def vectors_to_si(vectors, kind="length"):
    """FreeCAD vectors as an array (n, 3) in SI."""
    return to_si(kind, np.array([tuple(vector) for vector in vectors], float))


def vector_from_si(array, kind="length"):
    """An array (3,) in SI as a FreeCAD vector."""
    return FreeCAD.Vector(*from_si(kind, np.asarray(array, float)).tolist())


def vectors_from_si(array, kind="length"):
    """An array (n, 3) in SI as a list of n FreeCAD vectors."""
    return [FreeCAD.Vector(*row) for row in from_si(kind, np.asarray(array, float)).tolist()]


def placement_to_si(placement):
    """Position (3,) [m] and unit quaternion (4,), scalar first, of a placement."""
    x, y, z, w = placement.Rotation.Q
    return vector_to_si(placement.Base), np.array([w, x, y, z])


def placement_from_si(position, quaternion):
    """The placement at ``position`` (3,) [m] turned by ``quaternion`` (4,), scalar first."""
    w, x, y, z = np.asarray(quaternion, float).tolist()
    return FreeCAD.Placement(vector_from_si(position), FreeCAD.Rotation(x, y, z, w))


def sentence_from_si(sentence, leave=()):
    """``sentence`` with its lengths in mm; what it says literally of ``leave``, names given by a user, stays."""
    names = sorted(filter(METRES.search, leave), key=len, reverse=True)
    either = re.compile("|".join([*(f"({re.escape(name)})" for name in names), METRES.pattern]))

    def changed(match):
        metres = match.groups()[-1]
        if metres is None:
            return match.group()
        return f"{from_si('length', float(metres.replace('−', '-'))):.9g} mm"

    return either.sub(changed, sentence)
