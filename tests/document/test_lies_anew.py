# SPDX-License-Identifier: LGPL-2.1-or-later
"""What lies on an obstacle and is moved: it follows from where it lies, or says that it does not."""

from FreeCAD import Placement, Rotation, Vector
from scenes import TOP, DocumentTest

from freecad_cable.document import make

ANEW = "it does not lie as before"


class LiesAnewTest(DocumentTest):
    """A cable that passes below a bar."""

    def setUp(self):
        super().setUp()
        self.left = self.pin("Left", (0, 0, 0), (1, 0, 0))
        self.right = self.pin("Right", (400, 0, 0), (1, 0, 0))
        kind = make.cable_type(
            self.doc,
            "Thin",
            outer_diameter="6 mm",
            mass_per_length="0.01 kg/m",
            bending_stiffness="5e-3 N*m^2",
            torsional_stiffness="4e-3 N*m^2",
        )
        self.bar = self.doc.addObject("Part::Cylinder", "Bar")
        self.bar.Radius, self.bar.Height = 5, 401
        along = Rotation(Vector(0, 0, 1), Vector(0, 400, -20))
        self.bar.Placement = Placement(Vector(300, -200, -100), along)
        self.doc.recompute()
        start = make.terminal(self.doc, (self.left, TOP))
        end = make.terminal(self.doc, (self.right, TOP), condition="Pinned")
        self.cable = make.cable(
            self.doc, start=start, end=end, cable_type=kind, length="500 mm", obstacles=[self.bar]
        )
        self.compute()
        self.assertLess(self.height(), -110)

    def height(self):
        """[mm] of the cable where the bar is."""
        nearest = min(self.cable.NodePosition, key=lambda place: abs(place[0] - 0.3))
        return 1e3 * nearest[2]

    def lift(self, height):
        self.right.Placement.Base.z = height
        self.compute()

    def test_it_stays_below(self):
        self.lift(23)
        self.assertLess(self.height(), -110)
        self.assertNotIn(ANEW, self.cable.Status)

    def test_it_is_too_short_to_stay_below(self):
        self.lift(30)
        self.assertGreater(self.height(), -110)
        self.assertIn(ANEW, self.cable.Status)
        self.cable.touch()
        self.compute()
        self.assertIn(ANEW, self.cable.Status)
        self.lift(31)
        self.assertNotIn(ANEW, self.cable.Status)

    def test_undone_it_starts_from_where_it_is(self):
        """The scene that its nodes are from is no longer known, but they tell what held them."""
        self.doc.UndoMode = 1
        for height in (23, 30):
            self.doc.openTransaction("Lift")
            self.lift(height)
            self.doc.commitTransaction()
            self.doc.undo()
            self.compute()
            self.lift(23)
            self.assertLess(self.height(), -110)
            self.assertNotIn(ANEW, self.cable.Status)
            self.lift(0)

    def test_it_goes_with_a_bar_that_is_lowered(self):
        self.lift(10)
        self.assertEqual(len(self.cable.ContactForces), 1)
        self.bar.Placement.Base.z -= 10
        self.compute()
        self.assertLess(self.height(), -120)
        self.assertNotIn(ANEW, self.cable.Status)


class StretchTest(DocumentTest):
    def test_what_has_not_changed_is_not_solved_again(self):
        left, right = self.pin("Left", (0, 0, 0)), self.pin("Right", (120, 0, 0))
        middle = self.pin("Middle", (60, 0, 80), (1, 0, 0))
        self.doc.recompute()
        start, end = (make.terminal(self.doc, (pin, TOP)) for pin in (left, right))
        clamp = make.clamp(self.doc, (middle, TOP), position="150 mm")
        kind = make.cable_type(self.doc, "Multi-core cable 7 mm")
        cable = make.cable(
            self.doc, start=start, end=end, cable_type=kind, length="300 mm", supports=[clamp]
        )
        self.compute()
        kept = "Left out: 1 of 2 stretches: unchanged since the last solution (exact)"
        self.assertNotIn(kept, cable.ModelUsed)
        before = cable.NodePosition
        right.Placement.Base.x += 3
        self.compute()
        self.assertIn(kept, cable.ModelUsed)
        half = cable.NodeOfSupport[0] + 1
        self.assertEqual(cable.NodePosition[:half], before[:half])
