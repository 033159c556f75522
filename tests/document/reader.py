# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a cable of a file says, read in a process of its own: run by FreeCAD, not imported.

Takes the file from CABLE_FILE and writes its observations as JSON to CABLE_SEEN. CasADi is not there.
"""

import json
import os
import sys

import FreeCAD


class NoCasadi:
    """As on a machine where CasADi is not installed."""

    @staticmethod
    def find_spec(name, path=None, target=None):
        if name.split(".")[0] == "casadi":
            raise ModuleNotFoundError("No module named 'casadi'", name="casadi")


def seen(cable):
    """Everything a cable shows and keeps, as plain data."""
    said = {"State": cable.State, "Volume": None if cable.Shape.isNull() else cable.Shape.Volume}
    for prop in cable.Proxy.TABLE:
        said[prop.name] = plain(getattr(cable, prop.name))
    return said


def plain(value):
    if hasattr(value, "TypeId") and hasattr(value, "Name"):
        return value.Name
    if isinstance(value, FreeCAD.Vector):
        return list(value)
    if isinstance(value, FreeCAD.Units.Quantity):
        return value.Value
    return [plain(item) for item in value] if isinstance(value, (list, tuple)) else value


def observe(path):
    document = FreeCAD.openDocument(path)
    cable, route = document.Cable, document.Route
    observed = {"opened": seen(cable), "modules": sorted(m for m in sys.modules if "casadi" in m)}
    observed["type"] = {
        name: getattr(document.CableType, name).UserString
        for name in ("MassPerLength", "BendingStiffness")
    }
    for obj in document.Objects:
        obj.touch()
    document.recompute()
    observed["recomputed"] = seen(cable)
    cable.Length = "310 mm"
    document.recompute()
    observed["edited"] = seen(cable)
    observed["message"] = cable.getStatusString()
    observed["route"] = [route.Length.Value, route.Shape.Length, route.Status]
    return observed


if "CABLE_SEEN" in os.environ:
    sys.meta_path.insert(0, NoCasadi)
    with open(os.environ["CABLE_SEEN"], "w", encoding="utf-8") as file:
        json.dump(observe(os.environ["CABLE_FILE"]), file)
