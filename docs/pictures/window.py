# SPDX-License-Identifier: LGPL-2.1-or-later
"""Take the picture of FreeCAD's window for the README, with the equipment that ``./run demo`` wrote.

    xvfb-run -a -s "-screen 0 1440x900x24" freecad docs/pictures/window.py

Runs in the folder of the checkout, of an installed add-on.
"""

import sys

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

sys.path.insert(0, "docs/pictures")
from taking import take, wait

STORED = "demo-output/equipment.FCStd"
PICTURE = "docs/pictures/window.png"

CABLE = "W3"
"""is selected."""

WIDTH = 380
"""of tree and properties [pixels]"""

AROUND = FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 28)
TILT = FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), 62)


def picture():
    window = FreeCADGui.getMainWindow()
    window.showFullScreen()
    FreeCADGui.activateWorkbench("CableWorkbench")
    window.findChild(QtGui.QDockWidget, "Report view").hide()
    combo = window.findChild(QtGui.QDockWidget, "Combo View")
    window.resizeDocks([combo], [WIDTH], QtCore.Qt.Horizontal)
    document = FreeCAD.openDocument(STORED)
    wait()
    view = FreeCADGui.activeView()
    view.setCameraOrientation(AROUND * TILT)
    FreeCADGui.activeView().fitAll()
    FreeCADGui.runCommand("Std_ViewZoomIn")
    FreeCADGui.Selection.addSelection(document.getObjectsByLabel(CABLE)[0])
    wait()
    for tree in combo.findChildren(QtGui.QTreeWidget):
        for item in tree.findItems(CABLE, QtCore.Qt.MatchExactly | QtCore.Qt.MatchRecursive):
            item.setExpanded(True)
    for properties in combo.findChildren(QtGui.QTreeView):
        if properties.isVisible() and "PropertyEditor" in properties.metaObject().className():
            properties.setColumnWidth(0, WIDTH // 2)
            properties.verticalScrollBar().setValue(properties.verticalScrollBar().maximum())
    wait()
    window.screen().grabWindow(window.winId()).save(PICTURE)


take(picture)
