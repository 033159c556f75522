# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the commands share: each writes what a macro would write, as one step of undo."""

import FreeCAD
import FreeCADGui

from ..document.sentences import in_language
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
        # Under an open panel a command would end its step of undo.
        if FreeCAD.ActiveDocument is None or FreeCADGui.Control.activeDialog():
            return False
        return self.lines(picked()) is not None

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
            FreeCAD.Console.PrintError(f"{self.menu_text}: {in_language(str(error))}\n")
        except BaseException:
            document.abortTransaction()
            raise
        else:
            self.finish(document)

    def finish(self, document):
        """The lines have run."""
        document.commitTransaction()
