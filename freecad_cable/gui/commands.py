# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands."""

import FreeCAD
import FreeCADGui

from . import preferences
from .command import Command
from .macro import named
from .report_commands import ExampleCommand, ReportCommand
from .selection import has_proxy


class TerminalCommand(Command):
    menu_text = "Cable Terminal"
    tooltip = "Holds the end of a cable at the selected edge or face"
    pixmap = "cable_terminal"

    def lines(self, picks):
        if len(picks) == 1 and picks[0].connector:
            return [_terminal(picks[0])]
        return None


class CableCommand(Command):
    menu_text = "Cable"
    tooltip = "Runs a cable between two selected terminals, edges or faces"
    pixmap = "cable"

    def lines(self, picks):
        ends = [_terminal(p) if p.connector else _existing(p, "Terminal") for p in picks]
        if len(ends) == 2 and all(ends):
            given = preferences.cable_arguments(FreeCAD.ActiveDocument)
            return [
                f"start = {ends[0]}",
                f"end = {ends[1]}",
                f"cable = make.cable(App.ActiveDocument, start=start, end=end{given})",
            ]
        return None

    def finish(self, document):
        """Its panel opens; what is done there is the same step of undo."""
        cable = [obj for obj in document.Objects if has_proxy(obj, "Cable")][-1]
        if not FreeCADGui.getDocument(document.Name).setEdit(cable.Name):
            document.commitTransaction()


class SupportCommand(Command):
    """A support on the picked edge or face, and in its place along a picked cable."""

    def __init__(self, kind, holds):
        self.kind = kind.lower()
        self.menu_text = kind
        self.tooltip = f"{holds} at the selected edge or face, on the way of the cable that is selected with it"
        self.pixmap = f"cable_{self.kind}"

    def lines(self, picks):
        places = [p for p in picks if p.connector]
        cables = [_existing(p, "Cable") for p in picks if not p.connector]
        if len(places) != 1 or len(cables) > 1 or not all(cables):
            return None
        reference = f"({named(places[0].root)}, {places[0].path!r})"
        # Whoever wants it at a certain length of the cable gives it a position afterwards.
        made = f"support = make.{self.kind}(App.ActiveDocument, {reference}, slides=True"
        if not cables:
            return [f"{made})"]
        return [
            f"cable = {cables[0]}",
            f"{made}, inside=cable.getParentGeoFeatureGroup())",
            "make.hold(cable, support)",
        ]


class RouteCommand(Command):
    menu_text = "Comparison Route"
    tooltip = "Draws a curve without mechanics beside the selected cable, to compare with"
    pixmap = "cable_route"

    def lines(self, picks):
        cable = _only_cable(picks)
        return cable and [f"make.route(App.ActiveDocument, {cable})"]


class ShortestCommand(Command):
    menu_text = "Shortest Length"
    tooltip = "Gives the selected cable the least length that keeps its bend radius and clearance"
    pixmap = "cable_shortest"

    def lines(self, picks):
        cable = _only_cable(picks)
        return cable and [f"{cable}.LengthMode = 'Shortest'"]


class StudyCommand(Command):
    menu_text = "Study"
    tooltip = "Makes a study of the selected cable, or runs the one that is selected"
    pixmap = "cable_study"

    def lines(self, picks):
        if len(picks) != 1:
            return None
        if study := _existing(picks[0], "Study"):
            return ["from freecad_cable.document import studying", f"studying.run({study})"]
        cable = _existing(picks[0], "Cable")
        return cable and [
            "from freecad_cable.document import studying",
            f"cable = {cable}",
            "study = make.study(App.ActiveDocument, cable, varied='Length', "
            "start=cable.SolvedLength.Value, stop=1.2 * cable.SolvedLength.Value)",
            "studying.run(study)",
        ]


class InterferenceCommand(Command):
    menu_text = "Check All"
    tooltip = "Lists what the cables come near to: solids and each other, with distances and places"
    pixmap = "cable_check"

    def lines(self, picks):
        if not any(has_proxy(obj, "Cable") for obj in FreeCAD.ActiveDocument.Objects):
            return None
        return [
            "from freecad_cable.document import interference",
            "App.ActiveDocument.recompute()",
            "rows = interference.report(App.ActiveDocument)",
            "interference.sheet(App.ActiveDocument, rows)",
        ]


def _terminal(pick):
    place = f"({named(pick.root)}, {pick.path!r})"
    return f"make.terminal(App.ActiveDocument, {place}{preferences.terminal_arguments()})"


def _only_cable(picks):
    """The cable that is picked, alone, or None."""
    return _existing(picks[0], "Cable") if len(picks) == 1 else None


def _existing(pick, proxy):
    return named(pick.object) if has_proxy(pick.object, proxy) else None


COMMANDS = {
    "Cable_Terminal": TerminalCommand(),
    "Cable_Cable": CableCommand(),
    "Cable_Clamp": SupportCommand("Clamp", "Holds a cable and keeps it from twisting"),
    "Cable_Sleeve": SupportCommand("Sleeve", "Guides a cable in a direction and lets it twist"),
    "Cable_Ring": SupportCommand("Ring", "Leads a cable through a round hole"),
    "Cable_Clip": SupportCommand("Clip", "Grips a cable and lets it twist"),
    "Cable_Shortest": ShortestCommand(),
    "Cable_Route": RouteCommand(),
    "Cable_Study": StudyCommand(),
    "Cable_Check": InterferenceCommand(),
    "Cable_Report": ReportCommand(),
    "Cable_Example": ExampleCommand(),
}
"""Name in FreeCAD: command, in the order of menu and toolbar."""
