# SPDX-License-Identifier: LGPL-2.1-or-later
"""Take the pictures of the satellite for the README, from the document that ``./run demo`` wrote.

    xvfb-run -a -s "-screen 0 1440x900x24" freecad docs/pictures/satellite.py

Runs in the folder of the checkout, of an installed add-on. All of it, and one cable beside its spline route: through a
hole, along the floor, in a P-clip.
"""

import sys

import FreeCAD
import FreeCADGui

sys.path.insert(0, "docs/pictures")
from taking import take, wait

STORED = "demo-output/satellite.FCStd"

CABLE = "W5"
"""of the close-up"""

SEEN_THROUGH = {"Web": 75, "Deck": 80, "Back": 60, "Floor": 50}
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
            view.LineWidth, view.LineColor = 4, SPLINE
    look(FreeCAD.Vector(55, 0, 158), -28, 62, 640)
    save("docs/pictures/satellite.png")
    for obj in document.Objects:
        if hasattr(obj, "Proxy"):
            obj.ViewObject.Visibility = obj.Label == CABLE or is_its_route(obj)
    look(FreeCAD.Vector(52, -140, 68), -14, 74, 300)
    save("docs/pictures/satellite-cable.png")


def is_its_route(obj):
    return obj.Name.startswith("Route") and obj.Cable.Label == CABLE


def look(at, around, tilt, height):
    """From above the floor: degrees about the upright axis, and from looking down to looking ahead; the ``height`` [mm]
    of what is seen around the point ``at``."""
    turn = FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), around)
    view = FreeCADGui.activeView()
    view.setCameraOrientation(turn * FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), tilt))
    camera = view.getCameraNode()
    camera.height = height
    camera.position = tuple(at - view.getViewDirection() * camera.focalDistance.getValue())


def save(path):
    wait()
    FreeCADGui.activeView().saveImage(path, *SIZE, "White")


take(picture)
