# SPDX-License-Identifier: LGPL-2.1-or-later
"""Circular edges found by centre and radius, in nested and moved parts."""

import unittest

import FreeCAD
import Part
from FreeCAD import Placement, Rotation, Vector

from freecad_cable.demo.circles import Circles
from freecad_cable.errors import DocumentError

OUTER = Placement(Vector(10, 20, 30), Rotation(Vector(1, 2, 3), 40))
INNER = Placement(Vector(-5, 0, 7), Rotation(Vector(0, 1, 0), 90))


class CirclesTest(unittest.TestCase):
    """A cylinder of radius 3 and height 8, and a box with rounded edges, in a part in a part."""

    def setUp(self):
        self.document = FreeCAD.newDocument("Circles")
        self.outer, inner = (
            self.document.addObject("App::Part", name) for name in ("Outer", "Inner")
        )
        self.outer.Placement, inner.Placement = OUTER, INNER
        self.outer.addObject(inner)
        for name, shape in (("Pin", Part.makeCylinder(3, 8)), ("Box", self.rounded_box())):
            feature = self.document.addObject("Part::Feature", name)
            feature.Shape = shape
            inner.addObject(feature)
        self.circles = Circles(self.outer)

    def tearDown(self):
        FreeCAD.closeDocument(self.document.Name)

    def rounded_box(self):
        box = Part.makeBox(20, 20, 20, Vector(50, 0, 0))
        return box.makeFillet(4, box.Edges)

    def test_the_edge_at_a_place(self):
        for height in (0, 8):
            centre = (OUTER * INNER).multVec(Vector(0, 0, height))
            root, path = self.circles.reference(centre, 3)
            edge = Part.getShape(root, path, needSubElement=True)
            self.assertEqual(root, self.outer)
            self.assertLess(edge.Curve.Center.distanceToPoint(centre), 1e-9)

    def test_an_arc_is_no_circle(self):
        centre = (OUTER * INNER).multVec(Vector(54, 4, 4))
        with self.assertRaisesRegex(DocumentError, "Outer has 0 circular edges of radius 4 mm at"):
            self.circles.reference(centre, 4)

    def test_other_radius_or_place_is_another_edge(self):
        centre = (OUTER * INNER).multVec(Vector(0, 0, 8))
        for place, radius in ((centre, 3.01), (centre + Vector(0.01, 0, 0), 3)):
            with self.assertRaises(DocumentError):
                self.circles.reference(place, radius)

    def test_two_at_one_place_are_a_question(self):
        twin = self.document.addObject("Part::Feature", "Twin")
        twin.Shape = Part.makeCylinder(3, 2)
        twin.Placement = INNER
        self.outer.addObject(twin)
        with self.assertRaisesRegex(DocumentError, "2 circular edges"):
            Circles(self.outer).reference((OUTER * INNER).Base, 3)
