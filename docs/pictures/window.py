# SPDX-License-Identifier: LGPL-2.1-or-later
"""Take the pictures of FreeCAD's window for the README, of what ``./run demo`` wrote.

    CABLE_DEMO_FOLDER=demo-output xvfb-run -a -s "-screen 0 1280x800x24" freecad docs/pictures/window.py

The add-on has to be installed; it writes into the folder where this file is.
"""

import os
import sys
import traceback

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

HERE = os.path.dirname(os.path.abspath(sys.argv[-1]))


def colour(hexadecimal):
    return tuple(int(hexadecimal[k : k + 2], 16) / 255 for k in (1, 3, 5))


def show():
    from freecad_cable.demo.pictures import COLOURS

    document = FreeCAD.openDocument(os.path.join(os.environ["CABLE_DEMO_FOLDER"], "equipment.FCStd"))
    for obj in document.Objects:
        view, kind = obj.ViewObject, type(getattr(obj, "Proxy", None)).__name__
        if obj.TypeId.startswith("App::") and obj.TypeId != "App::Part":
            view.Visibility = False
        elif kind in ("Terminal", "Centreline"):
            view.Visibility = False
        elif obj.TypeId == "Part::Feature":
            print(view.Visibility, obj.Visibility, file=sys.__stdout__); view.Visibility = True
            view.ShapeColor, view.LineColor, view.LineWidth = colour("#c3ccd4"), colour("#7d8892"), 1
    cables = [obj for obj in document.Objects if type(getattr(obj, "Proxy", None)).__name__ == "Cable"]
    print(len(cables), file=sys.__stdout__)


def main():
    show()
    view = FreeCADGui.activeView()
    view.viewIsometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    view.saveImage(os.path.join(HERE, "x.png"), 1200, 800, "White")


def run():
    status = 0
    try:
        main()
    except Exception:
        traceback.print_exc(file=sys.__stdout__)
        status = 1
    sys.__stdout__.flush()
    os._exit(status)


QtCore.QTimer.singleShot(2000, run)
