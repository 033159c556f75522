# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the objects of the document look in tree and window.

Written into users' files, like the proxies: modules and classes here may not be renamed.
"""

from .cable import CableView
from .cable_type import CableTypeView
from .centreline import CentrelineView
from .route import RouteView
from .study import StudyView
from .support import ClampView, ClipView, RingView, SleeveView
from .terminal import TerminalView

VIEWS = {
    "Cable": CableView,
    "CableType": CableTypeView,
    "Centreline": CentrelineView,
    "Clamp": ClampView,
    "Clip": ClipView,
    "Ring": RingView,
    "Route": RouteView,
    "Sleeve": SleeveView,
    "Study": StudyView,
    "Terminal": TerminalView,
}
"""Class of the proxy: class of the view."""


def attach(obj):
    """Give an object that was made or opened its view; without one FreeCAD shows nothing of it.

    FreeCAD hides what comes from a file without a window's part, as macros and the demo write it.
    Where a file has that part, FreeCAD reads it after this.
    """
    view = VIEWS[type(obj.Proxy).__name__]
    if not isinstance(obj.ViewObject.Proxy, view):
        view(obj.ViewObject)
        obj.ViewObject.Visibility = True
