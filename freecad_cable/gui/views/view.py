# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the views share."""

import FreeCADGui

from ..icons import icon
from .overlay import Fade


class View:
    """Base of the views. FreeCAD makes one without ``__init__`` when it opens a file."""

    icon_name = ""
    line_colour = None
    """RGB at the start; None leaves FreeCAD's"""

    def __init__(self, view):
        view.Proxy = self
        if self.line_colour:
            view.LineColor = self.line_colour

    def attach(self, view):
        """FreeCAD calls this when the view gets its object, also on opening."""
        self.object = view.Object
        self.fade = Fade()
        view.RootNode.insertChild(self.fade.node, 0)

    def getIcon(self):
        return icon(self.icon_name)

    def make_panel(self):
        """The task panel that edits the object; None if it has none."""
        return None

    def doubleClicked(self, view):
        if FreeCADGui.Control.activeDialog():
            return False
        return FreeCADGui.getDocument(view.Object.Document.Name).setEdit(view.Object.Name)

    def setEdit(self, view, mode):
        if mode != 0:
            return None  # of FreeCAD itself
        self.panel = self.make_panel()
        if self.panel is None:
            return False
        FreeCADGui.Control.showDialog(self.panel)
        return True

    def unsetEdit(self, view, mode):
        panel, self.panel = getattr(self, "panel", None), None
        if panel is not None and panel.is_open:
            panel.leave()
            FreeCADGui.Control.closeDialog()

    # FreeCAD up to 0.21 asks for the state by one pair of names, later by the other.
    def dumps(self):
        return None

    def loads(self, state):
        pass

    __getstate__ = dumps
    __setstate__ = loads
