# SPDX-License-Identifier: LGPL-2.1-or-later
"""The library of cable types among FreeCAD's materials, from FreeCAD 1.0 on.

FreeCAD reads from its parameters where the cards of a module are, so that is written at every start: the folder may
have moved. Nothing else is imported here.
"""

import os

import FreeCAD

PARAMETERS = "User parameter:BaseApp/Preferences/Mod/Material/Resources/Modules/Cable"

RESOURCES = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", "..", "resources"))


def register():
    """Tell FreeCAD where the cards and their model are, if it has such a library."""
    if int(FreeCAD.Version()[0]) < 1:
        return
    stored = FreeCAD.ParamGet(PARAMETERS)
    for name, *place in (
        ("ModuleDir", "material_cards"),
        ("ModuleModelDir", "material_models"),
        ("ModuleIcon", "icons", "cable_type.svg"),
    ):
        stored.SetString(name, os.path.join(RESOURCES, *place))
    stored.SetBool("ModuleReadOnly", True)
