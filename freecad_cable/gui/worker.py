# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solves beside the window: in a thread of its own, one scene at a time, because CasADi bears no two.

What is solved quickly is there at once; what takes longer goes on while the window lives, and its cable is recomputed
when the answer comes. The thread sees plain data only; documents are touched in the main thread.
"""

import threading
import time
from collections import OrderedDict, deque
from functools import partial

import FreeCAD
from PySide import QtCore, QtGui

from ..document import solving
from ..document.observer import dependents
from .documents import alive, is_busy, recompute
from .job import Job

PATIENCE = 0.5
"""[s] How long the window waits for solves before it goes on without them, all cables of a recompute together."""

MOMENT = 0.03
"""[s] How long it waits for lines of cables that move, all together: to paint without them takes as long on a slow
machine, and then there is nobody to take them."""

KEPT = 32
"""Answers that are kept, for undo and redo."""

LATER = 50
"""[ms] until the next look at a document that is busy."""


class Worker(QtCore.QObject):
    """See ``document.solving.Beside``."""

    came = QtCore.Signal(object)
    """a job or a preview is done; emitted in the thread, heard in the main one"""
    changed = QtCore.Signal()
    """what is being solved has changed"""

    def __init__(self):
        super().__init__()
        self._lock = threading.Condition()
        self._queue = deque()
        self._previews = {}
        self._jobs = {}
        self._answers = OrderedDict()
        self._late = set()
        self._left = None
        self._thread = None
        self.came.connect(self._take, QtCore.Qt.QueuedConnection)

    # What the document asks.

    def solution(self, cable, inputs, work):
        if inputs in self._answers:
            self.drop(cable)
            known = self._answers.pop(inputs)
            if known.succeeded:  # what failed may be tried again
                self._answers[inputs] = known
            return known.answer()
        key = solving.key(cable)
        job = self._jobs.get(key)
        if job is None or job.inputs != inputs:
            self.drop(cable)
            job = self._jobs[key] = Job(key, inputs, work)
            self._put(job)
            self._wait_for(job)
        if not job.done.is_set() or job.stopped:
            return None
        self._jobs.pop(key, None)
        return job.answer()

    def knows(self, cable, inputs):
        job = self._jobs.get(solving.key(cable))
        return inputs in self._answers or (job is not None and job.inputs == inputs)

    def is_solving(self, cable):
        return solving.key(cable) in self._jobs

    def drop(self, cable):
        self._drop(solving.key(cable))

    def wait(self, document):
        while any(name == document.Name for name, _ in self._jobs):
            QtGui.QApplication.processEvents(QtCore.QEventLoop.ExcludeUserInputEvents)
            time.sleep(1e-3)  # the thread wants to run, too

    # What the window asks.

    def preview(self, key, work, receive):
        """Do ``work(watch)`` before all jobs and give its outcome to ``receive(value, error)``, in the main thread. Of
        several that wait under the same key the last one counts."""
        job = Job(key, None, work, receive)
        with self._lock:
            self._previews[key] = job
            self._start()
            self._lock.notify()
        return job

    def take_soon(self, previews):
        """Take those that are done in a moment; the others come when they come."""
        until = time.monotonic() + MOMENT
        for job in previews:
            if job.done.wait(max(0.0, until - time.monotonic())):
                self._take(job)

    def jobs(self):
        """Those that are not done, in the order they were asked for."""
        return list(self._jobs.values())

    def job(self, cable):
        """The one of a cable, or None."""
        return self._jobs.get(solving.key(cable))

    def stop(self, cable=None):
        """A person stops the solve of a cable, or all."""
        wanted = None if cable is None else solving.key(cable)
        for job in self.jobs():
            if wanted in (None, job.key):
                job.stopped = True

    def forget(self):
        """The answers so far."""
        self._answers.clear()
        self._late.clear()

    def close(self):
        """The program ends: no solve may outlive it."""
        for job in self.jobs():
            job.dropped = True
        if self._thread is not None:
            self._thread.join(2)

    # Observer of the documents.

    def slotDeletedObject(self, obj):
        self._drop((obj.Document.Name, obj.Name))

    def slotDeletedDocument(self, document):
        for key in list(self._jobs):
            if key[0] == document.Name:
                self._drop(key)

    def slotUndoDocument(self, document):
        self._look_again(document)

    def slotRedoDocument(self, document):
        self._look_again(document)

    def slotAbortTransaction(self, document):
        self._look_again(document)

    # In the main thread.

    def _put(self, job):
        with self._lock:
            self._queue.append(job)
            self._start()
            self._lock.notify()
        self.changed.emit()

    def _start(self):
        if self._thread is None:
            self._thread = threading.Thread(target=self._work, name="cables", daemon=True)
            self._thread.start()

    def _drop(self, key):
        job = self._jobs.pop(key, None)
        if job is not None:
            job.dropped = True
            self.changed.emit()

    def _wait_for(self, job):
        if threading.current_thread() is not threading.main_thread():
            job.done.wait()  # no window stands still
            return
        if self._left is None:
            self._left = PATIENCE
            QtCore.QTimer.singleShot(0, self._rest)
        begin = time.monotonic()
        job.done.wait(self._left)
        self._left = max(0.0, self._left - (time.monotonic() - begin))

    def _rest(self):
        """The window has had its turn."""
        self._left = None

    def _take(self, job):
        if job.receive is not None:
            if not job.taken:
                job.taken = True
                job.receive(job.value, job.error)
            return
        if self._jobs.get(job.key) is not job:
            return
        cable = alive(job.key)
        if cable is not None and is_busy(cable.Document):
            QtCore.QTimer.singleShot(LATER, lambda: self._take(job))
            return
        del self._jobs[job.key]
        if cable is not None:
            if job.stopped:
                solving.stopped(cable)
            else:
                self._answers[job.inputs] = job
                while len(self._answers) > KEPT:
                    self._answers.popitem(last=False)
                self._late.add(job.key)
                cable.touch()
                recompute([cable, *dependents(cable)])
        self.changed.emit()

    def _look_again(self, document):
        """An answer that came late is outside the step of undo of its question."""
        keys = [key for key in (*self._late, *self._jobs) if key[0] == document.Name]
        if keys:
            QtCore.QTimer.singleShot(0, lambda: self._ask_again(keys))

    def _ask_again(self, keys):
        cables = [cable for cable in map(alive, keys) if cable is not None]
        if any(is_busy(cable.Document) for cable in cables):
            QtCore.QTimer.singleShot(LATER, lambda: self._ask_again(keys))
            return
        for cable in cables:
            cable.touch()
        recompute([each for cable in cables for each in (cable, *dependents(cable))])

    # In the thread.

    def _work(self):
        while True:
            with self._lock:
                while not (self._queue or self._previews):
                    self._lock.wait()
            self._serve()
            with self._lock:
                job = self._queue.popleft() if self._queue else None
            if job is not None:
                job.run(partial(self._pause, job))
                self.came.emit(job)

    def _pause(self, job, sentence):
        """Between two runs of a solver."""
        job.watch(sentence)
        self._serve()

    def _serve(self):
        """A hand that moves a slider does not wait."""
        while True:
            with self._lock:
                if not self._previews:
                    return
                job = self._previews.pop(next(iter(self._previews)))
            job.run(job.watch)
            self.came.emit(job)


worker = Worker()


def install():
    """Let it solve the cables of all documents from now on."""
    if solving.beside is worker:
        return
    solving.beside = worker
    FreeCAD.addDocumentObserver(worker)
    QtCore.QCoreApplication.instance().aboutToQuit.connect(worker.close)
