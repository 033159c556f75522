# SPDX-License-Identifier: LGPL-2.1-or-later
"""The equipment panel with its cables in a new document, for who wants to see what the workbench does."""

import FreeCAD

from . import equipment
from .appearance import seen


def make_document():
    """A new document with the panel, its ten cables and their spline routes, computed; returns it. Errors:
    ``CableError``."""
    document = FreeCAD.newDocument("Equipment")
    for _ in equipment.build(document):
        pass
    document.recompute()
    if FreeCAD.GuiUp:
        for obj, colours in seen(document):
            for name, colour in colours.items():
                setattr(obj.ViewObject, name, _rgb(colour))
    return document


def _rgb(colour):
    return tuple(int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5))
