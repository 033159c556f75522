# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cable: what it answers, and that every property changes the answer."""

import math

import Part
from FreeCAD import Placement, Rotation, Vector
from scenes import TOP, DocumentTest

from freecad_cable.document import make
from freecad_cable.document.stored_solution import NODES

# Default tolerance of position, relative to the length.
TOLERANCE = 1e-4


class AnswerTest(DocumentTest):
    def test_table_1(self):
        """The seed paper's cable of 0.73 m, against the strong-form solution of mechanics.md, 2: energy
        0.050253567709 J, tightest bend 50.743386 mm at the end, force and moment at the end. Energy is second
        order in the error of position, loads first; a factor of 10 for their derivatives.
        """
        ends = []
        for position, (w, x, y, z) in (
            ((0, 0, 0), (0.7071, 0.7071, 0, 0)),
            ((160, -235, 330), (0.5, 0.5, 0.5, 0.5)),
        ):
            axes = self.doc.addObject("Part::Feature", "Axes")
            axes.Placement = Placement(Vector(*position), Rotation(x, y, z, w))
            # The paper's frame runs along the cable at both ends, and so into the connector at the end.
            ends.append(make.terminal(self.doc, axes, reverse=bool(ends)))
        kind = make.cable_type(self.doc, "Multi-core cable 7 mm")
        cable = make.cable(self.doc, start=ends[0], end=ends[1], cable_type=kind, length="730 mm")
        self.compute()
        self.assertAlmostEqual(
            (cable.ElasticEnergy + cable.GravityEnergy) / 0.050253567709, 1, delta=TOLERANCE
        )
        self.assertAlmostEqual(cable.ElasticEnergy / 0.02795862169, 1, delta=10 * TOLERANCE)
        self.assertAlmostEqual(cable.SmallestBendRadius.Value / 50.743386, 1, delta=10 * TOLERANCE)
        self.assertAlmostEqual(cable.SmallestBendRadiusAt.Value, 730, delta=1)
        self.assertNear(cable.EndForce, (-0.0497237, 0.0423163, 0.1865051), 10 * TOLERANCE * 0.2)
        self.assertNear(
            cable.EndMoment, (0.00474592, 0.02322586, 0.00016357), 10 * TOLERANCE * 0.024
        )
        weight = 0.4379383301 * 0.73
        self.assertNear(cable.StartForce + cable.EndForce, (0, 0, weight), 1e-6 * weight)
        self.assertLess(cable.ErrorEstimate.Value, 730 * TOLERANCE)
        self.assertLess(cable.BalanceResidual, 10 * TOLERANCE)
        self.assertTrue(cable.Stable)
        self.assertEqual(cable.Status, "The cable is in equilibrium.")

    def test_the_solid_and_its_mass(self):
        cable = self.cable_between_pins()
        self.compute()
        self.assertEqual(len(cable.Shape.Solids), 1)
        self.assertTrue(cable.Shape.isValid())
        area = math.pi * 3.5**2
        self.assertAlmostEqual(cable.Shape.Volume / (area * 300), 1, delta=1e-5)
        self.assertAlmostEqual(cable.Mass, 0.300 * 0.04464203161, delta=1e-12)
        # Of a homogeneous tube the centre of mass is that of its bent solid, but for h²κ² of the section.
        self.assertNear(cable.CentreOfMass, cable.Shape.CenterOfMass, 0.1)

    def test_forces_and_moments_hold_the_weight(self):
        """Free body: what both connectors exert on the cable balances its weight, moments about the start."""
        cable = self.cable_between_pins()
        self.compute()
        weight = Vector(0, 0, -9.81) * cable.Mass
        self.assertNear(cable.StartForce + cable.EndForce + weight, (0, 0, 0), 1e-6 * weight.Length)
        lever, centre = Vector(0.12, 0, 0), cable.CentreOfMass * 1e-3
        moment = cable.StartMoment + cable.EndMoment
        moment += lever.cross(cable.EndForce) + centre.cross(weight)
        self.assertNear(moment, (0, 0, 0), 1e-4 * weight.Length * 0.12)

    def test_of_an_arch_without_twist_each_connector_holds_half(self):
        """As they stand, the frames of the two pins ask for half a turn of twist, which throws the arch sideways."""
        cable = self.cable_between_pins()
        self.end.Roll = "180 deg"
        self.compute()
        half = 9.81 * cable.Mass / 2
        # Loads are first order in the error of position; a factor of 10 for their derivatives.
        self.assertAlmostEqual(cable.StartForce.z / half, 1, delta=10 * TOLERANCE)
        self.assertAlmostEqual(cable.EndForce.z / half, 1, delta=10 * TOLERANCE)
        self.assertAlmostEqual(cable.StartForce.y, 0, delta=10 * TOLERANCE * half)

    def test_both_terminals_look_out_of_their_parts(self):
        """The cable leaves the start upwards and comes down into the end."""
        cable = self.cable_between_pins()
        self.compute()
        wire = cable.Centreline.Shape.Edges[0]
        for at, way in ((wire.FirstParameter, 1), (wire.LastParameter, -1)):
            self.assertNear(wire.tangentAt(at), (0, 0, way), 1e-9)
        self.assertNear(wire.valueAt(wire.FirstParameter), (0, 0, 0), 1e-9)
        # A solver's end yields by 2e-9 of the length, 300 mm, at most.
        self.assertNear(wire.valueAt(wire.LastParameter), (120, 0, 0), 6e-7)

    def test_the_model_says_what_it_left_out(self):
        cable = self.cable_between_pins()
        self.end.Condition = "Swivel"
        self.compute()
        self.assertIn("Kept: gravity", cable.ModelUsed)
        self.assertTrue(any(line.startswith("Left out: torsion") for line in cable.ModelUsed))
        cable.KeepTorsion = True
        cable.Document.recompute()
        self.assertIn("Kept: torsion", cable.ModelUsed)

    def test_it_is_children_know_it_and_it_knows_its_centreline(self):
        cable = self.cable_between_pins()
        self.assertIs(cable.Centreline.Cable, cable)
        self.assertIn(cable.Centreline, cable.InList)
        self.assertNotIn(cable.Centreline, cable.OutList)


class EditTest(DocumentTest):
    """Each input changes what it should, and back gives the first answer again."""

    def setUp(self):
        super().setUp()
        self.cable_between_pins()
        self.compute()

    def answer(self):
        return self.cable.SolvedInputs, self.cable.SweptInputs

    def check(self, obj, name, value, changes=True):
        before, volume = self.answer(), self.cable.Shape.Volume
        old, radius = getattr(obj, name), self.cable.SmallestBendRadius.Value
        setattr(obj, name, value)
        self.compute()
        self.assertEqual(self.answer() != before, changes, name)
        edited = self.cable.SmallestBendRadius.Value
        setattr(obj, name, old)
        self.compute()
        self.assertEqual(self.answer(), before, name)
        # Back, by way of another start of the solver.
        self.assertAlmostEqual(
            self.cable.SmallestBendRadius.Value / radius, 1, delta=10 * TOLERANCE
        )
        self.assertAlmostEqual(self.cable.Shape.Volume / volume, 1, delta=1e-5)
        return edited / radius

    def test_length(self):
        self.assertGreater(self.check(self.cable, "Length", "400 mm"), 1.05)

    def test_length_by_slack(self):
        self.cable.Slack = 0.5
        self.check(self.cable, "LengthMode", "Slack")
        self.cable.LengthMode = "Slack"
        self.compute()
        self.assertAlmostEqual(self.cable.SolvedLength.Value, 120 * 1.5, delta=1e-9)
        self.cable.Slack = 0.75
        self.compute()
        self.assertAlmostEqual(self.cable.SolvedLength.Value, 120 * 1.75, delta=1e-9)

    def test_gravity(self):
        self.check(self.cable, "Gravity", Vector(0, 3, -2))
        self.cable.Gravity = Vector()
        self.compute()
        self.assertEqual(self.cable.GravityEnergy, 0)

    def test_tolerance(self):
        self.check(self.cable, "Tolerance", 1e-6)
        self.cable.Tolerance = 1e-6
        self.compute()
        self.assertLess(self.cable.ErrorEstimate.Value, 300 * 1e-6)

    def test_section(self):
        for name, value in (
            ("OuterDiameter", "6 mm"),
            ("MassPerLength", "90 g/m"),
            ("BendingStiffness", "5e-3 N*m^2"),
            ("SecondBendingStiffness", "3e-3 N*m^2"),
            ("TorsionalStiffness", "1e-3 N*m^2"),
            ("AxialStiffness", "400 N"),
            ("ShearStiffness", "200 N"),
            ("NaturalCurvature", Vector(3, 0, 0)),
        ):
            self.check(self.type, name, value)

    def test_a_material_computes_the_section(self):
        kind = self.type
        kind.Source, kind.YoungsModulus, kind.ShearModulus = "Material", "10 MPa", "20 MPa"
        kind.Density = "1160 kg/m^3"
        before = self.answer()
        self.compute()
        self.assertEqual(self.answer(), before)
        kind.YoungsModulus = "30 MPa"
        self.compute()
        self.assertNotEqual(self.answer(), before)

    def test_conditions_of_both_terminals(self):
        for terminal in (self.start, self.end):
            for condition in ("Swivel", "Pinned", "Free"):
                self.check(terminal, "Condition", condition)

    def test_terminals(self):
        self.check(self.start, "Roll", "40 deg")
        self.check(self.end, "Offset", Placement(Vector(5, 0, 0), Rotation()))
        self.check(self.start, "Reference", [(self.left, "Vertex1")])
        third = make.terminal(self.doc, (self.pin("Third", (120, 50, 0)), TOP))
        self.check(self.cable, "End", third)

    def test_the_tightest_bend_against_the_limit(self):
        radius = self.cable.SmallestBendRadius.Value
        self.assertAlmostEqual(self.cable.BendRadiusMargin.Value, radius)
        self.type.MinBendRadius = "30 mm"
        self.compute()
        self.assertAlmostEqual(self.cable.BendRadiusMargin.Value, radius - 33.5, delta=1e-2)
        self.type.BendRadiusConvention = "Centreline"
        self.compute()
        self.assertAlmostEqual(self.cable.BendRadiusMargin.Value, radius - 30, delta=1e-2)
        self.assertNotIn("tightest", self.cable.Status)
        self.type.MinBendRadius = "90 mm"
        self.compute()
        self.assertLess(self.cable.BendRadiusMargin.Value, 0)
        self.assertIn("tighter than the 90 mm", self.cable.Status)

    def test_a_profile_is_swept_with_the_frame(self):
        sketch = self.doc.addObject("Part::Feature", "Sketch")
        sketch.Shape = Part.makePolygon(
            [Vector(x, y, 0) for x, y in ((-4, -1), (4, -1), (4, 1), (-4, 1), (-4, -1))]
        )
        nodes = self.cable.NodePosition
        self.cable.Profile = sketch
        self.compute()
        self.assertAlmostEqual(self.cable.Shape.Volume / (16 * 300), 1, delta=1e-4)
        self.assertEqual(self.cable.NodePosition, nodes)
        sketch.Placement.Base = Vector(1000, 0, 0)
        swept = self.cable.SweptInputs
        self.compute()
        self.assertEqual(self.cable.SweptInputs, swept)
        self.cable.Profile = None
        self.compute()
        self.assertAlmostEqual(self.cable.Shape.Volume / (math.pi * 3.5**2 * 300), 1, delta=1e-5)

    def test_moving_a_part_moves_the_end(self):
        self.right.Placement.Base += Vector(30, 20, 10)
        self.compute()
        wire = self.cable.Centreline.Shape.Edges[0]
        # What a solve leaves at an end is below 1e-7 of the length.
        self.assertNear(wire.valueAt(wire.LastParameter), (150, 20, 10), 1e-7 * 300)

    def test_without_a_change_nothing_is_computed(self):
        stored = {name: getattr(self.cable, name) for name in (*NODES, "SolveTime", "Status")}
        shape = self.cable.Shape
        for obj in self.doc.Objects:
            obj.touch()
        self.compute()
        for name, value in stored.items():
            self.assertEqual(getattr(self.cable, name), value, name)
        self.assertTrue(self.cable.Shape.isSame(shape))

    def test_a_change_of_name_changes_nothing(self):
        before = self.answer()
        for obj in self.doc.Objects:
            obj.Label = f"New {obj.Label}"
        self.compute()
        self.assertEqual(self.answer(), before)

    def test_a_move_by_hand_is_taken_back(self):
        for obj in (self.cable, self.cable.Centreline):
            obj.Placement.Base = Vector(1, 2, 3)
            self.assertEqual(obj.Placement, Placement())
        self.compute()


class TwistTest(DocumentTest):
    """Two pins look up; the frames of their edges are half a turn apart, and nobody has asked for that."""

    def test_twist_that_nobody_asked_for_is_said(self):
        cable = self.cable_between_pins()
        self.compute()
        self.assertAlmostEqual(abs(cable.Twist.Value), 180, delta=90)
        self.assertIn(f"Warning: it is twisted by {cable.Twist.Value:.0f}°", cable.Status)
        self.assertIn(f"{self.start.Label} and {self.end.Label} are Clamped", cable.Status)

    def test_it_is_gone_with_a_swivel(self):
        cable = self.cable_between_pins()
        self.end.Condition = "Swivel"
        self.compute()
        self.assertAlmostEqual(cable.Twist.Value, 0, delta=1e-3)
        self.assertNotIn("twisted", cable.Status)

    def test_what_a_roll_asks_for_is_not_said(self):
        cable = self.cable_between_pins()
        self.end.Roll = "90 deg"
        self.compute()
        self.assertGreater(abs(cable.Twist.Value), 45)
        self.assertNotIn("twisted", cable.Status)
