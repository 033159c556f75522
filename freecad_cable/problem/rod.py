# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rod: the mechanical model of a cable."""

import math
from dataclasses import dataclass, field

import numpy as np

from .checked import number, vector


@dataclass(frozen=True, kw_only=True, eq=False)
class Rod:
    """A rod with constant section.

    Errors: ``ProblemError`` naming the field as ``cable.…``.
    """

    length: float
    """[m], unstretched"""
    radius: float
    """[m], of the outer surface"""
    mass_per_length: float
    """[kg/m], per unstretched length; 0 means weightless"""
    bending_stiffness: np.ndarray
    """(2,) EI about d1 and about d2 [N m²]; one number means both"""
    torsional_stiffness: float
    """GJ [N m²]"""
    axial_stiffness: float | None = None
    """EA [N]; None means inextensible"""
    shear_stiffness: float | None = None
    """GA [N]; None means unshearable"""
    natural_curvature: np.ndarray = field(default=(0.0, 0.0, 0.0))
    """(3,) curvature about d1 and d2 and twist of the unloaded cable, material frame [1/m]"""
    min_bend_radius: float | None = None
    """[m], of the centreline; None means no limit"""

    def __post_init__(self):
        put = lambda name, value: object.__setattr__(self, name, value)  # noqa: E731
        put("length", number("cable.length", self.length, above=0, unit="m"))
        put("radius", number("cable.radius", self.radius, above=0, unit="m"))
        put(
            "mass_per_length",
            number("cable.mass_per_length", self.mass_per_length, at_least=0, unit="kg/m"),
        )
        bending = self.bending_stiffness
        if not isinstance(bending, (list, tuple, np.ndarray)):
            bending = (bending, bending)
        put("bending_stiffness", vector("cable.bending_stiffness", bending, 2))
        for i, value in enumerate(self.bending_stiffness):
            number(f"cable.bending_stiffness[{i}]", value, above=0, unit="N m²")
        put(
            "torsional_stiffness",
            number("cable.torsional_stiffness", self.torsional_stiffness, above=0, unit="N m²"),
        )
        for name, unit in (
            ("axial_stiffness", "N"),
            ("shear_stiffness", "N"),
            ("min_bend_radius", "m"),
        ):
            value = getattr(self, name)
            if value is not None:
                put(name, number(f"cable.{name}", value, above=0, unit=unit))
        put("natural_curvature", vector("cable.natural_curvature", self.natural_curvature))

    @property
    def stiffness(self) -> np.ndarray:
        """(3,) EI1, EI2, GJ [N m²]."""
        return np.append(self.bending_stiffness, self.torsional_stiffness)

    @property
    def isotropic(self) -> bool:
        """Whether bending is alike in all directions and the unloaded cable is straight (it may be twisted)."""
        a, b = self.bending_stiffness
        return bool(a == b and not self.natural_curvature[:2].any())


def round_section(diameter, youngs_modulus, shear_modulus, density):
    """Stiffness and mass of a solid round section.

    diameter [m], moduli [Pa], density [kg/m³] → dict with the section's part of ``Rod``'s arguments.
    EI = E π d⁴/64, GJ = G π d⁴/32, mass = ρ π d²/4. A stranded cable is softer, often by a factor of ten or
    more: this is an upper bound for it.
    """
    diameter = number("cable_type.diameter", diameter, above=0, unit="m")
    youngs_modulus = number("cable_type.youngs_modulus", youngs_modulus, above=0, unit="Pa")
    shear_modulus = number("cable_type.shear_modulus", shear_modulus, above=0, unit="Pa")
    density = number("cable_type.density", density, at_least=0, unit="kg/m³")
    return {
        "radius": diameter / 2,
        "mass_per_length": density * math.pi * diameter**2 / 4,
        "bending_stiffness": youngs_modulus * math.pi * diameter**4 / 64,
        "torsional_stiffness": shear_modulus * math.pi * diameter**4 / 32,
    }
