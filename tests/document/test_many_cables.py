# SPDX-License-Identifier: LGPL-2.1-or-later
"""A document with many cables: what does not concern a cable does not solve it again."""

import sys
import time
from unittest import mock

from FreeCAD import Vector
from scenes import TOP, DocumentTest

from freecad_cable.document import cable, make, solving

COUNT = 200


class ManyCablesTest(DocumentTest):
    def setUp(self):
        """All from one terminal, of one type, to a pin of their own each, side by side."""
        super().setUp()
        self.start = make.terminal(self.doc, (self.pin("Start", (0, 0, 0), (0, 1, 0)), TOP))
        kind = make.cable_type(self.doc, "Multi-core cable 7 mm")
        self.pins, self.ends, self.cables = [], [], []
        for k in range(COUNT):
            pin = self.pin(f"Pin{k}", (120 + k, 140, 0), (0, -1, 0))
            end = make.terminal(self.doc, (pin, TOP))
            made = make.cable(self.doc, start=self.start, end=end, cable_type=kind, slack=0.1)
            self.pins.append(pin)
            self.ends.append(end)
            self.cables.append(made)
        self.seconds, solves, swept = self.recomputed()
        self.assertEqual((solves, swept), (COUNT, COUNT))

    def recomputed(self):
        """Seconds of a recompute, and how many cables were solved and swept by it."""
        with (
            mock.patch.object(solving, "find_equilibrium", wraps=solving.find_equilibrium) as solve,
            mock.patch.object(cable, "sweep_round", wraps=cable.sweep_round) as sweep,
        ):
            begin = time.perf_counter()
            self.compute()
            seconds = time.perf_counter() - begin
        return seconds, solve.call_count, sweep.call_count

    def assertComputed(self, what, *changed):
        before = [each.SolvedInputs for each in self.cables]
        seconds, solves, swept = self.recomputed()
        self.assertEqual((solves, swept), (len(changed), len(changed)), what)
        after = [each.SolvedInputs for each in self.cables]
        self.assertEqual([k for k in range(COUNT) if after[k] != before[k]], list(changed), what)
        # Of one cable and of looking at all others; all of them again would be a ratio of 1.
        self.assertLess(seconds, self.seconds / 4, what)
        print(
            f"{what}: {seconds:.2f} s of {self.seconds:.2f} s for all {COUNT}", file=sys.__stdout__
        )

    def test_only_what_changed_is_solved(self):
        self.ends[7].Roll = 30
        self.assertComputed("a terminal is rolled", 7)
        self.pins[11].Placement.Base += Vector(3, 0, 0)
        self.assertComputed("a connector is moved", 11)
        self.cables[13].Slack = 0.11
        self.assertComputed("a cable is longer", 13)
        self.start.touch()
        self.assertComputed("what all share is computed again, the same")
