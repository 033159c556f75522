# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the panels of terminals and supports share: where they stand, and what they exert on a cable."""

import FreeCAD
from FreeCAD import Placement, Vector
from PySide import QtGui

from ...document.reference import pairs
from ..selection import has_proxy, picked
from .inputs import Input, Number
from .panel import Panel

translate = FreeCAD.Qt.translate


class Reference(Input):
    """Says where something stands, and takes the selection instead."""

    def __init__(self, obj):
        super().__init__(obj, "Reference", QtGui.QWidget())
        self.said = QtGui.QLabel()
        self.said.setWordWrap(True)
        # Held here: whoever looks a widget up in the window becomes what holds it for PySide 6.11, which then crashes
        # when the panel is closed.
        self.button = QtGui.QPushButton(translate("Cable", "Take the Selection"))
        self.button.setObjectName("TakeSelection")
        self.button.setToolTip(translate("Cable", "Stand at the edge, face or vertex selected now"))
        self.button.clicked.connect(self.take)
        row = QtGui.QHBoxLayout(self.widget)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(self.said, 1)
        row.addWidget(self.button)
        self.show()

    def take(self):
        found = [each for each in picked() if each.element and each.object is not self.obj]
        if found:
            self._change([(each.root, each.path) for each in found])

    def _show(self, value):
        names = [f"{obj.Label} {path.rpartition('.')[2]}".strip() for obj, path in pairs(value)]
        self.said.setText(", ".join(names) or translate("Cable", "nowhere"))


class Component(Number):
    """One of the three lengths of a placement."""

    def __init__(self, obj, name, axis):
        self.axis = axis
        super().__init__(obj, name, "mm", path=f"{name}.Base.{axis}")

    def _show(self, value):
        super()._show(getattr(value.Base, self.axis))

    def _change(self, value):
        now = getattr(self.obj, self.name)
        base = Vector(now.Base)
        if abs(getattr(base, self.axis) - value) > 1e-12 * (1 + abs(value)):
            setattr(base, self.axis, value)
            setattr(self.obj, self.name, Placement(base, now.Rotation))


class AttachedPanel(Panel):
    """Base of both."""

    def add_roll(self):
        roll = Number(self.object, "Roll", "deg", step=5.0)
        self.add_with_slider(translate("Cable", "Roll"), roll, -180.0, 180.0)

    def add_offset(self):
        box = QtGui.QWidget()
        column = QtGui.QVBoxLayout(box)
        column.setContentsMargins(0, 0, 0, 0)
        for axis in "xyz":
            made = Component(self.object, "Offset", axis)
            self.inputs.append(made)
            column.addWidget(made.widget)
        self.rows.addRow(translate("Cable", "Offset"), box)

    def cables(self):
        obj = self.object
        return [
            each
            for each in obj.InList
            if has_proxy(each, "Cable") and obj in (each.Start, each.End, *each.Supports)
        ]

    def load(self, cable):
        """Force [N] and moment [N m] of the object on a cable."""
        raise NotImplementedError

    def more(self, cable):
        force, moment = self.load(cable)
        yield translate("Cable", "Force on the cable"), f"{force.Length:.3g} N"
        yield translate("Cable", "Moment on the cable"), f"{moment.Length:.3g} N m"
