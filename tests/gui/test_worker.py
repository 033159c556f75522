# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long solves go on beside the window, whatever happens to their cables meanwhile."""

import os
import tempfile
import threading
import time
from unittest import mock

import FreeCAD
from beside import BesideTest
from PySide import QtCore

from freecad_cable.document import make
from freecad_cable.gui import worker as worker_module
from freecad_cable.gui.worker import worker
from freecad_cable.status import Status


class WorkerTest(BesideTest):
    def test_the_window_lives_and_the_answer_comes_by_itself(self):
        self.edit()  # comes back, although the answer does not come
        ticks = []
        timer = QtCore.QTimer()
        timer.timeout.connect(lambda: ticks.append(time.monotonic()))
        timer.start(10)
        self.wait_for(lambda: len(ticks) > 20)
        self.assertOld()
        self.let_go()
        self.assertNew(350)
        self.assertEqual(self.slow.lengths, [350])

    def test_a_short_solve_is_there_at_once(self):
        self.slow.gate.set()
        with mock.patch.object(worker_module, "PATIENCE", 10):
            self.cable.Length = 350
            self.document.recompute()
        self.assertNew(350)

    def test_a_line_that_is_there_in_a_moment(self):
        """It is taken before the window is painted, and once only."""
        taken = []
        job = worker.preview("quick", lambda watch: 1, lambda *outcome: taken.append(outcome))
        with mock.patch.object(worker_module, "MOMENT", 10):
            worker.take_soon([job])
        self.assertEqual(taken, [(1, None)])
        self.pump(0.1)
        self.assertEqual(len(taken), 1)

    def test_a_line_that_takes_longer(self):
        """The window does not wait for it; it comes by itself."""
        gate, taken = threading.Event(), []
        job = worker.preview("slow", lambda watch: gate.wait(10), lambda *got: taken.append(got))
        begin = time.monotonic()
        worker.take_soon([job])
        self.assertLess(time.monotonic() - begin, 5)
        self.assertEqual(taken, [])
        gate.set()
        self.wait_for(lambda: taken)
        self.assertEqual(taken, [(True, None)])

    def test_the_latest_edit_wins(self):
        self.edit(350)
        self.edit(360)
        self.edit(370)
        self.assertOld()
        self.let_go()
        self.assertNew(370)
        # Whether the thread had come to the second before the third came is chance; what it began it has stopped.
        self.assertEqual((self.slow.lengths[0], self.slow.lengths[-1]), (350, 370))
        self.assertEqual(self.slow.stopped, len(self.slow.lengths) - 1)

    def test_an_edit_that_is_taken_back(self):
        self.edit()
        self.cable.Length = 300
        self.document.recompute()
        self.assertFalse(worker.jobs())
        self.assertNew(300)
        self.wait_for(lambda: self.slow.stopped)

    def test_a_wrong_edit_meanwhile(self):
        self.edit()
        self.cable.Length = 100
        self.document.recompute()
        self.assertFalse(worker.jobs())
        self.assertIn("Invalid", self.cable.State)
        self.let_go()
        self.pump(0.2)
        self.assertIn("Invalid", self.cable.State)
        self.assertTrue(self.cable.Shape.isNull())

    def test_a_recompute_meanwhile_does_not_wait_again(self):
        self.edit()
        self.cable.touch()
        self.document.recompute()
        self.assertOld()
        self.let_go()
        self.assertNew(350)
        self.assertEqual(self.slow.lengths, [350])

    def test_undo_meanwhile(self):
        self.edit()
        self.document.undo()
        self.wait_for(lambda: not worker.jobs())
        self.pump(0.1)
        self.assertEqual(self.cable.Length.Value, 300)
        self.assertNew(300)

    def test_undo_and_redo_afterwards(self):
        self.edit()
        self.let_go()
        self.assertNew(350)
        self.document.undo()
        self.pump(0.3)
        self.wait_for(lambda: not worker.jobs())
        self.assertEqual(self.cable.Length.Value, 300)
        self.assertNew(300)
        self.document.redo()
        self.pump(0.3)
        self.wait_for(lambda: not worker.jobs())
        self.assertNew(350)
        # 350 is known, and need not be solved again.
        self.assertEqual(self.slow.lengths.count(350), 1)

    def test_deleted_meanwhile(self):
        self.edit()
        self.document.removeObject(self.cable.Name)
        self.assertFalse(worker.jobs())
        self.wait_for(lambda: self.slow.stopped)
        self.pump(0.2)

    def test_deleted_meanwhile_and_brought_back(self):
        self.edit()
        name = self.cable.Name
        self.document.openTransaction("Delete")
        self.document.removeObject(name)
        self.document.commitTransaction()
        self.document.undo()
        self.slow.gate.set()
        self.cable = self.document.getObject(name)
        self.cable.touch()
        self.compute()
        self.assertNew(350)

    def test_the_document_is_closed_meanwhile(self):
        self.edit()
        FreeCAD.closeDocument(self.document.Name)
        self.assertFalse(worker.jobs())
        self.wait_for(lambda: self.slow.stopped)
        self.slow.gate.set()
        self.pump(0.2)

    def test_saved_meanwhile(self):
        self.edit()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "meanwhile.FCStd")
            self.document.saveAs(path)
            FreeCAD.closeDocument(self.document.Name)
            self.document = FreeCAD.openDocument(path)
        self.name = self.document.Name
        self.cable = self.document.Cable
        self.pump(0.1)
        self.assertOld()
        self.slow.gate.set()
        self.document.recompute()
        self.wait_for(lambda: not worker.jobs())
        self.assertNew(350)

    def test_it_fails(self):
        self.edit()
        failed = mock.Mock(status=Status.NOT_CONVERGED, message="No equilibrium was found.")
        self.slow.after = lambda scene, **_: failed
        self.let_go()
        self.assertIn("Invalid", self.cable.State)
        self.assertIn("No equilibrium was found.", self.cable.getStatusString())
        self.assertTrue(self.cable.Shape.isNull())
        self.assertFalse(self.cable.OutOfDate)
        self.assertEqual(self.cable.SolvedLength.Value, 0)

    def test_a_new_cable_that_takes_long(self):
        other = make.cable(
            self.document, start=self.start, end=self.end, cable_type=self.kind, length="310 mm"
        )
        self.document.recompute()
        for obj in (other, other.Centreline):
            self.assertEqual(obj.State, ["Up-to-date"])
            self.assertTrue(obj.Shape.isNull())
            self.assertIn("No shape yet", obj.Status)
        self.let_go()
        self.assertEqual(other.SolvedLength.Value, 310)
        self.assertAlmostEqual(other.Centreline.Length.Value, 310, delta=0.31)
