# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cables that follow by themselves: those whose ``Update`` is Live, and those of the open task panel.

While something moves, their line moves along; when it rests, they are recomputed. All changes are heard in the
documents, so that a slider, the property editor, a macro and a hand that drags a part are the same.
"""

from functools import partial

import FreeCAD
from PySide import QtCore, QtGui

from ..document import preview, solving, verdict
from ..document.observer import PLACEMENTS, dependents
from ..document.proxy import in_use
from ..errors import CableError
from .documents import alive, is_busy, recompute
from .selection import has_proxy
from .worker import worker

QUIET = 250
"""[ms] without a change after which something rests"""


class Live(QtCore.QObject):
    """Observer of all documents."""

    moved = QtCore.Signal(object, object, str)
    """a followed cable lies elsewhere: its key, the ``Verdict`` or None, and what is wrong"""
    rested = QtCore.Signal()
    """the followed cables have been recomputed"""
    _wanted = QtCore.Signal()
    """something has moved"""

    def __init__(self):
        super().__init__()
        self._followed = []
        self._previews = {}
        self._moved = {}
        self._unsettled = {}
        self._looking = self._held = False
        # In the order of events a timer is after the painting, a signal before it: the solve runs meanwhile.
        self._wanted.connect(self._look, QtCore.Qt.QueuedConnection)
        self._quiet = QtCore.QTimer(self)
        self._quiet.setSingleShot(True)
        self._quiet.setInterval(QUIET)
        self._quiet.timeout.connect(self.settle)

    def follow(self, cables):
        """From now on these, besides those that are Live."""
        self._held = False
        self._followed = [solving.key(cable) for cable in cables]

    def hold(self):
        """Something is held, with or without a mouse, until it is let go."""
        self._held = True

    def let_go(self):
        self._held = False
        self.settle()

    def is_moving(self, cable=None):
        """Whether what is shown of a cable, or of any, is a preview."""
        return bool(self._unsettled) if cable is None else solving.key(cable) in self._unsettled

    def settle(self):
        """Recompute what has moved, unless it is still held."""
        cables = [cable for cable in map(alive, self._unsettled) if cable is not None]
        if self._is_held() or any(is_busy(cable.Document) for cable in cables):
            self._quiet.start()
            return
        self._forget(list(self._unsettled))
        recompute([each for cable in cables for each in (cable, *dependents(cable))])
        for cable in cables:
            if not cable.OutOfDate:
                cable.ViewObject.Proxy.rest()
        self.rested.emit()

    def slotChangedObject(self, obj, name):
        if name in PLACEMENTS or name in _inputs(obj):
            document = obj.Document
            if not (self._looking or is_busy(document)):
                self._note(obj)

    def slotRecomputedDocument(self, document):
        """Somebody else was faster, the property editor for instance."""
        if not (self._looking or self._is_held()):
            keys = [key for key in self._unsettled if key[0] == document.Name]
            self._forget(keys)
            for cable in filter(None, map(alive, keys)):
                cable.ViewObject.Proxy.rest()
            if keys:
                self.rested.emit()

    def slotDeletedDocument(self, document):
        self._forget([key for key in self._unsettled if key[0] == document.Name])

    def _is_held(self):
        return self._held or QtGui.QApplication.mouseButtons() != QtCore.Qt.NoButton

    def _forget(self, keys):
        for key in keys:
            for each in (self._moved, self._unsettled, self._previews):
                each.pop(key, None)
        if not self._unsettled:
            self._quiet.stop()

    def _note(self, obj):
        for each in (obj, *dependents(obj)):
            if has_proxy(each, "Cable"):
                key = solving.key(each)
                if key in self._followed or (in_use(each) and each.Update == "Live"):
                    if not self._moved:
                        self._wanted.emit()
                    self._moved[key] = self._unsettled[key] = None
                    self._quiet.start()

    def _look(self):
        keys, asked = list(self._moved), []
        self._moved.clear()
        for key in keys:
            cable = alive(key)
            if cable is None:
                continue
            if is_busy(cable.Document):
                self._moved[key] = None
                QtCore.QTimer.singleShot(QUIET, self._look)
                continue
            worker.drop(cable)
            looked = self._previews.get(key)
            if looked is None:
                looked = self._previews[key] = preview.Preview(cable)
            self._looking = True
            try:
                work = looked.work()
            except CableError as error:
                self._show(key, None, str(error))
            else:
                asked.append(worker.preview(key, work, partial(self._receive, key)))
            finally:
                self._looking = False
        worker.take_soon(asked)

    def _receive(self, key, solution, error):
        looked = self._previews.get(key)
        if looked is None:
            return  # it rests, and was recomputed
        if error is not None:
            self._show(key, None, str(error))
        elif solution.position is None:
            self._show(key, None, preview.in_words(looked.cable, solution))
        else:
            looked.keep(solution)
            self._show(key, solution, preview.in_words(looked.cable, solution))

    def _show(self, key, solution, sentence):
        cable = alive(key)
        if cable is None:
            return
        good = solution is not None and solution.status.success
        cable.ViewObject.Proxy.follow(preview.line(solution) if good else [])
        found = verdict.of_solution(solution) if good else None
        self.moved.emit(key, found, "" if good else sentence)


def _inputs(obj):
    """What of our objects can be changed."""
    proxy = type(getattr(obj, "Proxy", None))
    if proxy not in _known:
        table = getattr(proxy, "TABLE", ())
        _known[proxy] = frozenset(prop.name for prop in table if not prop.result)
    return _known[proxy]


_known = {}

live = Live()


def install():
    """Listen from now on."""
    if not _installed:
        FreeCAD.addDocumentObserver(live)
        _installed.append(live)


_installed = []
