# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cable whose solve takes as long as a test wants."""

import threading
from unittest import mock

from window import WindowTest

from freecad_cable.document import solving
from freecad_cable.errors import StoppedError
from freecad_cable.gui import worker as worker_module
from freecad_cable.gui.worker import worker

find = solving.find_equilibrium


class Slow:
    """A solver that takes until it is let go, and then does ``after``, or what ours does."""

    after = None

    def __init__(self):
        self.gate = threading.Event()
        self.lengths, self.stopped = [], 0

    def __call__(self, scene, *, start=None, watch=None):
        self.lengths.append(round(1e3 * scene.rod.length, 6))
        try:
            while not self.gate.wait(0.01):
                watch("0.3 m in 32 elements")
            return (self.after or find)(scene, start=start, watch=watch)
        except StoppedError:
            self.stopped += 1
            raise


class BesideTest(WindowTest):
    def setUp(self):
        super().setUp()
        self.make_cable()
        self.volume = self.cable.Shape.Volume
        self.slow = Slow()
        patience = mock.patch.object(worker_module, "PATIENCE", 0.05)
        for patched in (mock.patch.object(solving, "find_equilibrium", self.slow), patience):
            patched.start()
            self.addCleanup(patched.stop)

    def tearDown(self):
        self.slow.gate.set()
        super().tearDown()

    def edit(self, length=350):
        """Longer; the answer does not come."""
        self.document.openTransaction("Edit")
        self.cable.Length = length
        self.document.recompute()
        self.document.commitTransaction()
        self.assertTrue(worker.is_solving(self.cable))

    def let_go(self):
        self.slow.gate.set()
        self.wait_for(lambda: not worker.jobs())

    def assertOld(self):
        """The last good answer is there, and marked."""
        self.assertTrue(self.cable.OutOfDate)
        self.assertEqual(self.cable.SolvedLength.Value, 300)
        # The same solid, integrated anew: sums of some 1e4 terms.
        self.assertAlmostEqual(self.cable.Shape.Volume / self.volume, 1, delta=1e-12)
        self.assertTrue(self.cable.Status.startswith("Out of date: "), self.cable.Status)
        self.assertTrue(self.cable.ViewObject.Proxy.fade.on)
        self.assertIn("outdated", self.cable.ViewObject.Proxy.getIcon())

    def assertNew(self, length):
        self.assertFalse(self.cable.OutOfDate)
        self.assertEqual(self.cable.SolvedLength.Value, length)
        # Area times length, within what the sweep is checked for.
        ratio = self.cable.Shape.Volume / self.volume
        self.assertAlmostEqual(ratio, length / 300, delta=2e-2)
        self.assertEqual(self.cable.State, ["Up-to-date"])
        self.assertEqual(self.cable.Centreline.State, ["Up-to-date"])
        self.assertAlmostEqual(self.cable.Centreline.Length.Value, length, delta=1e-3 * length)
        self.assertFalse(self.cable.ViewObject.Proxy.fade.on)
