# SPDX-License-Identifier: LGPL-2.1-or-later
"""A comparison curve without mechanics, beside the cable."""

from contextlib import suppress
from dataclasses import replace

import Part
from FreeCAD import Placement, Vector

from ..errors import CableError, DocumentError, ProblemError
from ..routes import METHODS, compare, inputs
from ..shape.units import from_si, to_si, vectors_from_si
from .child import CABLE, Child
from .property_table import Prop, wrong
from .read_held import read_held
from .stored_solution import fingerprint

POINTS = 100
"""About as many of the samples of a route are interpolated; the curve is then within 1e-3 of a bend radius."""


class Route(Child):
    """What a drawing would show between the same terminals."""

    TABLE = (
        CABLE,
        Prop(
            "Method",
            "Enumeration",
            "Route",
            "Spline: as CAD routes a cable, with the directions of the terminals. Catenary: a thread of the cable's "
            "length without stiffness. Chord: straight",
            "Spline",
            choices=tuple(METHODS),
        ),
        Prop("Length", "Length", "Result", "Length of the route", result=True),
        Prop("SmallestBendRadius", "Distance", "Result", "Smallest bend radius", result=True),
        Prop(
            "SmallestBendRadiusAt",
            "Distance",
            "Result",
            "Distance of the tightest place from the start, along the route",
            result=True,
        ),
        Prop(
            "LengthDifference",
            "Distance",
            "Result",
            "Length of the route less that of the cable",
            result=True,
        ),
        Prop(
            "RelativeLengthDifference",
            "Float",
            "Result",
            "The difference, relative to the length of the cable",
            result=True,
        ),
        Prop("Status", "String", "Result", "What is wrong, if anything", result=True),
        Prop(
            "DrawnInputs",
            "String",
            "Route",
            "Fingerprint of what was drawn",
            result=True,
            hidden=True,
        ),
    )

    def set_editor_modes(self, obj):
        obj.setEditorMode("Placement", 2)

    def follow(self, obj, cable):
        self._draw(obj, cable)
        difference = compare(*(to_si("length", x) for x in (obj.Length, cable.SolvedLength)))
        obj.LengthDifference = from_si("length", difference.absolute)
        obj.RelativeLengthDifference = difference.relative
        obj.Status = ""

    def clear(self, obj, sentence):
        """A route needs no mechanics, so it is drawn even if the cable has no solution."""
        super().clear(obj, sentence)
        with suppress(CableError):  # what is wrong has been said
            self._draw(obj, self.linked_cable(obj))

    def _draw(self, obj, cable):
        """Shape, length and bend radius, unless they stand: few routes depend on the length of the cable."""
        scene = routed_scene(cable, obj.Method)
        drawn = fingerprint(inputs(obj.Method, scene))
        if not obj.Placement.isIdentity():
            obj.Placement = Placement()
        if obj.DrawnInputs == drawn and not obj.Shape.isNull():
            return
        try:
            route = METHODS[obj.Method](scene)
            obj.Shape = _wire(route)
        except (ProblemError, Part.OCCError) as error:
            raise wrong(obj, "Method", f"{obj.Method} cannot be drawn: {error}.") from None
        obj.Length = from_si("length", route.length)
        obj.SmallestBendRadius = from_si("length", route.smallest_bend_radius)
        obj.SmallestBendRadiusAt = from_si("length", route.smallest_bend_radius_at)
        obj.DrawnInputs = drawn


def routed_scene(cable, method):
    """The scene that a method of ``METHODS`` takes: with the length that was found, where it is what the cable asks
    for. Errors: ``DocumentError``."""
    scene = read_held(cable)
    if not scene.asks_length:
        return scene
    length = to_si("length", cable.SolvedLength)
    if not length and method == "Catenary":
        raise DocumentError(cable.Status)
    return replace(scene, rod=replace(scene.rod, length=length or scene.rod.length))


def _wire(route):
    points = vectors_from_si(route.position)
    if route.method == "Chord":
        return Part.makePolygon(points)
    every = max(1, (len(points) - 1) // POINTS)
    chosen = [*range(0, len(points) - 1, every), len(points) - 1]
    curve = Part.BSplineCurve()
    curve.interpolate(
        Points=[points[i] for i in chosen],
        Parameters=[from_si("length", float(route.arc_length[i])) for i in chosen],
        InitialTangent=Vector(*route.tangent[0].tolist()),
        FinalTangent=Vector(*route.tangent[-1].tolist()),
        Scale=False,
    )
    return Part.Wire([curve.toShape()])
