# SPDX-License-Identifier: LGPL-2.1-or-later
"""What holds a cable on its way: clamps, sleeves, rings and clips.

A support knows its place and its axis; which way along its axis the cable runs, the cable knows.
"""

import numpy as np
from FreeCAD import Placement, Rotation, Vector

from .. import problem
from ..geometry import rotation
from ..shape.units import placement_to_si, to_si
from . import markers
from .attached import FRAME, OFFSET, REFERENCE, STATUS, Attached
from .frame import passage_of
from .property_table import Checked, Prop, wrong
from .proxy import in_use

POSITION = Prop(
    "Position",
    "Distance",
    "Support",
    "Length of the unloaded cable from its start to here",
    unit="mm",
)
REVERSE = Prop(
    "Reverse",
    "Bool",
    "Support",
    "Let the cable pass the other way. By itself it passes along the axis the way that is nearer to the straight "
    "line from the support or terminal before to the one after",
)


def slides(value):
    """The property, with its value at the start."""
    return Prop(
        "Slides",
        "Bool",
        "Support",
        "Let the cable slide through without friction. Else it is held at Position",
        value,
    )


class Support(Attached):
    """Base of the supports."""

    def held(self, obj, place, way) -> problem.Support:
        """The support as a scene states it, called ``place``. ``way`` (3,) leads from the support before to the one
        after. Errors: ``DocumentError`` for its properties, ``ProblemError``."""
        raise NotImplementedError

    def frame(self, obj, found):
        return passage_of(*found)

    def set_editor_modes(self, obj):
        super().set_editor_modes(obj)
        obj.setEditorMode("Position", 2 if obj.Slides else 0)

    def onChanged(self, obj, name):
        super().onChanged(obj, name)
        if name == "Slides" and in_use(obj):
            self.set_editor_modes(obj)

    def run(self, obj):
        self.arc_length(obj)
        super().run(obj)

    def arc_length(self, obj):
        """[m], or None if the cable slides."""
        if obj.Slides:
            return None
        position = Checked(obj, self.TABLE).number("Position")
        if not position > 0:
            raise wrong(
                obj,
                "Position",
                f"is {position:g} mm; it must be greater than 0 mm, or let the cable slide (Slides).",
            )
        return to_si("length", position)


class _Directed(Support):
    """One that holds the direction of the cable."""

    def directed(self, obj, way):
        """Position (3,) [m] and quaternion (4,), d3 along the cable."""
        position, quaternion = placement_to_si(obj.Frame)
        against = rotation.tangent(quaternion) @ np.asarray(way) < 0
        if against != obj.Reverse:
            quaternion = rotation.backwards(quaternion)
        return position, quaternion


class Clamp(_Directed):
    """Holds position, direction and twist."""

    TABLE = (
        REFERENCE,
        slides(False),
        POSITION,
        REVERSE,
        Prop("Roll", "Quantity", "Support", "Turn about the axis of the reference", unit="deg"),
        OFFSET,
        FRAME,
        STATUS,
    )

    def turn(self, obj):
        roll = Checked(obj, self.TABLE).number("Roll")
        return Placement(Vector(), Rotation(Vector(0, 0, 1), roll))

    def marker(self, obj, size):
        return markers.clamp(size)

    def held(self, obj, place, way):
        position, quaternion = self.directed(obj, way)
        return problem.Clamp(position, quaternion, arc_length=self.arc_length(obj), place=place)


class Sleeve(_Directed):
    """Holds position and direction; the cable may twist in it, and slide."""

    TABLE = (REFERENCE, slides(True), POSITION, REVERSE, OFFSET, FRAME, STATUS)
    statement = problem.Sleeve

    def marker(self, obj, size):
        return markers.sleeve(size)

    def held(self, obj, place, way):
        position, quaternion = self.directed(obj, way)
        return self.statement(
            position,
            rotation.tangent(quaternion),
            arc_length=self.arc_length(obj),
            place=place,
        )


class Clip(Sleeve):
    """A sleeve that grips."""

    TABLE = (REFERENCE, slides(False), POSITION, REVERSE, OFFSET, FRAME, STATUS)
    statement = problem.Clip

    def marker(self, obj, size):
        return markers.clip(size)


class Ring(Support):
    """A round hole: the cable passes within it, at any angle."""

    TABLE = (
        REFERENCE,
        Prop(
            "Radius",
            "Distance",
            "Support",
            "Radius of the hole; that of the reference if it is a circle or a cylinder",
            unit="mm",
        ),
        Prop(
            "Clearance",
            "Distance",
            "Support",
            "Least distance between the surface of the cable and the edge of the hole",
            unit="mm",
        ),
        slides(True),
        POSITION,
        OFFSET,
        FRAME,
        STATUS,
    )

    def frame(self, obj, found):
        frame = super().frame(obj, found)
        if frame.is_round:
            obj.Radius = frame.size
        obj.setEditorMode("Radius", 1 if frame.is_round else 0)
        return frame

    def marker(self, obj, size):
        return markers.ring(max(self.opening(obj)[0], markers.SMALLEST))

    def opening(self, obj):
        """Radius of the hole and of what is left of it [mm]."""
        checked = Checked(obj, self.TABLE)
        radius = checked.number("Radius", above=0)
        clearance = checked.number("Clearance", at_least=0)
        if clearance >= radius:
            raise wrong(
                obj,
                "Clearance",
                f"is {clearance:g} mm; it must be less than the radius of {radius:g} mm.",
            )
        return radius, radius - clearance

    def held(self, obj, place, way):
        position, quaternion = placement_to_si(obj.Frame)
        return problem.Ring(
            position,
            rotation.tangent(quaternion),
            to_si("length", self.opening(obj)[1]),
            arc_length=self.arc_length(obj),
            place=place,
        )
