# SPDX-License-Identifier: LGPL-2.1-or-later
"""Studies that cannot be run, that are stopped, and whose answer is no longer one."""

import math
from unittest import mock

import FreeCAD
from FreeCAD import Placement, Rotation, Vector
from studies import StudyTest, state

from freecad_cable.document import make, studying
from freecad_cable.errors import DocumentError


class TestTrouble(StudyTest):
    def refused(self, study, sentence):
        before = state(self.doc)
        with self.assertRaisesRegex(DocumentError, sentence):
            studying.run(study)
        self.assertEqual(state(self.doc), before)
        self.assertTrue(study.Shape.isNull())
        self.assertRegex(study.Status, sentence)

    def test_what_cannot_be_varied(self):
        self.refused(self.study(varied="Lenght", start=1, stop=2), "no number")
        self.refused(self.study(self.right, "Label", start=1, stop=2), "no number")
        self.refused(self.study(self.right, "Placement.Base", start=1, stop=2), "no number")

    def test_what_does_not_matter(self):
        self.refused(self.study(varied="Slack", start=0.1, stop=0.2), "does not change the cable")

    def test_a_needed_length_of_a_free_end(self):
        self.end.Condition = "Free"
        self.compute()
        given = {"varied": "Gravity.x", "start": 0, "stop": 5, "find_needed_length": True}
        self.refused(self.study(**given), "FindNeededLength: is on, but an end is free")

    def test_no_range(self):
        self.refused(self.study(varied="Length", start=300, stop=300), "so is From")
        self.refused(self.study(varied="Length", start=300, stop=400, count=1), "at least 2")
        self.refused(self.study(varied="Length", start=300, stop=math.nan), "To: is nan")
        self.refused(self.study(varied="Length", values=[300, math.inf]), "Values: has inf")

    def test_it_says_the_property_that_states_what_is_wrong(self):
        self.refused(self.study(kind="Random", cases=0), "^Study, Cases: is 0; it must be")
        self.refused(self.study(kind="Random", seed=-1), "^Study001, Seed: is -1; it must be")
        self.type.MinBendRadius = "500 mm"
        self.compute()
        given = {"values": [100, 110], "find_needed_length": True}
        study = self.study(self.right, "Placement.Base.x", **given)
        self.run_unchanged(study)
        self.assertIn(
            "No length will do everywhere. Study002, FindNeededLength: at 100:", study.Notes[0]
        )
        self.assertEqual(self.column(study, "Length ["), ["300", "300"])
        huge = self.study(varied="Length", start=1e300, stop=1e301)
        self.refused(huge, "^Study003, From: is 1e.300; it must be")
        huge = self.study(varied="Length", values=[1e300, 1e301])
        self.refused(huge, "Cable, Length: is 1e.300 mm; it must be")

    def test_what_it_varies_is_deleted_while_it_runs(self):
        box = self.doc.addObject("Part::Box", "Away")
        self.cable.setExpression("Length", "30 * Away.Length")
        self.compute()
        study = self.study(box, "Length", start=10, stop=12, count=3)
        followed = studying.follow

        def gone(*given, **more):
            self.doc.removeObject("Away")
            yield from followed(*given, **more)

        with (
            mock.patch.object(studying, "follow", gone),
            self.assertRaisesRegex(DocumentError, "what it needs was deleted while it ran"),
        ):
            studying.run(study)

    def test_an_executor_that_breaks_down(self):
        """What the study said before is not what it says of this run."""
        study = self.study(kind="Random", cases=2, length_tolerance=True)
        studying.run(study)
        self.assertTrue(study.Share)
        broken = mock.Mock(**{"submit.side_effect": RuntimeError("no workers")})
        with self.assertRaisesRegex(RuntimeError, "no workers"):
            studying.run(study, executor=broken)
        self.assertEqual(study.Status, "Study: RuntimeError: no workers")
        self.assertEqual(study.Share, 0)
        self.assertTrue(study.Shape.isNull())

    def test_cases_that_are_none(self):
        ring = make.ring(self.doc, self.plate("Plate", (60, 20, 60), (1, 0, 0)), position="150 mm")
        self.cable.Supports = [ring]
        self.compute()
        study = self.study(kind="Corners", position_tolerance="1 m", length_tolerance=False)
        self.run_unchanged(study)
        said = [*study.Notes, *self.column(study, "Note")]
        self.assertIn("Ring, Position, leaves 150 mm of cable between", said[1])
        self.assertEqual([text for text in said if "support Ring" in text.partition(":")[0]], [])

    def test_cases_that_are_too_short(self):
        study = self.study(kind="Corners", position_tolerance="1 m", length_tolerance=False)
        self.run_unchanged(study)
        self.assertIn("worst: its length is 300 mm, but", study.Notes[1])
        self.assertIn("its length is 300 mm, but", self.column(study, "Note")[0])

    def test_nothing_can_be_solved(self):
        self.refused(self.study(varied="Length", start=10, stop=20), "shortest possible length")

    def test_an_abort_in_the_middle(self):
        study = self.study(self.right, "Placement.Base.x", start=100, stop=140, count=9)
        self.interrupted(study, FreeCAD.Base.FreeCADAbort("stop"), "was stopped")

    def test_an_abort_while_it_looks_for_the_length(self):
        given = {"values": [100, 110, 120], "find_needed_length": True}
        study, ticks = self.study(self.right, "Placement.Base.x", **given), []

        class Bar:
            start = stop = lambda *_: None

            def next(self, can_abort):
                ticks.append(can_abort)
                if len(ticks) == 4:
                    raise FreeCAD.Base.FreeCADAbort("stop")

        with mock.patch.object(FreeCAD.Base, "ProgressIndicator", Bar):
            self.refused(study, "was stopped")
        self.assertEqual(ticks, [True] * 4)

    def test_an_error_in_the_middle(self):
        study = self.study(self.right, "Placement.Base.x", start=100, stop=140, count=9)
        before = state(self.doc)
        with (
            self.after_three(RuntimeError("broken")),
            self.assertRaisesRegex(RuntimeError, "broken"),
        ):
            studying.run(study)
        self.assertEqual(state(self.doc), before)

    def interrupted(self, study, error, sentence):
        with self.after_three(error):
            self.refused(study, sentence)

    def after_three(self, error):
        real, calls = studying.Family.scene, []

        def scene(family, value, *asks_length):
            calls.append(value)
            if len(calls) > 6:
                raise error
            return real(family, value, *asks_length)

        return mock.patch.object(studying.Family, "scene", scene)

    def test_a_cable_that_is_not_solved(self):
        study = self.study(varied="Length", start=300, stop=400)
        self.cable.Length = 10
        self.doc.recompute()
        with self.assertRaisesRegex(DocumentError, "shortest possible length"):
            studying.run(study)

    def test_what_is_no_study(self):
        with self.assertRaisesRegex(DocumentError, "must be a cable"):
            make.study(self.doc, self.right)
        with self.assertRaisesRegex(DocumentError, "must be a number with its unit"):
            make.study(self.doc, self.cable, varied="Length", start="wide", stop=3)
        self.assertEqual([o for o in self.doc.Objects if o.Name.startswith("Study")], [])

    def test_what_is_varied_is_deleted(self):
        """It is not a property of the cable with the same name that is varied then."""
        box = self.doc.addObject("Part::Box", "Box")
        study = self.study(box, "Length", start=300, stop=310, count=2)
        self.doc.UndoMode = 1
        self.doc.openTransaction("Delete")
        self.doc.removeObject("Box")
        self.doc.commitTransaction()
        self.refused(study, "VariedProperty: Box.Length of Cable is None")
        self.doc.undo()
        self.assertEqual((study.VariedObject.Name, study.VariedProperty), ("Box", "Length"))

    def test_a_deleted_cable(self):
        study = self.study(varied="Length", start=280, stop=320, count=3)
        self.doc.removeObject(self.cable.Name)
        with self.assertRaisesRegex(DocumentError, "was deleted"):
            studying.run(study)


class TestOutOfDate(StudyTest):
    def test_it_says_when_it_is_out_of_date(self):
        study = self.study(varied="Length", start=280, stop=320, count=3)
        self.doc.recompute()
        self.assertTrue(study.OutOfDate)
        self.assertIn("No results yet", study.Status)
        studying.run(study)
        self.doc.recompute()
        self.assertFalse(study.OutOfDate)
        self.right.Placement = Placement(Vector(125, 0, -10), Rotation())
        self.doc.recompute()
        self.assertTrue(study.OutOfDate)
        self.assertEqual(len(study.Shape.Wires), 3)
        self.assertIn("Out of date", study.Status)

    def test_an_error_of_the_cable_does_not_take_its_answer(self):
        study = self.study(varied="Length", start=280, stop=320, count=3)
        studying.run(study)
        radius = study.SmallestBendRadius
        self.cable.Length = 10
        self.doc.recompute()
        self.assertIn("shortest possible length", study.Status)
        self.assertTrue(study.OutOfDate)
        self.assertEqual(len(study.Shape.Wires), 3)
        self.cable.Length = 300
        self.compute()
        self.assertEqual(study.Status, "")
        self.assertFalse(study.OutOfDate)
        self.assertEqual(study.SmallestBendRadius, radius)

    def test_a_run_that_is_undone(self):
        self.doc.UndoMode = 1
        study = self.study(varied="Length", start=280, stop=320, count=3)
        self.doc.openTransaction("Study")
        studying.run(study)
        self.doc.commitTransaction()
        self.doc.undo()
        self.assertTrue(study.Shape.isNull())
        self.assertTrue(study.OutOfDate)
        self.assertIn("No results yet", study.Status)
        self.doc.redo()
        self.assertEqual(len(study.Shape.Wires), 3)
        self.assertEqual((study.OutOfDate, study.Status), (False, ""))

    def test_a_copy_has_a_sheet_of_its_own(self):
        study = self.study(varied="Length", start=280, stop=320, count=3)
        studying.run(study)
        copy = self.doc.copyObject(study, False)
        self.assertIsNone(copy.Sheet)
        copy.To = 360
        studying.run(copy)
        self.assertEqual(self.column(study, "Length ["), ["280", "300", "320"])
        self.assertEqual(self.column(copy, "Length ["), ["280", "320", "360"])

    def test_a_copy_with_its_sheet(self):
        study = self.study(varied="Length", start=280, stop=320, count=3)
        studying.run(study)
        copy = next(
            obj for obj in self.doc.copyObject([study, study.Sheet], False) if hasattr(obj, "Cable")
        )
        self.assertIsNot(copy.Sheet, study.Sheet)
        self.assertEqual(self.column(copy, "Length ["), ["280", "300", "320"])
