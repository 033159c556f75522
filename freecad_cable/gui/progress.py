# SPDX-License-Identifier: LGPL-2.1-or-later
"""In the status bar: which cable is being solved beside the window, for how long, and how to stop it."""

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from .documents import alive
from .job import in_words
from .worker import worker

translate = FreeCAD.Qt.translate

TICK = 200
"""[ms] from one look to the next"""


class Progress(QtGui.QWidget):
    """Seen only while something is being solved."""

    def __init__(self):
        super().__init__()
        self.setObjectName("CableProgress")
        self.said = QtGui.QLabel()
        busy = QtGui.QProgressBar()
        busy.setRange(0, 0)
        busy.setTextVisible(False)
        busy.setMaximumWidth(80)
        stop = QtGui.QPushButton(translate("Cable", "Stop"))
        stop.setObjectName("StopAll")
        stop.setToolTip(
            translate("Cable", "Stops the solves of all cables; their last good shapes stay")
        )
        stop.clicked.connect(lambda: worker.stop())
        row = QtGui.QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        for widget in (self.said, busy, stop):
            row.addWidget(widget)
        self._tick = QtCore.QTimer(self)
        self._tick.setInterval(TICK)
        self._tick.timeout.connect(self.look)
        worker.changed.connect(self._start)
        self.hide()

    def _start(self):
        """What is done before the first tick is never shown."""
        self._tick.start()

    def look(self):
        """Say what is being solved now."""
        jobs = worker.jobs()
        self.setVisible(bool(jobs))
        if not jobs:
            self._tick.stop()
            return
        cable = alive(jobs[0].key)
        said = f"{cable.Label if cable else ''}: {in_words(jobs[0])}"
        if len(jobs) > 1:
            said = translate("Cable", "{said}; {count} more").format(said=said, count=len(jobs) - 1)
        self.said.setText(said)


def install():
    """Into the main window, once."""
    bar = FreeCADGui.getMainWindow().statusBar()
    if bar.findChild(Progress) is None:
        bar.addPermanentWidget(Progress())
