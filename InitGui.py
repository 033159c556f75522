# SPDX-License-Identifier: LGPL-2.1-or-later
# FreeCAD runs this file at every start, without the scope of a module.

import FreeCADGui

from freecad_cable.gui.workbench import CableWorkbench

FreeCADGui.addWorkbench(CableWorkbench())
