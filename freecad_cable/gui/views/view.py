# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the views share."""

from ..icons import icon


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

    def getIcon(self):
        return icon(self.icon_name)

    # FreeCAD up to 0.21 asks for the state by one pair of names, later by the other.
    def dumps(self):
        return None

    def loads(self, state):
        pass

    __getstate__ = dumps
    __setstate__ = loads
