# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user prefers of new cables; the page is ``resources/ui/preferences.ui``.

Commands write it into their macros, so that a macro does the same for everyone; nothing else reads it.
"""

import os

import FreeCAD

from ..document.solving import UPDATES
from ..document.terminal import CONDITIONS
from .macro import named
from .selection import has_proxy

PAGE = os.path.abspath(
    os.path.join(os.path.dirname(__file__), "..", "..", "resources", "ui", "preferences.ui")
)

GROUP = "User parameter:BaseApp/Preferences/Mod/Cable"

SLACK, TOLERANCE = 10.0, 0.01
"""[%] At the start, as on the page and as ``make.cable`` has them."""

UPDATE = UPDATES.index("On recompute")

COLOUR = 0x3C4048FF
"""Red, green, blue, alpha."""


def cable_arguments(document):
    """The keywords of ``make.cable`` for what is not as it is without preferences, as text of a macro."""
    stored = FreeCAD.ParamGet(GROUP)
    slack, tolerance = stored.GetFloat("Slack", SLACK), stored.GetFloat("Tolerance", TOLERANCE)
    update = _chosen(UPDATES, stored.GetInt("Update", UPDATE))
    kind = stored.GetString("CableType").strip()
    arguments = [
        f"cable_type={_type(document, kind)}" if kind else "",
        f"slack={slack / 100:.6g}" if slack != SLACK else "",
        f"tolerance={tolerance / 100:.6g}" if tolerance != TOLERANCE else "",
        f"update={update!r}" if update != UPDATES[UPDATE] else "",
    ]
    return "".join(f", {argument}" for argument in arguments if argument)


def terminal_arguments():
    """The same of ``make.terminal``."""
    condition = _chosen(CONDITIONS, FreeCAD.ParamGet(GROUP).GetInt("Condition", 0))
    return f", condition={condition!r}" if condition != CONDITIONS[0] else ""


def cable_colour():
    """RGB between 0 and 1 of a new cable."""
    packed = FreeCAD.ParamGet(GROUP).GetUnsigned("Colour", COLOUR)
    return tuple((packed >> shift & 0xFF) / 255 for shift in (24, 16, 8))


def _type(document, name):
    """The type of this name: that of the document, or one that is made."""
    types = (obj for obj in document.getObjectsByLabel(name) if has_proxy(obj, "CableType"))
    found = next(types, None)
    return named(found) if found else f"make.cable_type(App.ActiveDocument, {name!r})"


def _chosen(choices, index):
    return choices[min(max(index, 0), len(choices) - 1)]
