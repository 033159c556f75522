# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of clamps, sleeves, rings and clips."""

import FreeCAD
from FreeCAD import Vector

from .attached import AttachedPanel, Reference
from .inputs import Check, Number

translate = FreeCAD.Qt.translate

LONGEST = 1000.0
"""[mm] End of the slider of the position, if no cable says more."""


class SupportPanel(AttachedPanel):
    def __init__(self, obj):
        self.icon_name = f"cable_{type(obj.Proxy).__name__.lower()}"
        super().__init__(obj)

    def fill(self):
        support = self.object
        has = support.PropertiesList
        self.add(translate("Cable", "Stands at"), Reference(support))
        text = translate("Cable", "The cable slides through")
        self.add("", Check(support, "Slides", text))
        lengths = [cable.SolvedLength.Value for cable in self.cables()]
        self.position = Number(support, "Position", "mm", least=0.0)
        self.slider = self.add_with_slider(
            translate("Cable", "Position along the cable"),
            self.position,
            0.0,
            max(lengths, default=0) or LONGEST,
        )
        if "Radius" in has:
            self.radius = self.add(
                translate("Cable", "Radius"), Number(support, "Radius", "mm", least=0.0)
            )
            self.add(translate("Cable", "Clearance"), Number(support, "Clearance", "mm", least=0.0))
        if "Reverse" in has:
            text = translate("Cable", "Let the cable pass the other way")
            self.add("", Check(support, "Reverse", text))
        if "Roll" in has:
            self.add_roll()
        self.add_offset()

    def adapt(self):
        for made in (self.position, self.slider):
            self.show_row(made, not self.object.Slides)
        if "Radius" in self.object.PropertiesList:
            # That of a circle is not to be chosen.
            self.radius.widget.setReadOnly("ReadOnly" in self.object.getEditorMode("Radius"))

    def load(self, cable):
        place = cable.Supports.index(self.object)
        loads = cable.SupportForces, cable.SupportMoments
        # One that was put among the others since has none yet.
        return [each[place] if place < len(each) else Vector() for each in loads]
