# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cable with supports: the scene it states and the answer it gives."""

import math

import Part
from FreeCAD import Placement, Rotation, Vector
from reader import seen
from scenes import SupportedTest

from freecad_cable.document import make
from freecad_cable.document.read_held import read_held
from freecad_cable.document.reference import container


def away(drawn, point):
    """Distance [mm] of a point from a line."""
    return drawn.Shape.distToShape(Part.Vertex(Vector(*point)))[0]


class SceneTest(SupportedTest):
    def stated(self):
        """The supports of the scene; the cable is not solved."""
        for support in self.cable.Supports:
            support.recompute()
        return read_held(self.cable).supports

    def test_what_each_kind_states(self):
        for kind, arguments in (
            ("ring", {"clearance": "1 mm"}),
            ("sleeve", {"position": "120 mm"}),
            ("clip", {"position": "140 mm"}),
            ("clamp", {"position": "160 mm"}),
        ):
            made = self.support(kind, **arguments)
            made.Label = f"The {kind}"
        ring, sleeve, clip, clamp = self.stated()
        for held, kind, position in (
            (ring, "ring", None),
            (sleeve, "sleeve", 0.12),
            (clip, "clip", 0.14),
            (clamp, "clamp", 0.16),
        ):
            self.assertEqual((held.kind, held.arc_length), (kind, position))
            self.assertEqual(held.place, f"support The {kind}")
            self.assertNear(held.position, (0.06, 0.02, 0.06))
        self.assertAlmostEqual(ring.radius, 0.009, delta=1e-12)
        self.assertAlmostEqual(abs(ring.axis[0]), 1, delta=1e-12)

    def test_the_cable_passes_from_the_terminal_before_to_the_one_after(self):
        """Whatever way the edge looks; ``Reverse`` turns it."""
        for turn in (0, 180):
            self.part.Placement.Rotation = Rotation(Vector(0, 0, 1), Vector(1, 0, 0)) * Rotation(
                Vector(1, 0, 0), turn
            )
            for kind in ("sleeve", "clamp"):
                made = self.support(kind, position="150 mm")
                for reverse in (False, True):
                    made.Reverse = reverse
                    self.assertNear(self.way(*self.stated()), (-1 if reverse else 1, 0, 0))
                made.Reverse = False
                self.cable.Start, self.cable.End = self.cable.End, self.cable.Start
                self.assertNear(self.way(*self.stated()), (-1, 0, 0))
                self.cable.Start, self.cable.End = self.cable.End, self.cable.Start
                self.cable.Supports = []

    def way(self, held):
        if held.kind == "sleeve":
            return held.tangent
        w, x, y, z = held.quaternion
        return Rotation(x, y, z, w).multVec(Vector(0, 0, 1))

    def test_the_supports_around_decide_the_way_too(self):
        """The cable goes past the plate, and comes back through it to its end."""
        self.cable.Length = "800 mm"
        far = self.support("sleeve")
        far.Offset = Placement(Vector(0, 0, 200), Rotation())
        self.support("sleeve")
        far, back = self.stated()
        self.assertGreater(far.tangent @ (1, 0, 0), 0.99)
        self.assertLess(back.tangent @ (1, 0, 0), -0.99)
        self.cable.Supports = self.cable.Supports[1:]
        (alone,) = self.stated()
        self.assertGreater(alone.tangent @ (1, 0, 0), 0.99)

    def test_without_a_terminal_the_other_neighbour_decides(self):
        self.end.Condition = "Free"
        self.support("sleeve")
        (held,) = self.stated()
        self.assertGreater(held.tangent @ (1, 0, 0), 0.99)

    def test_slack_is_over_the_supports(self):
        self.cable.LengthMode, self.cable.Slack = "Slack", 0.25
        self.support("ring")
        self.doc.recompute()
        over = 2 * math.sqrt(60**2 + 20**2 + 60**2)
        self.assertAlmostEqual(self.cable.SolvedLength.Value / (1.25 * over), 1, delta=1e-12)


class AnswerTest(SupportedTest):
    def passes(self, point, distance):
        """That the centreline comes as near as ``distance`` [mm] to a point."""
        return away(self.cable.Centreline, point) <= distance

    def test_the_cable_passes_its_supports(self):
        for kind, play in (("ring", 6.5), ("sleeve", 0), ("clip", 0), ("clamp", 0)):
            position = {"position": "150 mm"} if kind in ("clip", "clamp") else {}
            self.support(kind, **position)
            self.compute()
            # The curve is within 1e-6 of the length of the nodes, and those within 1e-5 of where they are held.
            self.assertTrue(self.passes((60, 20, 60), play + 300 * 2e-5), kind)
            self.assertEqual(len(self.cable.Shape.Solids), 1)
            self.cable.Supports = []

    def test_all_that_holds_it_carries_its_weight(self):
        """Free body, forces and moments about the start."""
        self.support("sleeve")
        self.compute()
        cable = self.cable
        weight = Vector(0, 0, -9.81) * cable.Mass
        (force,), (moment,) = cable.SupportForces, cable.SupportMoments
        total = cable.StartForce + cable.EndForce + force + weight
        self.assertNear(total, (0, 0, 0), 1e-6 * weight.Length)
        turning = cable.StartMoment + cable.EndMoment + moment
        turning += Vector(0.12, 0, 0).cross(cable.EndForce)
        turning += Vector(0.06, 0.02, 0.06).cross(force) + (cable.CentreOfMass * 1e-3).cross(weight)
        self.assertNear(turning, (0, 0, 0), 1e-4 * weight.Length * 0.12)
        self.assertGreater(force.Length, 1e-3)

    def test_it_follows_the_plate(self):
        self.support("sleeve")
        self.compute()
        before = self.cable.SolvedInputs
        self.part.Placement.Base += Vector(5, -10, 8)
        self.part.purgeTouched()
        self.compute()
        self.assertNotEqual(self.cable.SolvedInputs, before)
        self.assertTrue(self.passes((65, 10, 68), 300 * 2e-5))

    def test_every_property_changes_the_answer_and_a_name_does_not(self):
        clamp = self.support("clamp", position="150 mm")
        self.compute()
        for name, value in (
            ("Position", "160 mm"),
            ("Slides", True),
            ("Roll", "20 deg"),
            ("Offset", Placement(Vector(0, 3, 0), Rotation())),
        ):
            before, old = self.cable.SolvedInputs, getattr(clamp, name)
            setattr(clamp, name, value)
            self.compute()
            self.assertNotEqual(self.cable.SolvedInputs, before, name)
            setattr(clamp, name, old)
            self.compute()
            self.assertEqual(self.cable.SolvedInputs, before, name)
        clamp.Label = "Another name"
        self.cable.touch()
        self.compute()
        self.assertEqual(self.cable.SolvedInputs, before)

    def test_a_route_passes_the_supports(self):
        self.support("ring")
        for method in ("Spline", "Chord"):
            route = make.route(self.doc, self.cable, method=method)
            self.compute()
            self.assertLess(
                away(route, (60, 20, 60)), 1e-3 * route.SmallestBendRadius.Value + 1e-6, method
            )

    def test_in_a_container_it_takes_its_supports_along(self):
        made = self.support("ring")
        unit = self.doc.addObject("App::Part", "Unit")
        unit.addObjects([self.left, self.right, self.part])
        unit.addObject(self.cable)
        self.assertIs(container(made), unit)
        self.compute()

    def test_a_deleted_support_is_gone(self):
        made = self.support("ring")
        self.compute()
        held = self.cable.SolvedInputs
        self.doc.removeObject(made.Name)
        self.compute()
        self.assertEqual(self.cable.Supports, [])
        self.assertEqual(self.cable.SupportForces, [])
        self.assertNotEqual(self.cable.SolvedInputs, held)

    def test_after_an_error_it_is_solved_again(self):
        for kind, position in (("ring", {}), ("clamp", {"position": "150 mm"})):
            with self.subTest(kind):
                self.support(kind, **position)
                self.compute()
                radius, force = self.cable.SmallestBendRadius.Value, self.cable.EndForce
                self.cable.Length = "50 mm"
                self.doc.recompute()
                self.assertFalse(self.cable.isValid())
                self.assertEqual(self.cable.SupportForces, [])
                self.cable.Length = "300 mm"
                self.compute()
                self.assertNear(self.cable.EndForce, force, 1e-4 * force.Length)
                self.assertAlmostEqual(self.cable.SmallestBendRadius.Value / radius, 1, delta=1e-3)
                self.cable.Supports = []

    def test_undo_and_copy(self):
        self.doc.UndoMode = 1
        made = self.support("ring")
        self.compute()
        before = seen(self.cable)
        self.doc.openTransaction("Edit")
        self.cable.Supports = []
        self.compute()
        self.doc.commitTransaction()
        self.doc.undo()
        self.compute()
        self.assertEqual(seen(self.cable), before)
        copy = self.doc.copyObject(self.cable, True)
        self.compute()
        self.assertIsNot(copy.Supports[0], made)
        self.assertEqual(copy.SupportForces, self.cable.SupportForces)
        copy.Supports[0].Reference[0][0].Placement.Base += Vector(0, 5, 0)
        self.compute()
        self.assertEqual(seen(self.cable), before)


class ShapeTest(SupportedTest):
    def test_the_centreline_bends_on_either_side_of_a_sleeve_as_its_moments_say(self):
        self.part.Placement.Rotation = Rotation(Vector(0, 0, 1), Vector(1, 0.4, 0))
        self.support("sleeve")
        self.end.Roll = "180 deg"
        self.compute()
        cable, (node,) = self.cable, self.cable.NodeOfSupport
        curve = cable.Centreline.Shape.Edges[0].Curve
        at = 1e3 * cable.NodeArcLength[node]
        before = cable.NodeMoment[node]
        after = before - cable.SupportMoments[0]
        axis = curve.tangent(at)[0]
        for moment, here in ((before, at - 1e-3), (after, at + 1e-3)):
            # t' = m × t / EI. Beyond a support curvature is extrapolated from the nodes, to second order.
            bend = moment.cross(axis) / 1.1785881e-3 * 1e-3
            self.assertNear(curve.getDN(here, 2), bend, 0.03 * bend.Length)
