# SPDX-License-Identifier: LGPL-2.1-or-later
"""Comparison routes and the centreline."""

import math
from unittest import mock

from FreeCAD import Placement, Rotation, Vector
from scenes import DocumentTest

from freecad_cable.document import make
from freecad_cable.document import route as route_module


def no_drawing():
    """Whoever draws a route in here fails."""
    never = mock.Mock(side_effect=AssertionError("drawn"))
    return mock.patch.dict(route_module.METHODS, dict.fromkeys(route_module.METHODS, never))


class RouteTest(DocumentTest):
    def setUp(self):
        super().setUp()
        self.cable_between_pins()

    def test_a_chord_is_straight(self):
        route = make.route(self.doc, self.cable, method="Chord")
        self.compute()
        self.assertAlmostEqual(route.Length.Value, 120, delta=1e-9)
        self.assertAlmostEqual(route.Shape.Length, 120, delta=1e-9)
        self.assertAlmostEqual(route.LengthDifference.Value, 120 - 300, delta=1e-9)
        self.assertAlmostEqual(route.RelativeLengthDifference, 120 / 300 - 1, delta=1e-12)
        self.assertEqual(route.SmallestBendRadius.Value, math.inf)

    def test_a_catenary_hangs_with_the_length_of_the_cable(self):
        """Of a cosh of length L over a span X: sag c (cosh(X/2c) - 1), and c is its bend radius at the bottom."""
        route = make.route(self.doc, self.cable, method="Catenary")
        self.compute()
        self.assertAlmostEqual(route.Length.Value, 300, delta=1e-6)
        c = 1.0
        for _ in range(200):  # L/2 = c sinh(X/2c), by a contraction
            c = 60 / math.asinh(150 / c)
        self.assertAlmostEqual(c * math.sinh(60 / c), 150, delta=1e-9)
        # The drawn curve interpolates samples, the least radius stands at one of them.
        self.assertAlmostEqual(
            -route.Shape.BoundBox.ZMin / (c * (math.cosh(60 / c) - 1)), 1, delta=1e-4
        )
        self.assertAlmostEqual(route.SmallestBendRadius.Value / c, 1, delta=1e-2)

    def test_a_spline_leaves_with_the_terminals(self):
        route = make.route(self.doc, self.cable)
        self.compute()
        self.assertEqual(route.Method, "Spline")
        wire = route.Shape.Edges[0]
        self.assertNear(wire.tangentAt(wire.FirstParameter), (0, 0, 1), 1e-6)
        self.assertNear(wire.tangentAt(wire.LastParameter), (0, 0, -1), 1e-6)
        self.assertNear(wire.valueAt(wire.FirstParameter), (0, 0, 0))
        self.assertNear(wire.valueAt(wire.LastParameter), (120, 0, 0))
        self.assertAlmostEqual(route.Shape.Length / route.Length.Value, 1, delta=1e-4)

    def test_it_follows_the_cable(self):
        route = make.route(self.doc, self.cable)
        self.compute()
        before = route.Length.Value
        self.cable.Length = "350 mm"
        with no_drawing():
            self.compute()
        self.assertAlmostEqual(route.Length.Value, before, delta=1e-9)
        self.assertAlmostEqual(route.LengthDifference.Value, before - 350, delta=1e-9)
        self.right.Placement.Base += Vector(60, 0, 0)
        self.compute()
        self.assertGreater(route.Length.Value, before + 30)
        self.assertNear(route.Shape.Edges[0].Vertexes[1].Point, (180, 0, 0))

    def test_it_is_never_stale(self):
        """Whatever it was drawn from before: its shape is the one that a new route has."""
        route = make.route(self.doc, self.cable)
        self.doc.UndoMode = 1

        def edit(*changes):
            self.doc.openTransaction("Edit")
            for obj, name, value in changes:
                setattr(obj, name, value)
            self.compute()
            self.doc.commitTransaction()

        def assert_fresh():
            self.compute()
            fresh = make.route(self.doc, self.cable, method=route.Method)
            self.compute()
            self.assertEqual(route.Length.Value, fresh.Length.Value)
            self.assertEqual(route.LengthDifference.Value, fresh.LengthDifference.Value)
            self.assertEqual(route.SmallestBendRadius.Value, fresh.SmallestBendRadius.Value)
            for share in (0, 0.3, 1):
                ours, theirs = (
                    edge.valueAt(edge.LastParameter * share)
                    for edge in (route.Shape.Edges[0], fresh.Shape.Edges[0])
                )
                self.assertNear(ours, theirs)
            self.doc.removeObject(fresh.Name)

        moved = self.right.Placement.copy()
        moved.Base += Vector(0, 20, 0)
        for changes in (
            [(self.right, "Placement", moved)],
            [(route, "Method", "Catenary")],
            [(self.cable, "Length", "350 mm")],
            [(self.cable, "Gravity", Vector(0, -9.81, 0))],
            [(route, "Method", "Spline"), (self.end, "Condition", "Pinned")],
            [(route, "Placement", Placement(Vector(0, 0, 5), Rotation()))],
        ):
            with self.subTest([change[1:] for change in changes]):
                edit(*changes)
                assert_fresh()
        self.assertEqual(self.doc.UndoCount, 6)
        while self.doc.UndoCount:
            self.doc.undo()
            assert_fresh()
        copy = self.doc.copyObject(route, False)
        copy.Method = "Chord"
        self.compute()
        self.assertEqual(copy.Shape.Length, self.right.Placement.Base.x)
        assert_fresh()

    def test_a_method_that_cannot_be_drawn(self):
        route = make.route(self.doc, self.cable, method="Catenary")
        self.compute()
        self.cable.Gravity = Vector()
        self.assertFailed(route, "Method", "Catenary cannot be drawn")
        self.assertTrue(route.Shape.isNull())
        self.assertEqual(route.Length.Value, 0)
        self.assertTrue(self.cable.isValid())
        self.cable.Gravity = Vector(0, 0, -9.81)
        self.compute()
        self.assertAlmostEqual(route.Shape.Length, 300, delta=1e-2)
        self.assertAlmostEqual(route.Length.Value, 300, delta=1e-6)
        route.Method = "Chord"
        self.compute()
        self.end.Condition = "Free"
        self.assertFailed(route, "Method", "Chord cannot be drawn", "free")
        self.assertFalse(self.cable.Shape.isNull())

    def test_a_cable_that_is_none(self):
        route = make.route(self.doc, self.cable)
        route.Cable = self.left
        self.assertFailed(route, "Cable: is Left", "no cable")


class CentrelineTest(DocumentTest):
    def test_it_is_the_spine_of_a_native_sweep(self):
        """Of a circle of 2 mm beside a cable of 7 mm; OCCT's sweep is within 1e-3 of Pappus' volume."""
        self.cable_between_pins()
        self.compute()
        line = self.cable.Centreline
        self.assertAlmostEqual(line.Length.Value / 300, 1, delta=self.cable.Tolerance)
        circle = self.doc.addObject("Part::Circle", "Section")
        circle.Radius = 2
        sweep = self.doc.addObject("Part::Sweep", "Sweep")
        sweep.Sections, sweep.Spine = [circle], (line, ["Edge1"])
        sweep.Solid, sweep.Frenet = True, False
        self.compute()
        self.assertTrue(sweep.Shape.isValid())
        self.assertAlmostEqual(sweep.Shape.Volume / (math.pi * 4 * 300), 1, delta=1e-3)
        self.cable.Length = "310 mm"
        self.compute()
        self.assertAlmostEqual(sweep.Shape.Volume / (math.pi * 4 * 310), 1, delta=1e-3)
