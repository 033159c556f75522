# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where an end of a cable is held."""

from FreeCAD import Placement, Rotation, Vector

from . import markers
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
        Prop(
            "Roll",
            "Quantity",
            "Terminal",
            "Turn about the cable's axis; whole turns do not count",
            unit="deg",
        ),
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
        return markers.terminal(size)

    def run(self, obj):
        if obj.Condition == "Free" and not obj.Reference:
            self.set_editor_modes(obj)
            self.clear(obj, "")
        else:
            super().run(obj)
