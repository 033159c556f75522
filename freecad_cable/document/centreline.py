# SPDX-License-Identifier: LGPL-2.1-or-later
"""The centreline of a cable as an object of its own: a spine for native sweeps, a support for sketches."""

from FreeCAD import Placement

from ..shape.centreline import centreline_wire
from .child import CABLE, Child
from .property_table import Prop
from .stored_solution import nodes


class Centreline(Child):
    """A wire of one edge."""

    TABLE = (
        CABLE,
        Prop("Length", "Length", "Result", "Length of the curve", result=True),
        Prop("Status", "String", "Result", "What is wrong, if anything", result=True),
    )

    def set_editor_modes(self, obj):
        obj.setEditorMode("Placement", 2)

    def follow(self, obj, cable):
        obj.Placement = Placement()
        obj.Shape = centreline_wire(nodes(cable))
        obj.Length = obj.Shape.Length
        obj.Status = ""
