# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cable, under it in the tree what belongs to it, and over it what the window draws."""

from contextlib import suppress

import FreeCAD

from ...errors import CableError
from ..icons import icon
from ..preferences import cable_colour
from .markings import CONTACT, FORCE, VIOLATED, Marks, Skin
from .overlay import Line
from .view import View

translate = FreeCAD.Qt.translate

SHOWN = {
    "ColourByBendRadius": "Colour the cable by how far its bend radius is above the limit: red below it, orange up to "
    "10 % above, yellow at 50 %, green from 100 %",
    "ShowTightest": "Mark the place with the smallest bend radius",
    "ShowForces": "Show what terminals and supports exert on the cable as arrows",
    "ShowContacts": "Mark the places where obstacles push the cable",
}
"""Properties of the view, and their texts."""

ARROW = 0.2
"""Length of the longest arrow, as a share of that of the cable."""


class CableView(View):
    icon_name = "cable"

    def __init__(self, view):
        super().__init__(view)
        view.ShapeColor = cable_colour()

    def attach(self, view):
        super().attach(view)
        self._solve_beside()
        for name, text in SHOWN.items():
            if name not in view.PropertiesList:
                view.addProperty("App::PropertyBool", name, "Cable", text)
        self.line, self.skin = Line(), Skin()
        self.tightest, self.contacts = Marks(VIOLATED), Marks(CONTACT)
        self.forces = Marks(FORCE)
        # Before the fade, which counts for what comes after it.
        view.RootNode.insertChild(self.line.node, 0)
        for each in (self.skin, self.tightest, self.contacts, self.forces):
            view.RootNode.addChild(each.node)

    @staticmethod
    def _solve_beside():
        """Not at every start of FreeCAD: only where there are cables."""
        from .. import live, progress, worker

        for each in (worker, live, progress):
            each.install()

    def make_panel(self):
        from ..panels.cable import CablePanel

        return CablePanel(self.object)

    def claimChildren(self):
        """The terminals and supports, and what is drawn from the cable."""
        cable = self.object
        ours = [obj for obj in cable.InList if hasattr(getattr(obj, "Proxy", None), "TABLE")]
        return [obj for obj in (cable.Start, *cable.Supports, cable.End, *ours) if obj]

    def setupContextMenu(self, view, menu):
        from ...document import solving

        text = translate("Cable", "Solve Now")
        menu.addAction(text).triggered.connect(lambda: solving.solve(view.Object))
        return False  # FreeCAD's own entries stay

    def getIcon(self):
        return icon("cable_outdated") if self._is_old() else super().getIcon()

    def updateData(self, cable, name):
        if name == "OutOfDate":
            self._fade(cable.OutOfDate)
            if not cable.OutOfDate:
                self.rest()
            cable.ViewObject.signalChangeIcon()
        elif name == "Shape":
            self.mark()

    def onChanged(self, view, name):
        if name == "Visibility" and not view.Visibility:
            self.rest()
        if (name == "Visibility" or name in SHOWN) and not view.Object.Document.Restoring:
            self.mark()

    def finishRestoring(self):
        """FreeCAD has read the properties of the view; of some it speaks before the objects are complete."""
        self._fade(self._is_old())
        self.mark()

    def follow(self, points):
        """Something moves: the line through ``points`` is where the cable would lie; none if it cannot be said."""
        self._fade(True)
        self._hide_marks()
        if points and self.object.ViewObject.Visibility:
            self.line.draw(points)
        else:
            self.line.show(False)

    def rest(self):
        """What is drawn is what is in the document."""
        self.line.show(False)
        self._fade(self._is_old())
        self.mark()

    def mark(self):
        """Draw the markings that are wanted, as the document has them."""
        self._hide_marks()
        view = getattr(getattr(self, "object", None), "ViewObject", None)
        if view is None or not view.Visibility or not getattr(self.object, "SolvedInputs", ""):
            return
        from ...document import markings

        cable = self.object
        wanted = [name for name in SHOWN if getattr(view, name, False)]
        # What has no surface has a line, and what is wrong is said there.
        with suppress(CableError):
            if "ColourByBendRadius" in wanted:
                self.skin.draw(markings.coloured(cable))
        radius = cable.CableType.OuterDiameter.Value / 2
        if "ShowTightest" in wanted:
            self.tightest.draw_balls([m for m in [markings.tightest(cable)] if m], 1.5 * radius)
        if "ShowContacts" in wanted:
            self.contacts.draw_balls(markings.contacts(cable), 1.2 * radius)
        if "ShowForces" in wanted:
            length = ARROW * cable.SolvedLength.Value
            self.forces.draw_arrows(markings.forces(cable), length, radius)

    def _hide_marks(self):
        for each in (self.skin, self.tightest, self.contacts, self.forces):
            each.show(False)

    def _fade(self, on):
        self.fade.set(on)
        centreline = getattr(self.object, "Centreline", None)
        # It may be on its way in or out of the document.
        view = getattr(getattr(centreline, "ViewObject", None), "Proxy", None)
        if view is not None:
            view.fade.set(on)

    def _is_old(self):
        return getattr(self.object, "OutOfDate", False)
