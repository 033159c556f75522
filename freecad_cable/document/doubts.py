# SPDX-License-Identifier: LGPL-2.1-or-later
"""What looks wrong in a cable type, or is not known, as sentences for whoever trusts its numbers."""

from math import pi

import numpy as np

MODULUS_BOUNDS = (1e5, 1e12)
"""[Pa] Softer than the softest gel or stiffer than diamond, averaged over a section: a wrong unit."""

DENSITY_BOUNDS = (50, 25000)
"""[kg/m³] Lighter than foam or heavier than osmium."""


def doubts(cable_type) -> list[str]:
    """What looks like a wrong unit, with the label of the type in front."""
    return _labelled(cable_type, wrong_units(cable_type.Proxy.rod(cable_type, 1.0)))


def unknowns(cable_type) -> list[str]:
    """What the answer rests on although nobody knows it, with the label of the type in front."""
    return _labelled(cable_type, gaps(cable_type))


def _labelled(cable_type, sentences):
    return [f"{cable_type.Label}: {sentence}" for sentence in sentences]


def wrong_units(rod):
    """Bounds on what a section of this diameter could be made of."""
    inertia, area = pi * (2 * rod.radius) ** 4 / 64, pi * rod.radius**2
    for name, modulus in (
        ("bending", float(np.max(rod.bending_stiffness)) / inertia),
        ("torsional", rod.torsional_stiffness / (2 * inertia)),
    ):
        if not MODULUS_BOUNDS[0] <= modulus <= MODULUS_BOUNDS[1]:
            yield (
                f"Warning: with this diameter, the {name} stiffness means a modulus of {modulus:.2g} Pa, outside "
                f"{MODULUS_BOUNDS[0]:g} to {MODULUS_BOUNDS[1]:g} Pa; check its unit and the diameter."
            )
    density = rod.mass_per_length / area
    if density and not DENSITY_BOUNDS[0] <= density <= DENSITY_BOUNDS[1]:
        yield (
            f"Warning: with this diameter, the mass means a density of {density:.2g} kg/m³, outside "
            f"{DENSITY_BOUNDS[0]} to {DENSITY_BOUNDS[1]} kg/m³; check its unit and the diameter."
        )


def gaps(cable_type):
    """Placeholders, stiffness outside its bounds, and a limit that was not given."""
    names = placeholders(cable_type)
    if names:
        yield f"Warning: {', '.join(names)}: only a placeholder; set what you know of this cable."
    low, mean, high = (
        getattr(cable_type, f"{which}BendingStiffness").Value for which in ("Slip", "", "Stick")
    )
    if low > mean or 0 < high < mean:
        yield "Warning: BendingStiffness lies outside of SlipBendingStiffness and StickBendingStiffness."
    if cable_type.Moving and not cable_type.MinBendRadiusMoving.Value:
        yield "Warning: it is Moving, but has no MinBendRadiusMoving; MinBendRadius counts."


def placeholders(cable_type) -> list[str]:
    """The properties whose number is a placeholder."""
    split = (said.partition(": ") for said in cable_type.Provenance)
    return [name for name, _, source in split if source.startswith("placeholder")]
