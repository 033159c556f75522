# SPDX-License-Identifier: LGPL-2.1-or-later
"""What stands on an edge, a face or an object of a part, and stays with it when the part moves."""

from FreeCAD import Placement

from ..errors import DocumentError
from ..problem.checked import LARGEST
from . import markers
from .property_table import Prop, wrong
from .proxy import Proxy
from .reference import find, pairs, rebase, refuse_stray

REFERENCE = Prop(
    "Reference",
    "XLinkSubList",
    "Attachment",
    "Circular edge, flat or cylindrical face, vertex or object where the cable is held; a second one, a local "
    "coordinate system, gives the axes at a vertex",
)
OFFSET = Prop("Offset", "Placement", "Attachment", "Displacement from the reference, in its axes")
FRAME = Prop(
    "Frame",
    "Placement",
    "Result",
    "Where the cable is held: along z, in the coordinates of the container",
    result=True,
)
STATUS = Prop("Status", "String", "Result", "What is wrong, if anything", result=True)


class Attached(Proxy):
    """Base of what has a ``Reference``. A class of its own says what the reference means and how it is drawn."""

    follows_placements = True

    def frame(self, obj, found):
        """The ``Frame`` that the references lead to. Errors: ``DocumentError``."""
        raise NotImplementedError

    def turn(self, obj) -> Placement:
        """The turn of the frame, in its axes, before the offset."""
        return Placement()

    def marker(self, obj, size):
        """The shape that shows it, in its frame; ``size`` [mm] is that of what it stands on."""
        raise NotImplementedError

    def home(self, obj):
        return obj.Frame

    def set_editor_modes(self, obj):
        # The reference decides.
        obj.setEditorMode("Placement", 2)

    def onChanged(self, obj, name):
        if name == "Reference":
            self.rebase_references(obj)

    def rebase_references(self, obj):
        rebase(obj, "Reference")

    def run(self, obj):
        self.set_editor_modes(obj)
        turn = self.turn(obj) * _offset(obj)
        try:
            frame = self.frame(obj, _found(obj))
        except DocumentError as error:
            raise wrong(obj, "Reference", str(error)) from None
        obj.Frame = frame.placement * turn
        obj.Shape = self.marker(obj, max(frame.size, markers.SMALLEST))
        obj.Placement = obj.Frame
        obj.Status = ""


def _offset(obj):
    base, turn = obj.Offset.Base, obj.Offset.Rotation.Q
    if not (any(turn) and all(abs(number) <= LARGEST for number in (*base, *turn))):
        raise wrong(
            obj,
            "Offset",
            f"moves by ({_listed(base)}) mm and turns by the quaternion ({_listed(turn)}); give finite numbers, and "
            "the rotation an axis and an angle.",
        )
    return obj.Offset


def _listed(numbers):
    return ", ".join(f"{number:g}" for number in numbers)


def _found(obj):
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
    refuse_stray(obj, given)
    # FreeCAD does not keep the order of a list of links: the vertex comes first.
    return sorted(map(find, given), key=lambda found: not _is_vertex(found))


def _is_vertex(found):
    return found.element is not None and found.element.ShapeType == "Vertex"
