# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tells FreeCAD where our translations are."""

import os
from functools import cache

import FreeCADGui

from .icons import FOLDER


@cache
def install():
    """Once, and no later than the first of our objects is seen: nobody has to use the workbench for that."""
    FreeCADGui.addLanguagePath(os.path.abspath(os.path.join(FOLDER, "..", "translations")))
    FreeCADGui.updateLocale()
