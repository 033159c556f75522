# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cables at the bounds of their stiffness, and what the report says of them."""

import math
from unittest import mock

from FreeCAD import Vector
from scenes import DocumentTest

from freecad_cable.document import make, report, stiffness_band
from freecad_cable.errors import SolverMissingError


class BandTest(DocumentTest):
    """A wire of which only bounds of its stiffness are known."""

    def setUp(self):
        super().setUp()
        self.cable_between_pins(length="260 mm")
        self.cable.CableType = make.cable_type(self.doc, "Hook-up wire AWG 22, ETFE")
        self.compute()

    def test_without_weight_the_shape_does_not_know_the_stiffness(self):
        self.cable.Gravity = Vector()
        self.end.Roll = "180 deg"  # nor twist, whose stiffness stays
        self.compute()
        for bound in stiffness_band.band(self.cable):
            # To ten times the error that is asked for.
            self.assertLess(bound.shift, 10 * 1e-4 * 260)

    def test_its_bounds_are_what_cables_of_that_stiffness_do(self):
        slip, stick = stiffness_band.band(self.cable)
        kind, shown = self.cable.CableType, self.cable.SmallestBendRadius.Value
        self.assertGreater(slip.shift, 1)
        for bound in (slip, stick):
            self.assertGreater(abs(bound.radius - shown), 0.1)
            kind.BendingStiffness = getattr(kind, f"{bound.name}BendingStiffness")
            self.compute()
            self.assertAlmostEqual(
                bound.radius / self.cable.SmallestBendRadius.Value, 1, delta=1e-2
            )

    def test_the_report_says_where_a_bound_does_not_hold(self):
        slip, stick = stiffness_band.band(self.cable)
        shown = self.cable.SmallestBendRadius.Value
        worse = min(slip, stick, key=lambda bound: bound.radius)
        self.assertLess(worse.radius, shown)
        kind = self.cable.CableType
        kind.BendRadiusConvention = "Centreline"
        kind.MinBendRadius = (worse.radius + shown) / 2
        self.compute()
        (entry,) = report.collect(self.doc)
        self.assertEqual(entry.verdict, report.Verdict.UNKNOWN)
        self.assertIn(f"with {worse.name}BendingStiffness it bends to", *entry.doubts)

    def test_without_casadi_the_rest_of_the_report_stands(self):
        missing = SolverMissingError("CasADi is not installed.")
        with mock.patch.object(stiffness_band, "find_equilibrium", side_effect=missing):
            (entry,) = report.collect(self.doc)
        self.assertEqual(entry.band, [])
        self.assertIn("CasADi is not installed", " ".join(entry.doubts))
        self.assertFalse(math.isnan(entry.spline_length))
