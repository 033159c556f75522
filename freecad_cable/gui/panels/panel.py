# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the task panels share: one step of undo, the line that follows, the verdict, and what a macro would write."""

from contextlib import suppress

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from ...document import solving, verdict
from ..documents import alive
from ..icons import icon
from ..job import in_words
from ..live import live
from ..macro import assignment
from ..worker import worker
from .inputs import Slider
from .verdicts import BAD, DOUBTFUL, GOOD, NEUTRAL, Said, Verdicts

translate = FreeCAD.Qt.translate


class Panel(QtCore.QObject):
    """Base of the panels; FreeCAD calls ``accept``, ``reject`` and ``getStandardButtons``.

    Whatever the panel changes is in one transaction: OK ends it, Cancel takes all of it back.
    """

    icon_name = ""
    _last = None
    _changed = QtCore.Signal()

    def __init__(self, obj):
        super().__init__()
        self.object, self.document = obj, obj.Document
        self.is_open = True
        self.inputs = []
        self._before = self._stated()
        if not self.document.HasPendingTransaction:
            title = translate("Cable", "Edit {label}").format(label=obj.Label)
            self.document.openTransaction(title)
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(obj.Label)
        self.form.setWindowIcon(QtGui.QIcon(icon(self.icon_name)))
        self.form.destroyed.connect(self._closed)
        self._layout = QtGui.QVBoxLayout(self.form)
        self.rows = QtGui.QFormLayout()
        self._layout.addLayout(self.rows)
        self.said, self.verdicts = Said(), Verdicts()
        self.stop = QtGui.QPushButton(translate("Cable", "Stop"))
        self.stop.setObjectName("Stop")
        self.stop.setToolTip(translate("Cable", "Stops the solve; the last good shape stays"))
        self.now = QtGui.QPushButton(translate("Cable", "Solve Now"))
        self.now.setObjectName("SolveNow")
        self.busy = QtGui.QProgressBar()
        self.busy.setRange(0, 0)
        self.busy.setTextVisible(False)
        beside = QtGui.QHBoxLayout()
        for widget in (self.busy, self.stop, self.now):
            beside.addWidget(widget)
        self.fill()
        self._layout.addWidget(self.said)
        self._layout.addLayout(beside)
        self._layout.addWidget(self.verdicts)
        self._layout.addStretch()
        self.stop.clicked.connect(self._stop)
        self.now.clicked.connect(self._solve_now)
        self._tick = QtCore.QTimer(self)
        self._tick.setInterval(200)
        self._tick.timeout.connect(self._show_state)
        live.moved.connect(self._moved)
        live.rested.connect(self.refresh)
        worker.changed.connect(self.refresh)
        # Once for all that changes in one event, and, other than a timer, before the window is painted.
        self._changed.connect(self._refresh_changed, QtCore.Qt.QueuedConnection)
        self._is_changed = False
        self._followed = [solving.key(cable) for cable in self.cables()]
        self._shown = {obj.Name, *(name for _, name in self._followed)}
        live.follow(self.cables())
        FreeCAD.addDocumentObserver(self)
        self.refresh()

    # What a panel says.

    def fill(self):
        """Put the inputs into ``rows``."""
        raise NotImplementedError

    def cables(self):
        """Those whose lines follow while the panel is open; the first is the one judged."""
        raise NotImplementedError

    def more(self, cable):
        """Further rows (what, how much) of the verdict on a solved cable."""
        return ()

    def adapt(self):
        """Show or hide what depends on a choice."""

    # FreeCAD calls.

    def getStandardButtons(self):
        buttons = QtGui.QDialogButtonBox.Ok | QtGui.QDialogButtonBox.Cancel
        return int(getattr(buttons, "value", buttons))  # Qt 6, Qt 5

    def accept(self):
        self.leave()
        self._reset_edit()
        return True

    def reject(self):
        document, self.is_open = self.document, False
        self._release()
        document.abortTransaction()
        self._reset_edit()
        document.recompute()
        return True

    def leave(self):
        """As OK, but FreeCAD closes the panel."""
        self.is_open = False
        self._write_macro()
        self.document.recompute()
        self._release()
        self.document.commitTransaction()

    def _closed(self):
        """Without the buttons: by a macro or another command, or with the document."""
        if self.is_open:
            self.is_open = False  # its widgets are gone
            ours = solving.key(self.object)
            QtCore.QTimer.singleShot(0, lambda: self.accept() if alive(ours) else self._release())

    # Observer of the documents.

    def slotChangedObject(self, obj, name):
        ours = obj.Name in self._shown and obj.Document is self.document
        if ours and not self._is_changed:
            self._is_changed = True
            self._changed.emit()

    def slotDeletedObject(self, obj):
        if obj is self.object and self.is_open:
            self.is_open = False
            self._release()
            QtCore.QTimer.singleShot(0, FreeCADGui.Control.closeDialog)

    # Parts of a panel.

    def add(self, text, made):
        """A row; returns the input."""
        self.inputs.append(made)
        if text:
            self.rows.addRow(text, made.widget)
        else:
            self.rows.addRow(made.widget)
        return made

    def add_with_slider(self, text, number, low, high):
        slider = Slider(number, low, high, live.hold, live.let_go)
        self.add(text, number)
        self.rows.addRow("", slider.widget)
        self.inputs.append(slider)
        return slider

    def show_row(self, made, on):
        """Show or hide an input with its label."""
        made.widget.setVisible(on)
        label = self.rows.labelForField(made.widget)
        if label is not None:
            label.setVisible(on)

    # In the window.

    def _refresh_changed(self):
        self._is_changed = False
        self.refresh()

    def refresh(self):
        """Everything as it is in the document."""
        if not self.is_open:
            return
        for made in self.inputs:
            made.show()
        self.adapt()
        self._show_state()

    def _show_state(self):
        if not self.is_open:
            return
        cable = next(iter(self.cables()), None)
        job = None if cable is None else worker.job(cable)
        self.busy.setVisible(job is not None)
        self.stop.setVisible(job is not None)
        old = cable is not None and cable.OutOfDate
        self.now.setVisible(old and job is None)
        if job is not None:
            self._tick.start()
            self.said.say(in_words(job), DOUBTFUL)
        else:
            self._tick.stop()
            if cable is None:
                self.said.say(self.object.Status, BAD if self.object.Status else NEUTRAL)
            elif not live.is_moving(cable):
                self._judge(cable)

    def _judge(self, cable):
        found = verdict.of_cable(cable)
        self._say_verdict(cable, found, self.more(cable) if found else ())
        wrong = self.object.Status if self.object is not cable else ""
        if wrong and not self.object.isValid():
            self.said.say(wrong, BAD)
        elif found is None:
            self.said.say(cable.Status, BAD if not cable.OutOfDate else DOUBTFUL)
        else:
            doubtful = cable.OutOfDate or "Warning" in cable.Status or not cable.isValid()
            self.said.say(cable.Status, DOUBTFUL if doubtful else GOOD)

    def _moved(self, key, found, sentence):
        if not self.is_open:
            return
        cable = next(iter(self.cables()), None)
        if cable is None or key != solving.key(cable):
            return
        self._say_verdict(cable, found)
        if sentence:
            self.said.say(sentence, BAD)
        else:
            self.said.say(translate("Cable", "Preview; the solid follows when it rests."))

    def _say_verdict(self, cable, found, more=()):
        allowed = found and cable.Tolerance * found.length
        self.verdicts.show_verdict(found, allowed, more)

    def _stop(self):
        for cable in self.cables():
            worker.stop(cable)

    def _solve_now(self):
        for cable in self.cables():
            solving.solve(cable)

    # The end.

    def _stated(self):
        """What a macro would have to write."""
        proxy = self.object.Proxy
        return {p.name: assignment(self.object, p.name) for p in proxy.TABLE if not p.result}

    def _write_macro(self):
        for name, line in self._stated().items():
            if line and line != self._before[name]:
                FreeCADGui.doCommand(line)

    def _release(self):
        # FreeCAD lets go of ``form`` and deletes its widgets. Were nobody else to hold it, Python would delete them
        # first, and Qt 6 crash over that.
        Panel._last = self, self.form
        self._tick.stop()
        FreeCAD.removeDocumentObserver(self)
        live.moved.disconnect(self._moved)
        live.rested.disconnect(self.refresh)
        worker.changed.disconnect(self.refresh)
        live.follow([])
        for key in self._followed:
            if (cable := alive(key)) is not None:
                cable.ViewObject.Proxy.rest()

    def _reset_edit(self):
        # The object of a command that is taken back is no more.
        with suppress(NameError):
            FreeCADGui.getDocument(self.document.Name).resetEdit()
