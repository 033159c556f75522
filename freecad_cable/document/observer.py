# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moves and errors that FreeCAD does not pass on.

An assembly solver sets placements and then takes back the touch, so what hangs on the moved part would
not follow. What refers to a part must refer to it anew when either is put into another container. And what
depends on an object in error is not executed, so it would look as if it were up to date.
"""

import FreeCAD

PLACEMENTS = ("Placement", "LinkPlacement")

NOISE = 1e-7
"""[mm] and [rad], OCCT's smallest distance: an assembly solver that has nothing to do still moves parts by some
1e-10 mm, in every recompute, so that what follows them would never be up to date."""


class Observer:
    """Hears every change in every document, so it looks at the name of the property first."""

    def __init__(self):
        self._before = None

    def slotBeforeChangeObject(self, obj, name):
        if name in PLACEMENTS:
            self._before = obj, getattr(obj, name)

    def slotChangedObject(self, obj, name):
        if name in PLACEMENTS:
            was, before = self._before or (None, None)
            if was is not obj or _differ(before, getattr(obj, name)):
                _touch_dependents(obj)
                _put_back(obj)
        elif name == "Group":
            _rebase_references(obj.Document)

    def slotDeletedObject(self, obj):
        for dependent in obj.InList:
            lose = getattr(getattr(dependent, "Proxy", None), "lose", None)
            if lose:
                lose(dependent, obj)

    def slotUndoDocument(self, document):
        _rebase_references(document)

    def slotRedoDocument(self, document):
        _rebase_references(document)

    def slotRecomputedDocument(self, document):
        for failed in _failed():
            for obj in (failed, *dependents(failed)):
                leave_behind = getattr(getattr(obj, "Proxy", None), "leave_behind", None)
                if leave_behind:
                    leave_behind(obj, failed)


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


def _failed():
    """What is in error, in all open documents, and has not said so to what depends on it."""
    for document in FreeCAD.listDocuments().values():
        for obj in document.Objects:
            if not obj.isValid():
                has_said = getattr(getattr(obj, "Proxy", None), "has_said", None)
                if has_said is None or not has_said(obj):
                    yield obj


def _reading(document):
    """Whether FreeCAD is filling in what a file or a copy says."""
    return document.Restoring or document.Importing


def _differ(one, other):
    """Whether two placements are different for a person."""
    entries = zip(one.toMatrix().A, other.toMatrix().A, strict=True)
    return any(abs(before - now) > NOISE for before, now in entries)


def _touch_dependents(obj):
    if _reading(obj.Document):
        return
    for dependent in (obj, *dependents(obj)):
        if getattr(getattr(dependent, "Proxy", None), "follows_placements", False):
            dependent.touch()


def _put_back(obj):
    home = getattr(getattr(obj, "Proxy", None), "home", None)
    if home is None or _reading(obj.Document) or obj.Document.Transacting:
        return
    if _differ(obj.Placement, home(obj)):
        obj.Placement = home(obj)


def _rebase_references(document):
    if _reading(document) or document.Transacting:
        return
    for obj in document.findObjects("Part::FeaturePython"):
        rebase = getattr(getattr(obj, "Proxy", None), "rebase_references", None)
        if rebase:
            rebase(obj)
