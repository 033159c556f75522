# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of a terminal."""

import FreeCAD

from .attached import AttachedPanel, Reference
from .inputs import Check, Choice

translate = FreeCAD.Qt.translate


class TerminalPanel(AttachedPanel):
    icon_name = "cable_terminal"

    def fill(self):
        terminal = self.object
        self.add(translate("Cable", "Stands at"), Reference(terminal))
        held = {
            "Clamped": translate("Cable", "Position and all directions"),
            "Swivel": translate("Cable", "Position and direction; it may twist"),
            "Pinned": translate("Cable", "Position"),
            "Free": translate("Cable", "Nothing"),
        }
        self.add(translate("Cable", "Holds"), Choice(terminal, "Condition", held))
        text = translate("Cable", "Turn the cable into the part")
        self.add("", Check(terminal, "Reverse", text))
        self.add_roll()
        self.add_offset()

    def load(self, cable):
        end = "Start" if cable.Start is self.object else "End"
        return getattr(cable, f"{end}Force"), getattr(cable, f"{end}Moment")
