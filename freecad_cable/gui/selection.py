# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is selected, in the words of this add-on."""

from typing import NamedTuple

import FreeCADGui


class Picked(NamedTuple):
    """One thing the user picked: an object of the top level and the way down from it."""

    root: object
    path: str
    """``Part.Box.Face6``: names of objects, then of the edge or face if one was picked"""

    @property
    def object(self):
        """The object picked, or to which the picked edge or face belongs."""
        return self.root.getSubObject(self.path, retType=1) or self.root

    @property
    def element(self):
        """``Edge1``, ``Face6`` …, or empty if a whole object was picked."""
        return self.path.rpartition(".")[2]

    @property
    def connector(self):
        """Whether a terminal can sit here; in the view, edges and faces of our own objects are picked too."""
        ours = hasattr(getattr(self.object, "Proxy", None), "TABLE")
        return self.element.startswith(("Edge", "Face")) and not ours


def has_proxy(obj, name):
    """Whether an object is one of ours, by the name of its proxy's class."""
    return type(getattr(obj, "Proxy", None)).__name__ == name


def picked():
    """Everything selected, in the order of picking. Paths are not resolved: through links and
    containers, only the whole path says which instance of a part was meant."""
    return [
        Picked(entry.Object, path)
        for entry in FreeCADGui.Selection.getSelectionEx("*", 0)
        for path in entry.SubElementNames or ("",)
    ]
