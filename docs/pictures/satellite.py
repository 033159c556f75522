# SPDX-License-Identifier: LGPL-2.1-or-later
"""Take the pictures of the satellite for the README, from the document that ``./run demo`` wrote.

    xvfb-run -a -s "-screen 0 1440x900x24" freecad docs/pictures/satellite.py

Runs in the folder of the checkout, of an installed add-on. All of it, and one cable beside its spline route: through a
hole, along the floor, in a P-clip.
"""

import os
import sys
import time
import traceback

import FreeCAD
import FreeCADGui
from PySide import QtCore

STORED = "demo-output/satellite.FCStd"

CABLE = "W5"
"""of the close-up"""

SEEN_THROUGH = {"Web": 75, "Deck": 80, "Back": 60, "Floor": 0}
"""Transparency of the plates [%]."""

SPLINE = (0.85, 0.1, 0.1)

SIZE = 1440, 900


def picture():
    FreeCADGui.activateWorkbench("CableWorkbench")
    document = FreeCAD.openDocument(STORED)
    wait()
    for obj in document.Objects:
        view = obj.ViewObject
        if obj.Label in SEEN_THROUGH:
            view.Transparency = SEEN_THROUGH[obj.Label]
        if obj.Name.startswith("Route"):
            view.LineWidth, view.LineColor = 3, SPLINE
    look(-28, 62)
    FreeCADGui.SendMsgToActiveView("ViewFit")
    save("docs/pictures/satellite.png")
    for obj in document.Objects:
        mine = CABLE in (obj.Label, getattr(getattr(obj, "Cable", None), "Label", ""))
        if obj.Name.startswith(("Cable", "Route")) and not obj.Name.startswith("CableType"):
            obj.ViewObject.Visibility = mine
    look(-20, 72)
    camera = FreeCADGui.activeView().getCameraNode()
    camera.height = 330
    save("docs/pictures/satellite-cable.png")


def look(around, tilt):
    """From above the floor: degrees about the upright axis, and from looking down to looking ahead."""
    turn = FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), around)
    view = FreeCADGui.activeView()
    view.setCameraOrientation(turn * FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), tilt))


def save(path):
    wait()
    FreeCADGui.activeView().saveImage(path, *SIZE, "White")


def wait(seconds=2):
    """Let the window draw itself."""
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        FreeCADGui.updateGui()


def run():
    status = 0
    try:
        picture()
    except Exception:  # noqa: BLE001 - becomes the exit code
        traceback.print_exc(file=sys.__stdout__)
        status = 1
    sys.__stdout__.flush()
    os._exit(status)


# When the window is up.
QtCore.QTimer.singleShot(2000, run)
