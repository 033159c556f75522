# SPDX-License-Identifier: LGPL-2.1-or-later
"""Do the steps of docs/guide.md in FreeCAD's window and take a picture of each.

    xvfb-run -a -s "-screen 0 1440x900x24" freecad docs/pictures/guide.py

Runs in the folder of the checkout, of an installed add-on.
"""

import sys
import tempfile

import FreeCADGui
from PySide import QtCore, QtGui

sys.path += ["docs/pictures", "tests/gui"]
from guide_steps import Hand
from taking import rest, take, wait

PICTURES = "docs/pictures/guide"
WIDTH = 380
"""of tree and properties [pixels]"""


def picture():
    window = FreeCADGui.getMainWindow()
    window.showFullScreen()
    FreeCADGui.activateWorkbench("CableWorkbench")
    window.findChild(QtGui.QDockWidget, "Report view").hide()

    def look(name):
        if dock := window.findChild(QtGui.QDockWidget, "Combo View"):
            window.resizeDocks([dock], [WIDTH], QtCore.Qt.Horizontal)
        wait()
        window.screen().grabWindow(window.winId()).save(f"{PICTURES}/{name}.png")

    with tempfile.TemporaryDirectory() as folder:
        found = Hand(look, rest, folder).do()
    print(found, file=sys.__stdout__)


take(picture)
