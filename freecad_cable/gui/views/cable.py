# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cable, under it in the tree what belongs to it, and over it what the window draws."""

import FreeCAD

from ..icons import icon
from ..preferences import cable_colour
from .overlay import Line
from .view import View

translate = FreeCAD.Qt.translate


class CableView(View):
    icon_name = "cable"

    def __init__(self, view):
        super().__init__(view)
        view.ShapeColor = cable_colour()

    def attach(self, view):
        super().attach(view)
        self._solve_beside()
        self.line = Line()
        view.RootNode.addChild(self.line.node)

    def claimChildren(self):
        """The terminals and supports, and what is drawn from the cable."""
        cable = self.object
        ours = [obj for obj in cable.InList if hasattr(getattr(obj, "Proxy", None), "TABLE")]
        return [obj for obj in (cable.Start, *cable.Supports, cable.End, *ours) if obj]

    @staticmethod
    def _solve_beside():
        """Not at every start of FreeCAD: only where there are cables."""
        from .. import live, progress, worker

        for each in (worker, live, progress):
            each.install()

    def make_panel(self):
        from ..panels.cable import CablePanel

        return CablePanel(self.object)

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

    def onChanged(self, view, name):
        if name == "Visibility" and not view.Visibility:
            self.rest()

    def follow(self, points):
        """Something moves: the line through ``points`` is where the cable would lie; none if it cannot be said."""
        self._fade(True)
        if points and self.object.ViewObject.Visibility:
            self.line.draw(points)
        else:
            self.line.show(False)

    def rest(self):
        """What is drawn is what is in the document."""
        self.line.show(False)
        self._fade(self._is_old())

    def _fade(self, on):
        self.fade.set(on)
        centreline = getattr(self.object, "Centreline", None)
        # It may be on its way in or out of the document.
        view = getattr(getattr(centreline, "ViewObject", None), "Proxy", None)
        if view is not None:
            view.fade.set(on)

    def _is_old(self):
        return getattr(self.object, "OutOfDate", False)
