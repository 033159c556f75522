# SPDX-License-Identifier: LGPL-2.1-or-later
"""Studies among obstacles: what only some of their cases reach counts, too."""

import math

from FreeCAD import Vector
from studies import StudyTest


class TestObstacles(StudyTest):
    """A lid that the cable does not reach as it is, but that it would if it were longer."""

    def setUp(self):
        super().setUp()
        self.end.Condition = "Swivel"
        self.lid = self.doc.addObject("Part::Box", "Lid")
        self.lid.Length, self.lid.Width, self.lid.Height = 400, 400, 2
        self.lid.Placement.Base = Vector(-140, -200, 74)
        self.cable.Length, self.cable.Obstacles, self.cable.Clearance = 180, [self.lid], 2
        self.compute()
        self.assertEqual(self.cable.SmallestClearance.Value, math.inf)

    def is_out_of_date_when_the_lid_moves(self, study):
        self.run_unchanged(study)
        self.doc.recompute()
        self.assertFalse(study.OutOfDate)
        self.lid.Placement.Base.z = 76
        self.doc.recompute()
        self.assertEqual(self.cable.SmallestClearance.Value, math.inf)
        return study.OutOfDate

    def test_what_only_a_longer_cable_reaches(self):
        study = self.study(kind="Random", cases=20, seed=1)
        self.assertTrue(self.is_out_of_date_when_the_lid_moves(study))
        self.lid.Placement.Base.z = 74
        self.compute()
        self.run_unchanged(study)
        self.assertLess(study.Share, 1)
        self.assertAlmostEqual(study.SmallestClearance.Value, 2, delta=0.01)
        self.assertIn("pushed from obstacle Lid", study.Notes[1])
        self.cable.Length = max(map(float, self.column(study, "Length [")))
        self.compute()
        self.assertEqual(self.cable.ContactObstacles, ["Lid"])

    def test_what_only_a_moved_end_reaches(self):
        given = {"kind": "Corners", "length_tolerance": False, "position_tolerance": "20 mm"}
        study = self.run_unchanged(self.study(**given))
        self.assertAlmostEqual(study.SmallestClearance.Value, 2, delta=0.01)

    def test_what_only_another_value_reaches(self):
        study = self.study(varied="Length", values=[180, 220])
        self.assertTrue(self.is_out_of_date_when_the_lid_moves(study))
        self.assertAlmostEqual(study.SmallestClearance.Value, 2, delta=0.01)

    def test_what_forbids_more_length(self):
        self.type.MinBendRadius = "40 mm"
        self.cable.Length = 150
        self.compute()
        apart = [118, 158]  # more than the length that the cable has now
        study = self.study(self.right, "Placement.Base.x", values=apart, find_needed_length=True)
        self.run_unchanged(study)
        self.cable.LengthMode = "Shortest"
        lengths = []
        for there in apart:
            self.right.Placement.Base.x = there
            self.compute()
            lengths.append((self.cable.ShortestLength.Value, self.cable.LongestLength.Value))
        needed, allowed = zip(*lengths, strict=True)
        self.assertAlmostEqual(study.NeededLength.Value, max(needed), delta=0.1)
        self.assertAlmostEqual(study.AllowedLength.Value, min(allowed), delta=0.1)

    def test_one_position_that_needs_more_than_another_allows(self):
        self.type.MinBendRadius = "40 mm"
        self.lid.Placement.Base.z = 76
        self.cable.Length = 260
        self.compute()
        given = {"values": [0, 250], "find_needed_length": True}
        study = self.run_unchanged(self.study(self.right, "Placement.Base.y", **given))
        self.assertGreater(study.NeededLength.Value, study.AllowedLength.Value)
        self.assertRegex(
            study.Notes[0], "^No length will do everywhere: 250 needs .* mm, and 0 allows"
        )

    def test_an_obstacle_that_passes_by(self):
        study = self.study(self.lid, "Placement.Base.z", values=[300, 60, 320, 340, 360])
        self.run_unchanged(study)
        self.assertEqual(study.SmallestClearanceValue, 60)

    def test_an_obstacle_that_only_longer_cables_reach(self):
        self.type.MinBendRadius = "30 mm"
        self.compute()
        given = {"values": [76, 78], "find_needed_length": True}
        study = self.run_unchanged(self.study(self.lid, "Placement.Base.z", **given))
        self.assertLess(study.AllowedLength.Value, 220)
