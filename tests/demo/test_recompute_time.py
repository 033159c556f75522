# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long a recompute takes, beside a native sweep of the same curve."""

import statistics
import time
import unittest

import FreeCAD
import Part
from FreeCAD import Placement, Rotation, Vector

from freecad_cable.demo import table_1

POINTS, PAIRS = 50, 25


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

    def test_solving_and_sweeping_take_at_most_as_long_as_the_native_sweep(self):
        """Both side by side, because the machine is shared; the cable gets a new length each time."""
        cables = [cable for cable, _ in table_1.build(self.ours)]
        self.ours.recompute()
        for cable, length in zip(cables, table_1.LENGTHS, strict=True):
            with self.subTest(cable.Label):
                ratio = statistics.median(self.ratios(cable, length))
                # The aim is 1. Measured: 0.80 to 0.95, centreline and route included, which the native sweep is
                # given. Other work on the machine slows both down, but not quite alike; what must not pass is the
                # 1.2 and more that a sweep or an error estimate of twice the time would make of it.
                self.assertLess(ratio, 1.15)

    def ratios(self, cable, length):
        (edge,) = cable.Centreline.Shape.Edges
        sweep = native_sweep(self.native, edge, cable.CableType.OuterDiameter.Value)
        self.native.recompute()
        self.assertAlmostEqual(
            sweep.Shape.Volume, cable.Shape.Volume, delta=1e-3 * cable.Shape.Volume
        )
        for k in range(PAIRS):
            cable.Length = length + k % 2 - 0.5
            sweep.touch()
            yield seconds(self.ours) / seconds(self.native)
            self.assertAlmostEqual(cable.SolvedLength.Value, cable.Length.Value)
