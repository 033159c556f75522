# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench. FreeCAD imports this file at every start, so it brings in nothing heavy."""

import FreeCADGui

from ..document import view_hook
from .icons import FOLDER, icon


def _attach(obj):
    from . import language, views

    language.install()
    views.attach(obj)


# Documents are opened and macros run before anyone uses the workbench.
view_hook.attach = _attach


class CableWorkbench(FreeCADGui.Workbench):
    """Menu and toolbar; the name is also in package.xml."""

    MenuText = "Cable"
    ToolTip = "Flexible cables between connectors, shaped by mechanics"
    Icon = icon("cable_workbench")

    def Initialize(self):
        """FreeCAD calls this when the workbench is first used."""
        from . import language
        from .commands import COMMANDS
        from .preferences import PAGE

        language.install()
        FreeCADGui.addIconPath(FOLDER)
        FreeCADGui.addPreferencePage(PAGE, "Cable")
        for name, command in COMMANDS.items():
            FreeCADGui.addCommand(name, command)
        self.appendToolbar("Cable", list(COMMANDS))
        self.appendMenu("Cable", list(COMMANDS))

    def GetClassName(self):
        return "Gui::PythonWorkbench"
