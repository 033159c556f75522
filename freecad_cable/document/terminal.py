# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where an end of a cable is held."""

import Part
from FreeCAD import Placement, Rotation, Vector

from .attached import FRAME, OFFSET, REFERENCE, STATUS, Attached
from .frame import frame_of
from .property_table import Checked, Prop

CONDITIONS = ("Clamped", "Swivel", "Pinned", "Free")


class Terminal(Attached):
    """A frame on a part, and what it holds of a cable. The cable leaves along z."""

    TABLE = (
        REFERENCE,
        Prop(
            "Condition",
            "Enumeration",
            "Terminal",
            "What is held. Clamped: position and all directions; Swivel: position and tangent, the cable may "
            "twist; Pinned: position; Free: nothing",
            "Clamped",
            choices=CONDITIONS,
        ),
        Prop("Reverse", "Bool", "Terminal", "Turn the cable into the part instead of out of it"),
        Prop("Roll", "Angle", "Terminal", "Turn about the cable's axis", unit="deg"),
        OFFSET,
        FRAME,
        STATUS,
    )

    def frame(self, obj, found):
        return frame_of(*found, reverse=obj.Reverse)

    def turn(self, obj):
        roll = Checked(obj, self.TABLE).number("Roll")
        return Placement(Vector(), Rotation(Vector(0, 0, 1), roll))

    def marker(self, obj, size):
        return marker(size)

    def run(self, obj):
        if obj.Condition == "Free" and not obj.Reference:
            self.set_editor_modes(obj)
            self.clear(obj, "")
        else:
            super().run(obj)


def marker(size):
    """A square of half-width ``size`` [mm], an arrow out of it along z, and a tick along x, as lines."""
    s = size
    square = Part.makePolygon(
        [Vector(x * s, y * s, 0) for x, y in ((1, 1), (-1, 1), (-1, -1), (1, -1), (1, 1))]
    )
    arrow = Part.makePolygon([Vector(), Vector(0, 0, 2 * s)])
    head = Part.makePolygon([Vector(x * s / 4, 0, z * s) for x, z in ((1, 1.5), (0, 2), (-1, 1.5))])
    tick = Part.makePolygon([Vector(), Vector(s, 0, 0)])
    return Part.makeCompound([square, arrow, head, tick])
