# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long a recompute takes, beside a native sweep of the same curve."""

import statistics
import time
import unittest

import FreeCAD
import Part
from FreeCAD import Placement, Rotation, Vector

from freecad_cable.demo import table_1

POINTS, PAIRS = 50, 15


def native_sweep(document, edge, diameter):
    """FreeCAD's own sweep of a circle along the curve through points of ``edge``."""
    curve = Part.BSplineCurve()
    curve.interpolate(edge.discretize(POINTS))
    spine = document.addObject("Part::Feature", "Spine")
    spine.Shape = curve.toShape()
    section = document.addObject("Part::Circle", "Section")
    section.Radius = diameter / 2
    start = edge.FirstParameter
    section.Placement = Placement(
        edge.valueAt(start), Rotation(Vector(0, 0, 1), edge.tangentAt(start))
    )
    sweep = document.addObject("Part::Sweep", "Sweep")
    sweep.Sections, sweep.Spine = [section], (spine, ["Edge1"])
    sweep.Solid, sweep.Frenet = True, False
    return sweep


def seconds(document):
    begin = time.perf_counter()
    document.recompute()
    return time.perf_counter() - begin


class RecomputeTimeTest(unittest.TestCase):
    def setUp(self):
        self.ours, self.native = (FreeCAD.newDocument(name) for name in ("Ours", "Native"))

    def tearDown(self):
        for document in (self.ours, self.native):
            FreeCAD.closeDocument(document.Name)

    def test_solving_and_sweeping_take_about_as_long_as_the_native_sweep(self):
        """Both side by side, because the machine is shared; the cable gets a new length each time."""
        cable = list(table_1.build(self.ours))[-1][0]
        self.ours.recompute()
        (edge,) = cable.Centreline.Shape.Edges
        sweep = native_sweep(self.native, edge, cable.CableType.OuterDiameter.Value)
        self.native.recompute()
        self.assertAlmostEqual(
            sweep.Shape.Volume, cable.Shape.Volume, delta=1e-3 * cable.Shape.Volume
        )
        ratios = []
        for k in range(PAIRS):
            cable.Length = table_1.LENGTHS[-1] + k % 2 - 0.5
            sweep.touch()
            ratios.append(seconds(self.ours) / seconds(self.native))
            self.assertAlmostEqual(cable.SolvedLength.Value, cable.Length.Value)
        # The aim is 1. Measured: 1.1 to 1.3, of which a fifth is the centreline and the route, which the native sweep
        # is given. What must not pass is the 2 that a second solve, a cold one or a second sweep would make of it.
        self.assertLess(statistics.median(ratios), 1.6)
