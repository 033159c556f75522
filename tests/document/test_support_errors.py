# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a cable says of supports that are wrong: a sentence, and it shows nothing old."""

from FreeCAD import Placement, Rotation, Vector
from scenes import TOP, SupportedTest

from freecad_cable.document import make


class ErrorTest(SupportedTest):
    def check(self, *words):
        sentence = self.assertFailed(self.cable, "Supports", *words)
        self.assertNothingShown(self.cable)
        self.assertEqual(self.cable.SupportForces, [])
        return sentence

    def test_order(self):
        first, second = (self.support("clip", position=f"{at} mm") for at in (140, 165))
        second.Offset = Placement(Vector(0, 0, 20), Rotation())
        self.compute()
        first.Label, second.Label = "First clip", "Second clip"
        self.cable.Supports = [second, first]
        self.check("First clip, Position", "140 mm", "support Second clip", "165 mm", "in order")
        first.Position = "165 mm"
        self.check("First clip, Position", "165 mm", "in order")
        self.cable.Supports = [first, second]
        first.Position, second.Position = "140 mm", "300 mm"
        self.check("Second clip, Position", "not on the cable", "300 mm")

    def test_a_ring_that_is_too_small(self):
        ring = self.support("ring", clearance="7 mm")
        ring.Label = "Eye at 2 m"
        self.check("Eye at 2 m, Radius", " 3 mm", "3.5 mm", "does not pass")
        ring.Clearance = "6.5 mm"
        self.compute()

    def test_too_far_away(self):
        ring = self.support("ring")
        self.part.Placement.Base.z = 500
        sentence = self.assertFailed(self.cable, "Length", "through its supports")
        self.assertIn("shortest possible length", sentence)
        self.assertNothingShown(self.cable)
        self.end.Condition = "Free"
        self.check(ring.Label, "away from start", "does not reach")

    def test_clamps_too_close_together(self):
        self.support("clamp", position="100 mm").Label = "A.1"
        far = self.support("clamp", position="110 mm")
        far.Label, far.Offset = "B at 0.2 m", Placement(Vector(0, 0, 30), Rotation())
        self.check(
            "B at 0.2 m, Position",
            "support B at 0.2 m",
            "10 mm of cable",
            "support A.1",
            "30 mm apart",
        )

    def test_a_support_without_its_part(self):
        made = self.support("ring")
        self.compute()
        self.doc.removeObject("Plate")
        self.doc.recompute()
        self.assertNothingShown(self.cable)
        self.assertIn(f"{made.Label}, Reference: is empty", self.cable.Status)
        self.cable.touch()
        self.cable.recompute()
        self.assertIn(f"{made.Label}, Reference: is empty", self.cable.Status)

    def test_what_is_no_support(self):
        self.cable.Supports = [self.left]
        self.check("has Left, which is no support")
        self.cable.Supports = [self.start]
        self.check("has Terminal, which is no support")

    def test_the_same_support_twice(self):
        ring = make.ring(self.doc, self.hole)
        self.cable.Supports = [ring, ring]
        self.check("has Ring twice")

    def test_a_support_in_another_container(self):
        unit = self.doc.addObject("App::Part", "Unit")
        unit.addObject(self.pin("Inner", (0, 80, 0)))
        self.doc.recompute()
        inner = make.ring(self.doc, (unit, f"Inner.{TOP}"), inside=unit)
        self.cable.Supports = [inner]
        self.check("has Ring", "another part or assembly")

    def test_nothing_holds_the_cable(self):
        self.support("ring")
        self.start.Condition = self.end.Condition = "Free"
        self.check("slide out", "give a support an arc length")
