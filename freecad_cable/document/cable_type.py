# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a cable is made of: its section, by measured values or by a material."""

from ..errors import ProblemError
from ..problem import Rod, round_section
from ..shape.units import sentence_from_si, to_si
from .doubts import gaps, wrong_units
from .property_table import Checked, Prop, wrong
from .proxy import Proxy, in_use

BY_MATERIAL = ("MassPerLength", "BendingStiffness", "SecondBendingStiffness", "TorsionalStiffness")
"""What follows from the material if that is the source."""

OF_MATERIAL = ("YoungsModulus", "ShearModulus", "Density")

NOT_GIVEN = ("OuterDiameter", "MassPerLength", "BendingStiffness", "TorsionalStiffness")
"""What every cable has, so that there is a number from the start."""

IN_SCENE = {
    "cable_type.diameter": "OuterDiameter",
    "cable_type.youngs_modulus": "YoungsModulus",
    "cable_type.shear_modulus": "ShearModulus",
    "cable_type.density": "Density",
    "cable.radius": "OuterDiameter",
    "cable.mass_per_length": "MassPerLength",
    "cable.bending_stiffness[0]": "BendingStiffness",
    "cable.bending_stiffness[1]": "SecondBendingStiffness",
    "cable.torsional_stiffness": "TorsionalStiffness",
    "cable.axial_stiffness": "AxialStiffness",
    "cable.shear_stiffness": "ShearStiffness",
    "cable.natural_curvature": "NaturalCurvature",
}
"""Fields of the scene and the properties that state them."""


SOURCED = (
    *NOT_GIVEN,
    *OF_MATERIAL,
    "SlipBendingStiffness",
    "StickBendingStiffness",
    "SecondBendingStiffness",
    "AxialStiffness",
    "MinBendRadius",
    "MinBendRadiusMoving",
)
"""Numbers that come from somewhere."""

CHANGED = "user, set in the document"


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
            "SlipBendingStiffness",
            "Quantity",
            "Section",
            "Least bending stiffness, where all strands slip; 0: not known",
            unit="N*m^2",
        ),
        Prop(
            "StickBendingStiffness",
            "Quantity",
            "Section",
            "Greatest bending stiffness, where no strand slips; 0: not known",
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
            "Smallest bend radius the cable may have where it is laid; 0: no limit",
            unit="mm",
        ),
        Prop(
            "MinBendRadiusMoving",
            "Distance",
            "Bend Radius",
            "Smallest bend radius the cable may have where it moves; 0: not known",
            unit="mm",
        ),
        Prop(
            "Moving",
            "Bool",
            "Bend Radius",
            "Whether the cable moves, so that MinBendRadiusMoving counts",
        ),
        Prop(
            "BendRadiusConvention",
            "Enumeration",
            "Bend Radius",
            "Where the smallest bend radius is measured: at the inside of the bend or at the centreline",
            "Inside",
            choices=("Inside", "Centreline"),
        ),
        Prop(
            "Provenance",
            "StringList",
            "Section",
            "Where each number comes from: measured, datasheet, standard, derived, user or placeholder, and the source",
            [f"{name}: placeholder, not given" for name in NOT_GIVEN],
        ),
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
        if not in_use(obj) or obj.Document.Transacting:
            return
        if name == "Source":
            self.set_editor_modes(obj)
        elif name in SOURCED:
            of_material = obj.Source == "Material" and name in BY_MATERIAL
            _tell_source(obj, name, "derived, from the material" if of_material else CHANGED)

    def run(self, obj):
        checked = Checked(obj, self.TABLE)
        diameter = checked.number("OuterDiameter", above=0)
        for name in ("MinBendRadius", "MinBendRadiusMoving"):
            checked.number(name, at_least=0)
        if obj.Source == "Material":
            try:
                _compute(obj, checked, to_si("length", diameter))
            except ProblemError as error:
                raise _in_properties(obj, error) from None
        rod = self.rod(obj, 1.0)
        obj.Status = " ".join([_in_words(rod, diameter), *wrong_units(rod), *gaps(obj)])

    def rod(self, obj, length) -> Rod:
        """The rod of a cable of this type, of ``length`` [m]. Errors: ``DocumentError``."""
        checked = Checked(obj, self.TABLE)
        second = (
            "SecondBendingStiffness"
            if checked.number("SecondBendingStiffness")
            else "BendingStiffness"
        )
        diameter = to_si("length", checked.number("OuterDiameter", above=0))
        limit = to_si("length", checked.number(_limit(obj), at_least=0))
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
            if error.field == "cable.length":
                raise  # whoever asked gave it
            raise _in_properties(obj, error) from None


def _limit(obj):
    """The property that states the smallest bend radius."""
    moving = obj.Moving and obj.MinBendRadiusMoving.Value
    return "MinBendRadiusMoving" if moving else "MinBendRadius"


def _tell_source(obj, name, source):
    """In the provenance, where a number now comes from; one of a property without a number is gone."""
    kept = [said for said in obj.Provenance if not said.startswith(f"{name}: ")]
    told = [f"{name}: {source}"] if getattr(obj, name).Value else []
    if sorted([*kept, *told]) != sorted(obj.Provenance):
        obj.Provenance = [*kept, *told]


def _compute(obj, checked, diameter):
    """Mass and stiffness from the material."""
    section = round_section(diameter, *(checked.number(name, above=0) for name in OF_MATERIAL))
    obj.MassPerLength = f"{section['mass_per_length']!r} kg/m"
    obj.BendingStiffness = f"{section['bending_stiffness']!r} N*m^2"
    obj.SecondBendingStiffness = "0 N*m^2"
    obj.TorsionalStiffness = f"{section['torsional_stiffness']!r} N*m^2"


def _in_properties(obj, error):
    known = IN_SCENE | {"cable.min_bend_radius": _limit(obj)}
    name = known.get(error.field) or known[error.field.partition("[")[0]]
    return wrong(obj, name, f"{sentence_from_si(error.message)}.")


def _in_words(rod, diameter):
    first, second = rod.bending_stiffness
    bending = f"EI {first:.4g} N m²"
    if first != second:
        bending = f"EI {first:.4g} and {second:.4g} N m²"
    return (
        f"Diameter {diameter:g} mm, {1e3 * rod.mass_per_length:.4g} g/m, {bending}, "
        f"GJ {rod.torsional_stiffness:.4g} N m²."
    )
