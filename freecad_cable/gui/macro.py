# SPDX-License-Identifier: LGPL-2.1-or-later
"""Macro lines that say what a person did in the window."""

import FreeCAD
from FreeCAD import Units


def named(obj):
    """An object, whatever document is active."""
    return f"App.getDocument({obj.Document.Name!r}).getObject({obj.Name!r})"


def assignment(obj, name):
    """The line that gives a property its value; empty if an expression does."""
    if any(path.lstrip(".") == name for path, _ in obj.ExpressionEngine):
        return ""
    return f"{named(obj)}.{name} = {_literal(getattr(obj, name))}"


def _literal(value):
    if isinstance(value, Units.Quantity):
        return repr(value.Value)
    if isinstance(value, FreeCAD.Vector):
        return f"App.Vector({', '.join(map(repr, value))})"
    if isinstance(value, FreeCAD.Placement):
        turn = ", ".join(map(repr, value.Rotation.Q))
        return f"App.Placement({_literal(value.Base)}, App.Rotation({turn}))"
    if hasattr(value, "TypeId") and hasattr(value, "Name"):
        return named(value)
    if isinstance(value, (list, tuple)):
        inside = ", ".join(map(_literal, value))
        return f"({inside},)" if isinstance(value, tuple) else f"[{inside}]"
    return repr(value)
