# SPDX-License-Identifier: LGPL-2.1-or-later
"""Copy and paste, undo and redo, and deleting."""

from unittest import mock

import FreeCAD
from FreeCAD import Vector
from reader import seen
from scenes import DocumentTest

from freecad_cable.document import make, solving


def no_solve():
    """Whoever solves in here fails."""
    return mock.patch.object(solving, "find_equilibrium", side_effect=AssertionError("solved"))


class CopyTest(DocumentTest):
    def setUp(self):
        super().setUp()
        self.cable_between_pins()
        self.compute()

    def test_a_copy_with_all_it_hangs_on_is_independent(self):
        before = seen(self.cable)
        copy = self.doc.copyObject(self.cable, True)
        with no_solve():
            self.compute()
        self.assertEqual(copy.NodePosition, self.cable.NodePosition)
        self.assertEqual(copy.SmallestBendRadius, self.cable.SmallestBendRadius)
        mine = {self.start, self.end, self.type, self.left, self.right}
        self.assertFalse(mine & set(copy.OutListRecursive))
        part = copy.End.Reference[0][0]
        self.assertIsNot(part, self.right)
        part.Placement.Base += Vector(20, 0, 0)
        copy.Length = "320 mm"
        copy.CableType.BendingStiffness = "2e-3 N*m^2"
        self.compute()
        self.assertEqual(seen(self.cable), before)
        self.assertNear(copy.NodePosition[-1], (0.140, 0, 0))
        self.assertEqual(copy.SolvedLength.Value, 320)

    def test_a_copy_of_the_cable_alone_shares_its_terminals(self):
        copy = self.doc.copyObject(self.cable, False)
        with no_solve():
            self.compute()
        self.assertIs(copy.Start, self.start)
        self.assertIsNone(copy.Centreline)
        self.assertIsNotNone(self.cable.Centreline)
        copy.Length = "320 mm"
        self.compute()
        self.assertEqual(self.cable.SolvedLength.Value, 300)

    def test_a_copy_into_another_document(self):
        other = FreeCAD.newDocument("Other")
        self.addCleanup(FreeCAD.closeDocument, other.Name)
        copy = other.copyObject(self.cable, True)
        with no_solve():
            other.recompute()
        self.assertEqual({obj.Document for obj in copy.OutListRecursive}, {other})
        self.assertEqual(copy.NodePosition, self.cable.NodePosition)
        # The same solid, swept once more: what differs is the order in which its faces are summed up.
        volume = self.cable.Shape.Volume
        self.assertAlmostEqual(copy.Shape.Volume, volume, delta=1e-12 * volume)
        copy.Start.Reference[0][0].Placement.Base += Vector(5, 0, 0)
        other.recompute()
        self.assertNear(copy.NodePosition[0], (0.005, 0, 0))

    def test_a_copy_with_its_centreline(self):
        copy, line = self.doc.copyObject([self.cable, self.cable.Centreline], False, True)[:2]
        if copy.Name.startswith("Centreline"):
            copy, line = line, copy
        self.compute()
        self.assertIs(line.Cable, copy)
        self.assertIs(copy.Centreline, line)


class UndoTest(DocumentTest):
    def setUp(self):
        super().setUp()
        self.doc.UndoMode = 1
        self.cable_between_pins()
        self.compute()
        self.before = seen(self.cable)
        self.wire = self.cable.Centreline.Shape.Length

    def edit(self):
        self.doc.openTransaction("Edit")
        self.cable.Length = "350 mm"
        self.right.Placement.Base += Vector(0, 15, 0)
        self.compute()

    def assertBefore(self):
        now = seen(self.cable)
        self.assertEqual({**now, "State": None}, {**self.before, "State": None})
        self.assertEqual(self.cable.Centreline.Shape.Length, self.wire)
        with no_solve():
            self.compute()
        self.assertEqual(seen(self.cable), self.before)

    def test_undo_and_redo(self):
        self.edit()
        self.doc.commitTransaction()
        edited = seen(self.cable)
        self.assertNotEqual(edited, self.before)
        self.doc.undo()
        self.assertBefore()
        self.doc.redo()
        with no_solve():
            self.compute()
        self.assertEqual(seen(self.cable), edited)

    def test_abort(self):
        self.edit()
        self.doc.abortTransaction()
        self.assertBefore()

    def test_undo_of_an_error(self):
        self.doc.openTransaction("Edit")
        self.cable.Length = "50 mm"
        self.assertFailed(self.cable, "Length")
        self.doc.commitTransaction()
        self.doc.undo()
        self.assertBefore()

    def test_undo_of_making_it(self):
        names = {obj.Name for obj in self.doc.Objects}
        self.doc.openTransaction("Make")
        make.cable(self.doc, start=self.start, end=self.end, slack=0.5)
        self.compute()
        self.doc.commitTransaction()
        self.doc.undo()
        self.assertEqual({obj.Name for obj in self.doc.Objects}, names)
        self.doc.redo()
        self.compute()
        self.assertEqual(self.doc.Cable001.SolvedLength.Value, 180)


class DeleteTest(DocumentTest):
    def setUp(self):
        super().setUp()
        self.cable_between_pins()
        self.route = make.route(self.doc, self.cable)
        self.compute()

    def test_a_deleted_cable_leaves_its_terminals(self):
        line = self.cable.Centreline
        self.doc.removeObject(self.cable.Name)
        for child in (line, self.route):
            self.assertFailed(child, "Cable: is empty")
            self.assertTrue(child.Shape.isNull())
            self.doc.removeObject(child.Name)
        self.compute()
        again = make.cable(self.doc, start=self.start, end=self.end, length="300 mm")
        self.compute()
        self.assertIs(again.CableType, self.type)

    def test_a_deleted_centreline_is_not_missed(self):
        self.doc.removeObject(self.cable.Centreline.Name)
        self.cable.Length = "310 mm"
        self.compute()
        self.assertIsNone(self.cable.Centreline)

    def test_a_deleted_terminal_is_named(self):
        self.doc.removeObject(self.end.Name)
        self.assertFailed(self.cable, "End: is empty")
        self.assertNothingShown(self.cable)
