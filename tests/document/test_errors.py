# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every wrong input is one sentence on the object that is wrong, and nothing old passes for an answer."""

import re
from types import SimpleNamespace
from unittest import mock

import Part
from FreeCAD import Placement, Rotation, Vector
from scenes import TOP, DocumentTest

from freecad_cable.document import make, solving
from freecad_cable.errors import SolverMissingError
from freecad_cable.status import Status

NAN = float("nan")


class ErrorTest(DocumentTest):
    def setUp(self):
        super().setUp()
        self.cable_between_pins()
        self.route = make.route(self.doc, self.cable)
        self.compute()

    def check(self, obj, *words):
        """The error is on ``obj`` alone, the cable shows nothing, and mending it brings all back."""
        sentence = self.assertFailed(obj, *words)
        self.assertNothingShown(self.cable)
        self.assertEqual(self.cable.Status, sentence)
        self.assertTrue(self.cable.Centreline.Shape.isNull())
        invalid = [o for o in self.doc.Objects if "Invalid" in o.State]
        self.assertEqual(invalid, [obj])
        return sentence

    def check_property(self, obj, name, value, *words):
        old = getattr(obj, name)
        setattr(obj, name, value)
        sentence = self.check(obj, name, *words)
        setattr(obj, name, old)
        self.compute()
        self.assertFalse(self.cable.Shape.isNull())
        return sentence

    def test_too_short(self):
        said = self.check_property(self.cable, "Length", "100 mm", "100 mm", "120 mm apart")
        self.assertIn("shortest possible length is 120 mm", said)

    def test_no_slack_at_all(self):
        self.check_property(self.cable, "Length", "120 mm", "no slack")

    def test_lengths_that_are_none(self):
        self.check_property(self.cable, "Length", 0, "0 mm", "greater than 0 mm")
        self.check_property(self.cable, "Length", -300, "-300 mm", "greater than 0 mm")
        self.check_property(self.cable, "Length", NAN, "nan", "finite")
        self.cable.LengthMode = "Slack"
        self.check_property(self.cable, "Slack", -0.1, "-0.1", "at least 0")
        self.check_property(self.cable, "Slack", NAN, "nan", "finite")

    def test_slack_without_a_distance(self):
        self.cable.LengthMode = "Slack"
        self.end.Condition = "Free"
        self.check(self.cable, "LengthMode", "an end is free")
        self.end.Condition = "Clamped"
        self.right.Placement.Base = self.left.Placement.Base
        self.check(self.cable, "LengthMode", "same point")

    def test_section(self):
        for name in ("OuterDiameter", "MassPerLength", "BendingStiffness", "TorsionalStiffness"):
            for value in (0, -1, NAN):
                words = ("finite",) if value != value else (f"{value:g}", "greater than 0")
                self.check_property(self.type, name, self.in_unit(name, value), *words)
        for name in ("SecondBendingStiffness", "AxialStiffness", "ShearStiffness"):
            self.check_property(self.type, name, self.in_unit(name, -1), "-1", "greater than 0")
            self.check_property(self.type, name, self.in_unit(name, NAN), "finite")
        self.check_property(self.type, "MinBendRadius", -30, "-30 mm", "at least 0 mm")
        self.check_property(self.type, "NaturalCurvature", Vector(NAN, 0, 0), "finite")
        self.type.Source = "Material"
        for name in ("YoungsModulus", "ShearModulus", "Density"):
            self.check_property(self.type, name, self.in_unit(name, 0), "0", "greater than 0")

    def in_unit(self, name, value):
        unit = next(prop.unit for prop in self.type.Proxy.TABLE if prop.name == name)
        return f"{value} {unit}" if value == value else value

    def test_gravity_and_tolerance(self):
        self.check_property(self.cable, "Gravity", Vector(0, 0, NAN), "nan", "finite")
        for value in (0, -1, 1, NAN):
            words = ("finite",) if value != value else ("between 1e-10 and 0.1",)
            self.check_property(self.cable, "Tolerance", value, *words)

    def test_numbers_far_outside_anything_built(self):
        for obj, name in (
            (self.cable, "Clearance"),
            (self.cable, "Length"),
            (self.type, "OuterDiameter"),
            (self.type, "MinBendRadius"),
        ):
            self.check_property(obj, name, 1e300, "is 1e+300 mm", "at most 1e+30 mm")
        self.check_property(self.cable, "Length", 1e-300, "is 1e-300 mm", "at least 1e-27 mm")
        self.check_property(self.type, "OuterDiameter", 1e-300, "is 5e-301 mm", "at least 1e-27 mm")
        self.type.Source = "Material"
        self.check_property(self.type, "OuterDiameter", 1e-300, "is 1e-300 mm", "1e-27 mm")

    def test_far_too_long(self):
        make.route(self.doc, self.cable, method="Catenary")
        for length in (1e9, 1e20):
            self.cable.Length = length
            self.check(self.cable, "The solver found no equilibrium", "a wrong unit")

    def test_links(self):
        self.check_property(self.cable, "Start", None, "is empty", "choose a terminal")
        self.check_property(self.cable, "End", self.left, "is Left", "no cable terminal")
        self.check_property(self.cable, "End", self.start, "is Terminal and so is Start")
        self.check_property(self.cable, "CableType", None, "is empty", "choose a cable type")
        self.check_property(self.cable, "CableType", self.left, "is Left", "no cable type")

    def test_an_offset_that_is_none(self):
        for offset in (
            Placement(Vector(1e300, 0, 0), Rotation()),
            Placement(Vector(0, NAN, 0), Rotation()),
            Placement(Vector(), Rotation(0, 0, 0, 0)),
        ):
            self.check_property(
                self.start, "Offset", offset, "finite numbers", "an axis and an angle"
            )

    def test_a_terminal_without_its_part(self):
        self.doc.removeObject(self.right.Name)
        self.check(self.end, "Reference", "is empty")

    def test_a_cable_asked_alone_does_not_use_a_broken_terminal(self):
        self.end.Reference = None
        self.doc.recompute()
        self.cable.touch()
        self.cable.recompute()
        self.assertNothingShown(self.cable)
        self.assertIn(self.end.Label, self.cable.Status)

    def test_ends_that_hold_nothing(self):
        self.start.Condition = self.end.Condition = "Free"
        self.check(self.cable, "both ends are free")
        self.start.Condition, self.cable.Gravity = "Pinned", Vector()
        self.check(self.cable, "can turn freely")

    def test_terminals_in_another_container(self):
        unit = self.doc.addObject("App::Part", "Unit")
        unit.addObject(self.pin("Inner", (0, 80, 0)))
        self.doc.recompute()
        inner = make.terminal(self.doc, (unit, f"Inner.{TOP}"), inside=unit)
        self.check_property(self.cable, "End", inner, inner.Label, "another part or assembly")

    def test_a_bend_tighter_than_the_cable_shows_the_line(self):
        self.type.OuterDiameter = "40 mm"
        self.type.MassPerLength = "9 kg/m"
        self.assertFailed(self.cable, "bends to a radius of")
        self.assertEqual(self.cable.Shape.ShapeType, "Wire")
        self.assertGreater(self.cable.SmallestBendRadius.Value, 0)
        self.assertFailed(self.cable, "bends to a radius of")
        self.type.OuterDiameter = "7 mm"
        self.compute()
        self.assertEqual(len(self.cable.Shape.Solids), 1)

    def test_a_profile_that_is_none(self):
        sketch = self.doc.addObject("Part::Feature", "Sketch")
        sketch.Shape = Part.makePolygon([Vector(), Vector(1, 0, 0), Vector(1, 1, 0)])
        for profile, words in ((sketch, "not closed"), (self.type, "is empty")):
            self.cable.Profile = profile
            self.assertFailed(self.cable, "Profile", profile.Label, words)
            self.assertEqual(self.cable.Shape.ShapeType, "Wire")

    def solving(self, outcome):
        return mock.patch.object(solving, "find_equilibrium", **outcome)

    def test_without_casadi_what_was_solved_stays(self):
        error = SolverMissingError("CasADi is not installed, so no cable can be solved.")
        self.cable.Length = "310 mm"
        with self.solving({"side_effect": error}):
            self.assertFailed(self.cable, "CasADi is not installed")
        self.assertTrue(self.cable.OutOfDate)
        self.assertEqual(self.cable.SolvedLength.Value, 300)
        for obj in (self.cable, self.cable.Centreline, self.route):
            self.assertFalse(obj.Shape.isNull())
        self.assertEqual(self.cable.Centreline.Status, self.cable.Status)
        self.compute()
        self.assertFalse(self.cable.OutOfDate)
        self.assertEqual(self.cable.SolvedLength.Value, 310)
        self.assertEqual(self.cable.Centreline.Status, "")

    def test_without_casadi_the_route_is_drawn(self):
        error = SolverMissingError("CasADi is not installed, so no cable can be solved.")
        self.cable.Length = "310 mm"
        self.cable.SolvedInputs = ""  # as before it was first solved
        with self.solving({"side_effect": error}):
            self.check(self.cable, "CasADi is not installed")
        self.assertGreater(self.route.Length.Value, 120)
        self.assertFalse(self.route.Shape.isNull())
        self.assertEqual(self.route.LengthDifference.Value, 0)
        self.compute()
        self.assertNotEqual(self.route.LengthDifference.Value, 0)

    def test_not_solved(self):
        for status in (Status.NOT_CONVERGED, Status.UNSTABLE, Status.INACCURATE, Status.TIME_LIMIT):
            failed = SimpleNamespace(status=status, message=status.value)
            self.cable.Length = "310 mm"
            with self.solving({"return_value": failed}):
                self.check(self.cable, status.value)
            self.cable.Length = "300 mm"
            self.compute()

    def test_numbers_that_overflow_in_the_solver(self):
        self.cable.Length = "310 mm"
        with self.solving({"side_effect": ValueError("array must not contain infs or NaNs")}):
            self.check(self.cable, "the solver broke off", "infs or NaNs", "wrong unit")

    def test_a_fault_of_ours_leaves_nothing_either(self):
        self.cable.Length = "310 mm"
        with self.solving({"side_effect": KeyError("fault")}):
            self.doc.recompute()
        self.assertIn("Invalid", self.cable.State)
        self.assertNothingShown(self.cable)


class WarningTest(DocumentTest):
    """What looks like a wrong unit is said, and solved all the same."""

    def test_what_no_section_is_made_of(self):
        kind = make.cable_type(self.doc, "Multi-core cable 7 mm")
        self.compute()
        self.assertNotIn("Warning", kind.Status)
        for name, value, words in (
            ("BendingStiffness", "1.18e3 N*m^2", "bending stiffness means a modulus of 1e+13 Pa"),
            ("BendingStiffness", "1.18e-6 N*m^2", "bending stiffness means a modulus of 1e+04 Pa"),
            (
                "TorsionalStiffness",
                "4.72e3 N*m^2",
                "torsional stiffness means a modulus of 2e+13 Pa",
            ),
            (
                "TorsionalStiffness",
                "9.4e-6 N*m^2",
                "torsional stiffness means a modulus of 4e+04 Pa",
            ),
            ("MassPerLength", "44.6e-3 g/m", "density of 1.2 kg/m³"),
            ("MassPerLength", "4.46 kg/m", "density of 1.2e+05 kg/m³"),
        ):
            old = getattr(kind, name)
            setattr(kind, name, value)
            self.compute()
            self.assertRegex(
                kind.Status, f"Warning: .* {re.escape(words)}, outside .* check its unit"
            )
            setattr(kind, name, old)
            self.compute()
            self.assertNotIn("Warning", kind.Status)

    def test_the_cable_says_it_too_whether_it_is_solved_or_not(self):
        self.cable_between_pins()
        self.type.MassPerLength = "4.46 kg/m"
        self.doc.recompute()
        said = f"{self.type.Label}: Warning: with this diameter, the mass"
        self.assertTrue(self.cable.isValid())
        self.assertIn(said, self.cable.Status)
        self.cable.Length = "310 mm"
        failed = SimpleNamespace(status=Status.NOT_CONVERGED, message="Not found.")
        with mock.patch.object(solving, "find_equilibrium", return_value=failed):
            self.assertFailed(self.cable, "Not found.", said)

    def test_a_stiffness_without_its_unit_is_in_the_internal_one(self):
        """0.00118 typed bare is 0.00118 mm³kg/s², a thousand million times too soft."""
        kind = make.cable_type(self.doc, "Bare")
        kind.BendingStiffness = 0.00118
        self.compute()
        self.assertIn("the bending stiffness means a modulus of 0.01 Pa", kind.Status)
