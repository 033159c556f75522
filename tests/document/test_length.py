# SPDX-License-Identifier: LGPL-2.1-or-later
"""The length as the answer, and the bend radius checked or enforced."""

from FreeCAD import Vector
from scenes import DocumentTest

from freecad_cable.document import make
from freecad_cable.document.read_scene import read_scene
from freecad_cable.document.stored_solution import kept

# Of the ends of the interval of lengths, relative: equilibrium.length_design.PRECISION.
PRECISION = 1e-5

FOUND = ("ShortestLength", "LongestLength", "LengthLimits")


class ShortestTest(DocumentTest):
    def setUp(self):
        super().setUp()
        self.cable_between_pins()
        # Without it the frames of the two pins ask for half a turn of twist.
        self.end.Roll = "180 deg"
        self.type.BendRadiusConvention = "Centreline"

    def test_just_shorter_violates_and_just_longer_does_not(self):
        self.type.MinBendRadius = "40 mm"
        self.cable.LengthMode = "Shortest"
        self.compute()
        shortest = self.cable.ShortestLength.Value
        self.assertEqual(self.cable.SolvedLength.Value, shortest)
        self.assertGreaterEqual(self.cable.BendRadiusMargin.Value, 0)
        self.assertGreater(self.cable.LongestLength.Value, shortest)
        self.assertEqual(len(self.cable.LengthLimits), 2)
        for sentence in self.cable.LengthLimits:
            self.assertIn(sentence, self.cable.Status)
        self.assertRegex(
            self.cable.Status, rf"If shorter than {shortest:.6g} mm, it bends to .* mm at .* mm"
        )
        self.assertIn("40 mm is the limit", self.cable.Status)
        self.cable.LengthMode = "Fixed"
        for share, holds in ((1 - 2 * PRECISION, False), (1 + 2 * PRECISION, True)):
            self.cable.Length = shortest * share
            self.compute()
            self.assertEqual(self.cable.BendRadiusMargin.Value >= 0, holds)
            self.assertEqual("Warning" in self.cable.Status, not holds)
        self.assertEqual((self.cable.ShortestLength.Value, self.cable.LengthLimits), (0, []))

    def test_no_length_will_do(self):
        self.type.MinBendRadius = "300 mm"
        self.cable.LengthMode = "Shortest"
        said = self.assertFailed(
            self.cable, "LengthMode: is Shortest", "300 mm is the limit", "No length up to"
        )
        self.assertNotRegex(said, r"\d m\b")
        self.assertNothingShown(self.cable)

    def test_it_needs_two_ends(self):
        self.end.Condition, self.cable.LengthMode = "Free", "Shortest"
        self.assertFailed(self.cable, "LengthMode: is Shortest, but an end is free")

    def test_the_catenary_beside_it_has_the_length_that_was_found(self):
        self.type.MinBendRadius = "40 mm"
        route = make.route(self.doc, self.cable, method="Catenary")
        self.cable.LengthMode = "Shortest"
        self.compute()
        self.assertAlmostEqual(route.Length.Value / self.cable.ShortestLength.Value, 1, delta=1e-9)
        self.type.MinBendRadius = "300 mm"
        self.doc.recompute()
        self.assertTrue(route.Shape.isNull())

    def test_what_is_shown(self):
        for name in FOUND:
            self.assertIn("Hidden", self.cable.getEditorMode(name))
        self.cable.LengthMode = "Shortest"
        for name in FOUND:
            self.assertEqual(self.cable.getEditorMode(name), ["ReadOnly"])
        for name in ("Length", "Slack"):
            self.assertEqual(self.cable.getEditorMode(name), ["Hidden"])


class BendRadiusTest(DocumentTest):
    def setUp(self):
        super().setUp()
        self.cable_between_pins()
        self.end.Roll = "180 deg"
        self.compute()
        self.free = self.cable.SmallestBendRadius.Value

    def test_enforced(self):
        """Within the spacing of nodes: between them the bend radius is a tolerance of the mesh."""
        limit = 1.05 * self.free
        # Solved again from another start: the same to a few nanometres.
        self.type.BendRadiusConvention, self.type.MinBendRadius = "Centreline", limit
        self.compute()
        self.assertAlmostEqual(self.cable.BendRadiusMargin.Value, self.free - limit, delta=1e-6)
        self.assertIn("Warning: the tightest bend", self.cable.Status)
        self.assertEqual(self.cable.FormedPlaces, [])
        self.cable.BendRadiusMode = "Enforce"
        self.compute()
        self.assertAlmostEqual(self.cable.SmallestBendRadius.Value / limit, 1, delta=5e-3)
        self.assertNotIn("Warning", self.cable.Status)
        self.assertTrue(self.cable.FormedPlaces)
        for sentence in self.cable.FormedPlaces:
            self.assertRegex(
                sentence, r"From .* mm to .* mm .* formed there, with a moment of .* N m"
            )
            self.assertIn(sentence, self.cable.Status)

    def test_the_warning_is_in_the_convention_of_the_type(self):
        self.type.MinBendRadius = "60 mm"
        self.compute()
        self.assertAlmostEqual(self.cable.BendRadiusMargin.Value, self.free - 3.5 - 60, delta=1e-6)
        self.assertIn(f"the tightest bend, {self.free - 3.5:.4g} mm at", self.cable.Status)
        self.assertIn("tighter than the 60 mm", self.cable.Status)
        self.assertIn("(at the inside of the bend)", self.cable.Status)

    def test_nothing_to_enforce(self):
        self.cable.BendRadiusMode = "Enforce"
        self.assertFailed(
            self.cable, "BendRadiusMode: is Enforce, but", self.type.Label, "MinBendRadius"
        )


class ContactTest(DocumentTest):
    def test_forces_and_places(self):
        """A plate above the arch presses it down: with the connectors it carries the weight."""
        self.cable_between_pins()
        self.end.Roll = "180 deg"
        plate = self.doc.addObject("Part::Box", "Plate")
        plate.Length, plate.Width, plate.Height = 300, 200, 5
        self.compute()
        top = max(point.z for point in self.cable.NodePosition) * 1e3
        plate.Placement.Base = Vector(-90, -100, top - 5 + 3.5)
        self.cable.Obstacles = plate
        self.compute()
        cable = self.cable
        self.assertEqual(set(cable.ContactObstacles), {"Plate"})
        self.assertEqual(len(cable.ContactForces), len(cable.ContactPlaces))
        push = sum(cable.ContactForces, Vector())
        self.assertLess(push.z, 0)
        weight = Vector(0, 0, -9.81) * cable.Mass
        # Loads are first order in the error of position; a factor of 10 for their derivatives.
        self.assertNear(
            cable.StartForce + cable.EndForce + push + weight, (0, 0, 0), 1e-3 * push.Length
        )
        # Symmetric in x about the middle.
        places = cable.ContactPlaces
        self.assertAlmostEqual((places[0] + places[-1]) / 2, 150, delta=0.01 * 300)
        self.assertAlmostEqual(cable.SmallestClearance.Value, 0, delta=0.01 * 3.5)
        # What the next solve starts from knows it too, for it need not refine again what is fine enough.
        start = kept(cable, read_scene(cable))
        self.assertEqual([1e3 * contact.arc_length for contact in start.contacts], list(places))
        self.assertEqual(1e3 * start.position_error, cable.ErrorEstimate.Value)
        cable.Obstacles = None
        self.compute()
        self.assertEqual((cable.ContactForces, cable.ContactPlaces), ([], []))
