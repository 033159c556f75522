# SPDX-License-Identifier: LGPL-2.1-or-later
"""Widgets that show a property and change it. An expression on it is shown in the widget, and can be made there."""

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

of_property = FreeCAD.Qt.translate
"""By another name, because the texts are found in the tables of the properties and not here."""

STEPS = 1000
"""of a slider"""


class Input(QtCore.QObject):
    """Base: ``widget`` shows the property ``name`` of ``obj``; ``show`` brings it up to date."""

    def __init__(self, obj, name, widget):
        super().__init__(widget)
        self.obj, self.name, self.widget = obj, name, widget
        widget.setObjectName(name)
        widget.setToolTip(of_property("App::Property", obj.getDocumentationOfProperty(name)))

    def show(self):
        """From the document to the widget, without a word to the document."""
        blocked = self.widget.blockSignals(True)
        self._show(getattr(self.obj, self.name))
        self.widget.blockSignals(blocked)

    def _change(self, value):
        if getattr(self.obj, self.name) != value:
            setattr(self.obj, self.name, value)


class Choice(Input):
    """Of an enumeration; ``texts`` are what a person reads for its values."""

    def __init__(self, obj, name, texts):
        super().__init__(obj, name, _narrow())
        for value in obj.getEnumerationsOfProperty(name):
            self.widget.addItem(texts[value], value)
        self.show()
        self.widget.currentIndexChanged.connect(
            lambda index: self._change(self.widget.itemData(index))
        )

    def _show(self, value):
        self.widget.setCurrentIndex(self.widget.findData(value))


class Check(Input):
    """Of a yes or no."""

    def __init__(self, obj, name, text):
        super().__init__(obj, name, QtGui.QCheckBox(text))
        self.show()
        self.widget.toggled.connect(self._change)

    def _show(self, value):
        self.widget.setChecked(value)


class Link(Input):
    """Of a link to one of ``objects``."""

    def __init__(self, obj, name, objects):
        super().__init__(obj, name, _narrow())
        self.objects = objects
        for each in objects:
            self.widget.addItem(each.Label)
        self.show()
        self.widget.currentIndexChanged.connect(lambda index: self._change(self.objects[index]))

    def _show(self, value):
        self.widget.setCurrentIndex(self.objects.index(value) if value in self.objects else -1)


def _quantity_spin_box():
    """Of FreeCAD. PySide is not told when FreeCAD deletes one: a new one in the same memory is taken for the old one,
    which it calls deleted. The next one lies elsewhere."""
    while True:
        spin = FreeCADGui.UiLoader().createWidget("Gui::QuantitySpinBox")
        try:
            spin.objectName()
        except RuntimeError:
            continue
        return spin


class Number(Input):
    """Of a quantity or a number, with units and expressions; ``unit`` "" for a plain number. ``path`` of what the
    expression gives, if that is a part of the property."""

    def __init__(self, obj, name, unit, *, step=1.0, least=None, path=None):
        spin = _quantity_spin_box()
        super().__init__(obj, name, spin)
        self.path = path or name
        spin.setObjectName(self.path)
        spin.setProperty("unit", unit)
        spin.setProperty("singleStep", step)
        if least is not None:
            spin.setProperty("minimum", least)
        self._binding = FreeCADGui.ExpressionBinding(spin)
        self._binding.bind(obj, self.path)
        self.show()
        # PySide knows it as the plain spin box that it derives from, without this signal.
        QtCore.QObject.connect(spin, QtCore.SIGNAL("valueChanged(double)"), self._typed)

    @property
    def driven(self):
        """Whether an expression decides."""
        return any(path.lstrip(".") == self.path for path, _ in self.obj.ExpressionEngine)

    def _typed(self, value):
        if not self.driven:
            self._change(value)

    def _show(self, value):
        self.widget.setProperty("rawValue", getattr(value, "Value", value))

    def _change(self, value):
        now = getattr(self.obj, self.name)
        if abs(getattr(now, "Value", now) - value) > 1e-12 * (1 + abs(value)):
            setattr(self.obj, self.name, value)


class Slider(Input):
    """Below a number: from ``low`` to ``high``; calls ``pressed`` and ``released``."""

    def __init__(self, number, low, high, pressed, released):
        super().__init__(number.obj, number.name, QtGui.QSlider(QtCore.Qt.Horizontal))
        self.widget.setObjectName(f"{number.name}Slider")
        self.widget.setRange(0, STEPS)
        self.number, self.ends = number, (low, high)
        self.show()
        self.widget.valueChanged.connect(self._slid)
        self.widget.sliderPressed.connect(pressed)
        self.widget.sliderReleased.connect(released)

    def _slid(self, step):
        low, high = self.ends
        self._change(low + (high - low) * step / STEPS)
        self.number.show()

    def _show(self, value):
        value, (low, high) = getattr(value, "Value", value), self.ends
        self.widget.setEnabled(not self.number.driven and high > low)
        if high > low:
            self.widget.setValue(round(STEPS * (value - low) / (high - low)))


def _narrow():
    """A combo box that does not make the panel as wide as its longest entry."""
    box = QtGui.QComboBox()
    box.setSizeAdjustPolicy(QtGui.QComboBox.AdjustToMinimumContentsLengthWithIcon)
    box.setMinimumContentsLength(8)
    return box
