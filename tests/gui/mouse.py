# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mouse on the 3D view of the active document."""

import FreeCADGui
from PySide import QtCore, QtGui

NONE, LEFT = QtCore.Qt.NoButton, QtCore.Qt.LeftButton


class Mouse:
    def __init__(self):
        self.view = FreeCADGui.activeView()
        self.widget = self.view.graphicsView().viewport()

    def at(self, point):
        """Where a point of the document [mm] is on the widget [pixels]."""
        x, y = self.view.getPointOnScreen(point)
        ratio = self.widget.devicePixelRatioF()
        return QtCore.QPointF(x / ratio, self.widget.height() - 1 - y / ratio)

    def move(self, place, held=NONE):
        self._send(QtCore.QEvent.MouseMove, place, NONE, held)

    def press(self, place):
        self._send(QtCore.QEvent.MouseButtonPress, place, LEFT, LEFT)

    def release(self, place):
        self._send(QtCore.QEvent.MouseButtonRelease, place, LEFT, NONE)

    def _send(self, kind, place, button, held):
        outside = QtCore.QPointF(self.widget.mapToGlobal(place.toPoint()))
        event = QtGui.QMouseEvent(kind, place, place, outside, button, held, QtCore.Qt.NoModifier)
        QtGui.QApplication.sendEvent(self.widget, event)
