# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mass and stiffness of wires and fibres from their construction: the numbers called derived in ``cable_types.csv``.

    python3 resources/derive_cable_types.py

prints them. Of a stranded wire the bending stiffness is known within bounds only: strands that slip bend each about
its own axis, strands that stick bend about the axis of the wire. Between them the geometric mean is taken, because the
bounds are a factor apart, not a difference. Twist: GJ = EI, since the three wires measured by Chen, Bretl, Pham (arXiv
2310.00911) lie on both sides of it, between 0.7 and 1.9.

Young's moduli and densities are textbook values of the materials.
"""

from dataclasses import dataclass
from math import pi, sqrt

COPPER, SILICA = (117e9, 8960), (72e9, 2200)
ETFE, PVC, SILICONE = (0.9e9, 1700), (30e6, 1350), (4e6, 1150)
"""Young's modulus [Pa] and density [kg/m³]."""

ACRYLATE_DENSITY = 1100
"""[kg/m³]"""

SILICA_SHEAR = 31e9
"""[Pa]"""

HEXAGONS = {1: 0, 7: 6, 19: 48}
"""Number of strands, and the sum of the squared distances of their axes from that of the wire, in strand diameters."""

BUNCHED = 0.75
"""Share of the conductor's area that is copper, of strands that are bunched."""


@dataclass(frozen=True)
class Wire:
    """A stranded copper conductor with one insulation. Lengths in mm."""

    strands: int
    strand: float
    """diameter"""
    diameter: float
    """over the insulation"""
    insulation: tuple

    @property
    def conductor(self):
        """Diameter over all strands."""
        layers = {1: 1, 7: 3, 19: 5}
        return self.strand * (layers.get(self.strands) or sqrt(self.strands / BUNCHED))

    def mass_per_length(self):
        """[g/m]"""
        copper = self.strands * pi * self.strand**2 / 4
        around = pi * (self.diameter**2 - self.conductor**2) / 4
        return 1e-3 * (copper * COPPER[1] + around * self.insulation[1])

    def bounds(self):
        """Bending stiffness [N m²] if the strands slip, and if they stick."""
        one = pi * self.strand**4 / 64
        area = pi * self.strand**2 / 4
        squares = HEXAGONS.get(self.strands)
        if squares is None:  # spread evenly over the conductor
            squares = self.strands * (self.conductor / self.strand) ** 2 / 8
        around = self.insulation[0] * pi * (self.diameter**4 - self.conductor**4) / 64
        slipping = COPPER[0] * self.strands * one + around
        # Half of the squares: about one axis of two.
        sticking = slipping + COPPER[0] * area * self.strand**2 * squares / 2
        return 1e-12 * slipping, 1e-12 * sticking


WIRES = {
    "Hook-up wire AWG 26, ETFE": Wire(19, 0.102, 0.81, ETFE),
    "Hook-up wire AWG 24, ETFE": Wire(19, 0.127, 0.94, ETFE),
    "Hook-up wire AWG 22, ETFE": Wire(19, 0.160, 1.09, ETFE),
    "Hook-up wire AWG 20, ETFE": Wire(19, 0.203, 1.27, ETFE),
    "Hook-up wire AWG 22, PVC": Wire(7, 0.254, 1.6, PVC),
    "Hook-up wire AWG 22, silicone": Wire(60, 0.08, 1.7, SILICONE),
}


def flat_pair():
    """Two solid AWG 22 conductors side by side in PVC, 1.83 mm by 2.72 mm: EI about the axis through both, EI slipping
    and sticking about the other, GJ slipping [N m²]."""
    width, height, wire = 2.72, 1.83, 0.644
    one, area = COPPER[0] * pi * wire**4 / 64, COPPER[0] * pi * wire**2 / 4
    jacket = PVC[0] * pi / 64
    easy = 2 * one + jacket * width * height**3
    slipping = 2 * one + jacket * height * width**3
    sticking = slipping + 2 * area * ((width - height) / 2) ** 2
    # Of a circle GJ = EI / (1 + ν); copper has ν = 0.34.
    return tuple(1e-12 * value for value in (easy, slipping, sticking, 2 * one / 1.34))


def fibre():
    """A single-mode fibre, 125 µm of silica in 250 µm of acrylate that is too soft to count: mass [g/m], EI and GJ
    [N m²]."""
    glass, coat = 0.125, 0.250
    area, around = pi * glass**2 / 4, pi * (coat**2 - glass**2) / 4
    mass = 1e-3 * (area * SILICA[1] + around * ACRYLATE_DENSITY)
    inertia = pi * glass**4 / 64
    return mass, 1e-12 * SILICA[0] * inertia, 1e-12 * SILICA_SHEAR * 2 * inertia


if __name__ == "__main__":
    for name, wire in WIRES.items():
        low, high = wire.bounds()
        mean = sqrt(low * high)
        print(
            f"{name}: {wire.mass_per_length():.2g} g/m, EI {low:.2g} … {mean:.2g} … {high:.2g} N m²"
        )
    print(
        "Flat pair: EI about the easy axis, slipping, sticking; GJ:",
        *(f"{v:.3g}" for v in flat_pair()),
    )
    print("Fibre: g/m, EI, GJ:", *(f"{v:.2g}" for v in fibre()))
