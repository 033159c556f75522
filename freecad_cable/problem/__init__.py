# SPDX-License-Identifier: LGPL-2.1-or-later
"""The statement of a cable problem: frozen, checked, in SI units. NumPy only.

Every class refuses values that mean nothing with a ``ProblemError`` that names the field in the words of
the scene file. What needs more than one field (a cable shorter than its chord, ends that hold nothing) is
checked by ``Scene``.
"""

from .ends import Clamped, End, Free, Pinned, Swivel
from .obstacles import Box, Cylinder, HalfSpace, Obstacle, Sphere
from .rod import Rod, round_section
from .scene import Scene
from .supports import Clamp, Clip, Ring, Sleeve, Support
from .surfaces import Mesh, Tube

__all__ = [
    "Box",
    "Clamp",
    "Clamped",
    "Clip",
    "Cylinder",
    "End",
    "Free",
    "HalfSpace",
    "Mesh",
    "Obstacle",
    "Pinned",
    "Ring",
    "Rod",
    "Scene",
    "Sleeve",
    "Sphere",
    "Support",
    "Swivel",
    "Tube",
    "round_section",
]
