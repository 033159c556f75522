# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where an end of a cable is held."""

import Part
from FreeCAD import Placement, Rotation, Vector

from ..errors import DocumentError
from .frame import frame_of
from .property_table import Checked, Prop, wrong
from .proxy import Proxy, in_use
from .reference import based_beside, find, pairs

CONDITIONS = ("Clamped", "Swivel", "Pinned", "Free")


class Terminal(Proxy):
    """A frame on a part, and what it holds of a cable."""

    TABLE = (
        Prop(
            "Reference",
            "XLinkSubList",
            "Terminal",
            "Circular edge, flat or cylindrical face, vertex or object where the cable is held; a second one, a "
            "local coordinate system, gives the axes at a vertex",
        ),
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
        Prop("Offset", "Placement", "Terminal", "Displacement from the reference, in its axes"),
        Prop(
            "Frame",
            "Placement",
            "Result",
            "Where the cable leaves: along z, in the coordinates of the container of the terminal",
            result=True,
        ),
        Prop("Status", "String", "Result", "What is wrong, if anything", result=True),
    )

    follows_placements = True

    def set_editor_modes(self, obj):
        # The reference decides.
        obj.setEditorMode("Placement", 2)

    def onChanged(self, obj, name):
        if name == "Reference":
            self.rebase_reference(obj)

    def rebase_reference(self, obj):
        """Say the reference from a root beside ``obj``, whatever form a user, a macro or a move left it in."""
        if not in_use(obj) or obj.Document.Transacting:
            return
        given = pairs(obj.Reference)
        try:
            based = [based_beside(obj, pair) for pair in given]
        except DocumentError:
            return  # said when the object is computed
        if based != given:
            obj.Reference = based

    def run(self, obj):
        self.set_editor_modes(obj)
        roll = Checked(obj, self.TABLE).number("Roll")
        if obj.Condition == "Free" and not obj.Reference:
            self.clear(obj, "")
            return
        try:
            frame = frame_of(*self._found(obj), reverse=obj.Reverse)
        except DocumentError as error:
            raise wrong(obj, "Reference", str(error)) from None
        turned = Placement(Vector(), Rotation(Vector(0, 0, 1), roll)) * obj.Offset
        obj.Frame = frame.placement * turned
        obj.Shape = marker(frame.size)
        obj.Placement = obj.Frame
        obj.Status = ""

    def _found(self, obj):
        """What the one or two references lead to."""
        given = pairs(obj.Reference)
        if not given:
            raise DocumentError(
                "is empty: its object was deleted or never chosen. Choose an edge, a face or an object."
            )
        if len(given) > 2:
            raise DocumentError(
                f"has {len(given)} entries; it takes one, or a vertex and a local coordinate system."
            )
        for pair in given:
            if based_beside(obj, pair) != pair:
                raise DocumentError(f"leads out of its container; choose {pair[0].Label} anew.")
        # FreeCAD does not keep the order of a list of links: the vertex comes first.
        return sorted(map(find, given), key=lambda found: not _is_vertex(found))


def _is_vertex(found):
    return found.element is not None and found.element.ShapeType == "Vertex"


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
