# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the icons are."""

import os

# Not from __file__ of InitGui.py: FreeCAD executes it without one.
FOLDER = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", "..", "resources", "icons"))


def icon(name):
    """Absolute path of an icon, by its name without ending."""
    return os.path.join(FOLDER, f"{name}.svg")
