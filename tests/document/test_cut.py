# SPDX-License-Identifier: LGPL-2.1-or-later
"""The length to which a cable is cut."""

from unittest import mock

from scenes import DocumentTest

from freecad_cable.document import solving


class CutTest(DocumentTest):
    def test_allowances_are_added_and_the_sum_is_never_rounded_down(self):
        cable = self.cable_between_pins(length="300 mm")
        self.compute()
        self.assertEqual(cable.CutLength.Value, 300)
        with mock.patch.object(solving, "find_equilibrium", side_effect=AssertionError):
            for start, end, step, expected in (
                (8, 12, 0, 320),
                (8, 12, 50, 350),
                (8, 12, 20, 320),
                (0, 0.1, 5, 305),
                (0, 0, 0.1, 300),
            ):
                cable.StartAllowance, cable.EndAllowance, cable.RoundUpTo = start, end, step
                self.compute()
                self.assertAlmostEqual(cable.CutLength.Value, expected, delta=1e-9)

    def test_a_negative_allowance_is_an_error(self):
        cable = self.cable_between_pins(length="300 mm", end_allowance="-1 mm")
        self.assertFailed(cable, "EndAllowance", "-1 mm", "at least 0 mm")
        self.assertEqual(cable.CutLength.Value, 0)
        self.assertNothingShown(cable)
