# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands. Each writes what a macro would write, as one step of undo."""

import FreeCAD
import FreeCADGui

from ..errors import CableError
from .icons import icon
from .selection import picked


class Command:
    """What the commands share; a command says what it needs and which lines it writes."""

    menu_text = tooltip = pixmap = ""

    def lines(self, picks):
        """The macro for what is selected, or None if the command cannot use it."""
        raise NotImplementedError

    def GetResources(self):
        return {"MenuText": self.menu_text, "ToolTip": self.tooltip, "Pixmap": icon(self.pixmap)}

    def IsActive(self):
        return FreeCAD.ActiveDocument is not None and self.lines(picked()) is not None

    def Activated(self):
        document = FreeCAD.ActiveDocument
        lines = self.lines(picked())
        document.openTransaction(self.menu_text)
        try:
            FreeCADGui.doCommand("from freecad_cable.document import make")
            for line in (*lines, "App.ActiveDocument.recompute()"):
                FreeCADGui.doCommand(line)
        except CableError as error:
            document.abortTransaction()
            FreeCAD.Console.PrintError(f"{self.menu_text}: {error}\n")
        except BaseException:
            document.abortTransaction()
            raise
        else:
            document.commitTransaction()


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
            return [
                f"start = {ends[0]}",
                f"end = {ends[1]}",
                "cable = make.cable(App.ActiveDocument, start=start, end=end)",
            ]
        return None


class RouteCommand(Command):
    menu_text = "Comparison Route"
    tooltip = "Draws a curve without mechanics beside the selected cable, to compare with"
    pixmap = "cable_route"

    def lines(self, picks):
        cables = [_existing(p, "Cable") for p in picks]
        if len(cables) == 1 and cables[0]:
            return [f"make.route(App.ActiveDocument, {cables[0]})"]
        return None


def _terminal(pick):
    return f"make.terminal(App.ActiveDocument, ({_named(pick.root)}, {pick.path!r}))"


def _existing(pick, proxy):
    return _named(pick.object) if pick.has_proxy(proxy) else None


def _named(obj):
    return f"App.getDocument({obj.Document.Name!r}).getObject({obj.Name!r})"


COMMANDS = {
    "Cable_Terminal": TerminalCommand(),
    "Cable_Cable": CableCommand(),
    "Cable_Route": RouteCommand(),
}
"""Name in FreeCAD: command, in the order of menu and toolbar."""
