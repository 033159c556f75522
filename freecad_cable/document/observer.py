# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moves that FreeCAD does not pass on.

An assembly solver sets placements and then takes back the touch, so what hangs on the moved part would
not follow. And what refers to a part must refer to it anew when either is put into another container.
"""

import FreeCAD

PLACEMENTS = ("Placement", "LinkPlacement")


class Observer:
    """Hears every change in every document, so it looks at the name of the property first."""

    def __init__(self):
        self._before = None

    def slotBeforeChangeObject(self, obj, name):
        if name in PLACEMENTS:
            self._before = obj, getattr(obj, name)

    def slotChangedObject(self, obj, name):
        if name in PLACEMENTS:
            # A solver sets what is there already, too.
            if self._before != (obj, getattr(obj, name)):
                _touch_dependents(obj)
        elif name == "Group":
            _rebase_references(obj.Document)


def install():
    """Start observing; once for all documents."""
    if _installed:
        return
    FreeCAD.addDocumentObserver(_observer)
    _installed.append(_observer)


_observer = Observer()
_installed = []


def dependents(obj):
    """All that depends on ``obj``. FreeCAD's own list refuses where links run in a circle."""
    found, new = {}, [obj]
    while new:
        for dependent in new.pop().InList:
            key = dependent.Document.Name, dependent.Name
            if key not in found:
                found[key] = dependent
                new.append(dependent)
    found.pop((obj.Document.Name, obj.Name), None)
    return list(found.values())


def _reading(document):
    """Whether FreeCAD is filling in what a file or a copy says."""
    return document.Restoring or document.Importing


def _touch_dependents(obj):
    if _reading(obj.Document):
        return
    for dependent in (obj, *dependents(obj)):
        if getattr(getattr(dependent, "Proxy", None), "follows_placements", False):
            dependent.touch()


def _rebase_references(document):
    if _reading(document) or document.Transacting:
        return
    for obj in document.findObjects("Part::FeaturePython"):
        rebase = getattr(getattr(obj, "Proxy", None), "rebase_references", None)
        if rebase:
            rebase(obj)
