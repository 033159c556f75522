# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a cable is made of: its section, by measured values or by a material."""

from math import pi

import numpy as np

from ..errors import ProblemError
from ..problem import Rod, round_section
from ..shape.units import to_si
from .property_table import Checked, Prop, wrong
from .proxy import Proxy, in_use

MODULUS_BOUNDS = (1e5, 1e12)
"""[Pa] Softer than the softest gel or stiffer than diamond, averaged over a section: a wrong unit."""

DENSITY_BOUNDS = (50, 25000)
"""[kg/m³] Lighter than foam or heavier than osmium."""

BY_MATERIAL = ("MassPerLength", "BendingStiffness", "SecondBendingStiffness", "TorsionalStiffness")
"""What follows from the material if that is the source."""

OF_MATERIAL = ("YoungsModulus", "ShearModulus", "Density")

IN_SCENE = {
    "cable.mass_per_length": "MassPerLength",
    "cable.bending_stiffness[0]": "BendingStiffness",
    "cable.bending_stiffness[1]": "SecondBendingStiffness",
    "cable.torsional_stiffness": "TorsionalStiffness",
    "cable.axial_stiffness": "AxialStiffness",
    "cable.shear_stiffness": "ShearStiffness",
    "cable.natural_curvature": "NaturalCurvature",
}
"""Fields of the scene and the properties that state them."""


class CableType(Proxy):
    """A kind of cable, shared by all cables of it."""

    TABLE = (
        Prop("OuterDiameter", "Distance", "Section", "Outer diameter", "7 mm", unit="mm"),
        Prop(
            "Source",
            "Enumeration",
            "Section",
            "Values: stiffness and mass as given. Material: those of a solid round section; a stranded cable is "
            "softer, often ten times",
            "Values",
            choices=("Values", "Material"),
        ),
        Prop(
            "MassPerLength",
            "Quantity",
            "Section",
            "Mass per length",
            "44.6 g/m",
            unit="kg/m",
        ),
        Prop(
            "BendingStiffness",
            "Quantity",
            "Section",
            "Bending stiffness EI",
            "1.18e-3 N*m^2",
            unit="N*m^2",
        ),
        Prop(
            "SecondBendingStiffness",
            "Quantity",
            "Section",
            "Bending stiffness EI about the second axis of the section, of a flat cable; 0: the same",
            unit="N*m^2",
        ),
        Prop(
            "TorsionalStiffness",
            "Quantity",
            "Section",
            "Torsional stiffness GJ",
            "1.18e-3 N*m^2",
            unit="N*m^2",
        ),
        Prop(
            "AxialStiffness",
            "Force",
            "Section",
            "Axial stiffness EA; 0: does not stretch",
            unit="N",
        ),
        Prop(
            "ShearStiffness", "Force", "Section", "Shear stiffness GA; 0: does not shear", unit="N"
        ),
        Prop(
            "NaturalCurvature",
            "Vector",
            "Section",
            "Curvature about the two axes of the section and twist of the unloaded cable, in 1/m",
        ),
        Prop("YoungsModulus", "Pressure", "Material", "Young's modulus", "10 MPa", unit="Pa"),
        Prop("ShearModulus", "Pressure", "Material", "Shear modulus", "5 MPa", unit="Pa"),
        Prop("Density", "Quantity", "Material", "Density", "1160 kg/m^3", unit="kg/m^3"),
        Prop(
            "MinBendRadius",
            "Distance",
            "Bend Radius",
            "Smallest bend radius the cable may have; 0: no limit",
            unit="mm",
        ),
        Prop(
            "BendRadiusConvention",
            "Enumeration",
            "Bend Radius",
            "Where the smallest bend radius is measured: at the inside of the bend or at the centreline",
            "Inside",
            choices=("Inside", "Centreline"),
        ),
        Prop("Provenance", "String", "Section", "Where the numbers come from"),
        Prop(
            "Status", "String", "Result", "The section in words, and what looks wrong", result=True
        ),
    )

    def set_editor_modes(self, obj):
        material = obj.Source == "Material"
        for name in BY_MATERIAL:
            obj.setEditorMode(name, 1 if material else 0)
        for name in OF_MATERIAL:
            obj.setEditorMode(name, 0 if material else 2)

    def onChanged(self, obj, name):
        if name == "Source" and in_use(obj):
            self.set_editor_modes(obj)

    def run(self, obj):
        checked = Checked(obj, self.TABLE)
        diameter = checked.number("OuterDiameter", above=0)
        checked.number("MinBendRadius", at_least=0)
        if obj.Source == "Material":
            _compute(obj, checked, to_si("length", diameter))
        rod = self.rod(obj, 1.0)
        obj.Status = " ".join([_in_words(rod, diameter), *_doubts(rod)])

    def rod(self, obj, length) -> Rod:
        """The rod of a cable of this type, of ``length`` [m]. Errors: ``DocumentError``."""
        checked = Checked(obj, self.TABLE)
        second = (
            "SecondBendingStiffness"
            if checked.number("SecondBendingStiffness")
            else "BendingStiffness"
        )
        diameter = to_si("length", checked.number("OuterDiameter", above=0))
        limit = to_si("length", checked.number("MinBendRadius", at_least=0))
        if limit and obj.BendRadiusConvention == "Inside":
            limit += diameter / 2
        try:
            return Rod(
                length=length,
                radius=diameter / 2,
                mass_per_length=checked.number("MassPerLength", above=0),
                bending_stiffness=[checked.number(name) for name in ("BendingStiffness", second)],
                torsional_stiffness=checked.number("TorsionalStiffness"),
                axial_stiffness=checked.number("AxialStiffness") or None,
                shear_stiffness=checked.number("ShearStiffness") or None,
                natural_curvature=list(obj.NaturalCurvature),
                min_bend_radius=limit or None,
            )
        except ProblemError as error:
            raise _in_properties(obj, error) from None


def doubts(obj):
    """What looks like a wrong unit in a cable type, as sentences that name it."""
    return [f"{obj.Label}: {sentence}" for sentence in _doubts(obj.Proxy.rod(obj, 1.0))]


def _compute(obj, checked, diameter):
    """Mass and stiffness from the material."""
    section = round_section(diameter, *(checked.number(name, above=0) for name in OF_MATERIAL))
    obj.MassPerLength = f"{section['mass_per_length']!r} kg/m"
    obj.BendingStiffness = f"{section['bending_stiffness']!r} N*m^2"
    obj.SecondBendingStiffness = "0 N*m^2"
    obj.TorsionalStiffness = f"{section['torsional_stiffness']!r} N*m^2"


def _in_properties(obj, error):
    name = IN_SCENE.get(error.field, IN_SCENE.get(error.field.partition("[")[0]))
    return wrong(obj, name, f"{error.message}.")


def _in_words(rod, diameter):
    first, second = rod.bending_stiffness
    bending = f"{first:.4g}" if first == second else f"{first:.4g} and {second:.4g}"
    return (
        f"Diameter {diameter:g} mm, {1e3 * rod.mass_per_length:.4g} g/m, EI {bending} N m², "
        f"GJ {rod.torsional_stiffness:.4g} N m²."
    )


def _doubts(rod):
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
