# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of a cable."""

import FreeCAD

from ..selection import has_proxy
from .inputs import Check, Choice, Link, Number
from .panel import Panel
from .supports import Supports

translate = FreeCAD.Qt.translate

TAUTEST, SLACKEST = 1.001, 2.0
"""Length at the ends of the slider, over the straight way."""

MOST_SLACK = 1.0
"""at the end of the slider"""


class CablePanel(Panel):
    icon_name = "cable"

    def fill(self):
        cable = self.object
        types = [obj for obj in self.document.Objects if has_proxy(obj, "CableType")]
        self.add(translate("Cable", "Cable type"), Link(cable, "CableType", types))
        supports = self.add(translate("Cable", "Supports"), Supports(cable))
        self.rows.addRow(supports.buttons)
        modes = {
            "Fixed": translate("Cable", "Given"),
            "Slack": translate("Cable", "From the slack"),
            "Shortest": translate("Cable", "Shortest that will do"),
        }
        self.add(translate("Cable", "Length"), Choice(cable, "LengthMode", modes))
        self.length = Number(cable, "Length", "mm", least=0.0)
        self.length_slider = self.add_with_slider("", self.length, *self._lengths())
        self.slack = Number(cable, "Slack", "", step=0.01, least=0.0)
        self.slack_slider = self.add_with_slider("", self.slack, 0.0, MOST_SLACK)
        radius = {
            "Check": translate("Cable", "Check"),
            "Enforce": translate("Cable", "Form the cable so that it is kept"),
        }
        self.add(translate("Cable", "Bend radius"), Choice(cable, "BendRadiusMode", radius))
        self.add(translate("Cable", "Clearance"), Number(cable, "Clearance", "mm", least=0.0))
        updates = {
            "Manual": translate("Cable", "When asked to"),
            "On recompute": translate("Cable", "With the document"),
            "Live": translate("Cable", "Always, while parts move"),
        }
        self.add(translate("Cable", "Solve"), Choice(cable, "Update", updates))
        marked = {
            "ColourByBendRadius": translate("Cable", "Colour by bend radius"),
            "ShowTightest": translate("Cable", "Mark the tightest place"),
            "ShowForces": translate("Cable", "Show forces"),
            "ShowContacts": translate("Cable", "Mark contacts"),
        }
        for name, text in marked.items():
            self.add("", Check(cable.ViewObject, name, text))

    def cables(self):
        return [self.object]

    def more(self, cable):
        for end in ("Start", "End"):
            force = getattr(cable, f"{end}Force").Length
            moment = getattr(cable, f"{end}Moment").Length
            text = {
                "Start": translate("Cable", "Force and moment at the start"),
                "End": translate("Cable", "Force and moment at the end"),
            }
            yield text[end], f"{force:.3g} N, {moment:.3g} N m"

    def adapt(self):
        mode = self.object.LengthMode
        for made, on in (
            (self.length, mode == "Fixed"),
            (self.length_slider, mode == "Fixed"),
            (self.slack, mode == "Slack"),
            (self.slack_slider, mode == "Slack"),
        ):
            self.show_row(made, on)

    def _lengths(self):
        """Ends of the slider [mm]."""
        cable = self.object
        now = cable.Length.Value
        held = [obj for obj in (cable.Start, *cable.Supports, cable.End) if obj]
        if len(held) < 2 or any(getattr(obj, "Condition", "") == "Free" for obj in held):
            return now / 2, 2 * now
        places = [obj.Frame.Base for obj in held]
        way = sum(a.distanceToPoint(b) for a, b in zip(places, places[1:], strict=False))
        return TAUTEST * way, max(SLACKEST * way, 1.5 * now)
