# SPDX-License-Identifier: LGPL-2.1-or-later
"""What holds a cable on its way, as a list that can be put into another order."""

import FreeCAD
from PySide import QtCore, QtGui

from ...document import make
from ...document.proxy import proxy_of
from ...document.support import Support
from ..selection import picked
from .inputs import Input

translate = FreeCAD.Qt.translate

MOST_ROWS = 4
"""shown at a time: more would leave no room for the verdict"""


class Supports(Input):
    """Of the supports of a cable, in order along it."""

    def __init__(self, cable):
        super().__init__(cable, "Supports", QtGui.QListWidget())
        self.up = _button("SupportUp", lambda: self._move(-1))
        self.up.setArrowType(QtCore.Qt.UpArrow)
        self.up.setToolTip(translate("Cable", "Nearer to the start of the cable"))
        self.down = _button("SupportDown", lambda: self._move(1))
        self.down.setArrowType(QtCore.Qt.DownArrow)
        self.down.setToolTip(translate("Cable", "Nearer to the end of the cable"))
        self.remove = _button("SupportRemove", self._remove)
        self.remove.setText(translate("Cable", "Remove"))
        passed = translate("Cable", "The cable passes it by; it stays in the document")
        self.remove.setToolTip(passed)
        self.add = _button("SupportAdd", self._add)
        self.add.setText(translate("Cable", "Add the Selection"))
        led = translate("Cable", "Lead the cable through the supports selected now")
        self.add.setToolTip(led)
        self.buttons = QtGui.QHBoxLayout()
        for button in (self.up, self.down, self.remove, self.add):
            self.buttons.addWidget(button)
        self.buttons.addStretch()
        self.widget.currentRowChanged.connect(self._enable)
        self.show()

    def _show(self, supports):
        labels = [support.Label for support in supports]
        if labels != [self.widget.item(row).text() for row in range(self.widget.count())]:
            row = self.widget.currentRow()
            self.widget.clear()
            self.widget.addItems(labels)
            self.widget.setCurrentRow(min(row, len(labels) - 1))
        rows = min(max(len(labels), 1), MOST_ROWS)
        self.widget.setFixedHeight(rows * self.widget.fontMetrics().lineSpacing() + 8)
        self._enable()

    def _enable(self, row=None):
        row, last = self.widget.currentRow(), self.widget.count() - 1
        self.up.setEnabled(row > 0)
        self.down.setEnabled(0 <= row < last)
        self.remove.setEnabled(row >= 0)

    def _move(self, by):
        row, order = self.widget.currentRow(), list(self.obj.Supports)
        order.insert(row + by, order.pop(row))
        self._change(order)
        self.show()
        self.widget.setCurrentRow(row + by)

    def _remove(self):
        order = list(self.obj.Supports)
        del order[self.widget.currentRow()]
        self._change(order)
        self.show()

    def _add(self):
        """Each in its place along the cable as it lies now."""
        for support in dict.fromkeys(pick.object for pick in picked()):
            if proxy_of(support, Support) and support not in self.obj.Supports:
                make.hold(self.obj, support)
        self.show()


def _button(name, pressed):
    """A narrow one: the panel is to stay as wide as it is."""
    button = QtGui.QToolButton()
    button.setObjectName(name)
    button.clicked.connect(lambda checked=False: pressed())
    return button
