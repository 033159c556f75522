# SPDX-License-Identifier: LGPL-2.1-or-later
import unittest

import FreeCAD
import numpy as np
import Part
from FreeCAD import Placement, Rotation, Vector
from known_curves import arc, changed, rod, sag, straight
from profiles import circle, disc, polygon, rectangle, rounded, slot, star
from scipy.integrate import trapezoid
from test_sweep_round import boolean_check

from freecad_cable.errors import DocumentError
from freecad_cable.geometry import rotation
from freecad_cable.shape.sweep import sweep_profile

QUARTER = np.pi / 2


def twisted(angle, length=0.4):
    """A straight cable twisted by ``angle``."""
    return rod([(length, lambda s: np.array([0.0, 0.0, angle / length]))], 50)


class TestMaterialFrame(unittest.TestCase):
    def assert_section(self, solid, nodes, k, inside, outside):
        """Whether points (x, y) of the section at node k, just within the end faces, are in the solid."""
        middle = nodes.position[len(nodes.position) // 2]
        inward = 1e-7 * (middle - nodes.position[k])
        d1, d2, _ = rotation.matrix(nodes.quaternion[k]).T
        for points, expected in ((inside, True), (outside, False)):
            for x, y in points:
                place = Vector(*((nodes.position[k] + inward) * 1e3 + x * d1 + y * d2))
                self.assertEqual(solid.isInside(place, 1e-6, False), expected, (k, x, y))

    def test_a_ribbon_turns_with_the_frame(self):
        for nodes in (twisted(QUARTER), sag()):
            ribbon = sweep_profile(nodes, rectangle(20, 1))
            inside = [(9.9, 0), (-9.9, 0), (0, 0.4), (0, -0.4), (9.9, 0.4)]
            outside = [(10.1, 0), (0, 0.6), (0, 2), (-9.9, 0.6)]
            for k in (0, 13, 25, 38, -1):
                self.assert_section(ribbon, nodes, k, inside, outside)

    def test_a_quarter_turn(self):
        ribbon = sweep_profile(twisted(QUARTER), rectangle(20, 1))
        ends = [face for face in ribbon.Faces if isinstance(face.Surface, Part.Plane)]
        for end, along in zip(ends, ("XLength", "YLength"), strict=True):
            self.assertAlmostEqual(getattr(end.BoundBox, along), 20, delta=1e-3)
        self.assertAlmostEqual(ends[0].BoundBox.YLength, 1, delta=1e-3)
        self.assertAlmostEqual(ends[1].BoundBox.XLength, 1, delta=1e-3)
        self.assertEqual(boolean_check(ribbon), "")
        self.assertAlmostEqual(ribbon.Volume / (20 * 1 * 400), 1, delta=1e-5)

    def test_x_is_d1_and_y_is_d2(self):
        nodes = sag()
        flag = polygon((0, 0), (6, 0), (0, 2))
        solid = sweep_profile(nodes, flag)
        for k in (0, 25, -1):
            self.assert_section(
                solid, nodes, k, [(5, 0.1), (0.1, 1.8)], [(-1, 0.5), (2, -0.2), (0.1, 2.5)]
            )

    def test_five_turns(self):
        solid = sweep_profile(twisted(10 * np.pi), rectangle(20, 1))
        self.assertTrue(solid.isValid())
        # The frame turns by 0.63 rad a node: Hermite's remainder is 0.63⁶/46080 of the half width.
        self.assertAlmostEqual(solid.Volume / (20 * 1 * 400), 1, delta=2e-5)


class TestSections(unittest.TestCase):
    """Sections of every kind, along a smooth cable and one with two jumps of curvature, both short."""

    smooth = rod([(0.1, lambda s: np.array([8 * np.cos(30 * s), 5 + 40 * s, 10.0]))], 10)
    jumping = rod([straight(0.03), arc(0.05, 1.0), straight(0.03)], 12)

    def assert_swept(self, shape, sides):
        shape_area, centroid = area_and_centroid(shape)
        for nodes, runs in ((self.smooth, 1), (self.jumping, 3)):
            solid = sweep_profile(nodes, shape)
            self.assertTrue(solid.isValid() and solid.isClosed())
            self.assertEqual(len(solid.Faces), sides * runs + 2)
            # Pappus: the centroid (x, y) runs over ds (1 + κ1 y − κ2 x).
            k1, k2, _ = nodes.curvature.T / 1e3
            path = trapezoid(1 + k1 * centroid.y - k2 * centroid.x, nodes.arc_length * 1e3)
            # The trapezoidal rule is off by as much as its end corrections for an excentric section.
            tolerance = 1e-5 if centroid.Length < 1e-6 else 1e-3
            self.assertAlmostEqual(solid.Volume / (shape_area * path), 1, delta=tolerance)

    def test_ready_for_boolean_operations(self):
        for shape in (star(3), slot(8, 1), disc(3, hole=2)):
            self.assertEqual(boolean_check(sweep_profile(self.smooth, shape)), "")
        self.assertEqual(boolean_check(sweep_profile(self.jumping, rectangle(10, 1))), "")

    def test_corners_stay(self):
        self.assert_swept(rectangle(10, 1), 4)
        self.assert_swept(star(5), 10)
        self.assert_swept(polygon((0, 0), (2, 0), (2, 2)), 3)

    def test_either_way_around(self):
        clockwise = [(2, 2), (2, -2), (-2, -2), (-2, 2)]
        self.assert_swept(polygon(*clockwise), 4)
        self.assert_swept(polygon(*clockwise[::-1]), 4)
        mixed = Part.Wire(
            [
                Part.makeLine(Vector(0, 0), Vector(2, 0)),
                Part.makeLine(Vector(0, 2), Vector(2, 0)),
                Part.makeLine(Vector(0, 2), Vector(0, 0)),
            ]
        )
        self.assert_swept(mixed, 3)

    def test_arcs(self):
        # A rational quadratic spans less than half a turn, so an arc of half a turn is two faces.
        self.assert_swept(slot(8, 1), 6)
        self.assert_swept(rounded(6, 4, 1), 8)
        three_quarters = Part.Arc(
            Vector(0, 3), Vector(-2.1213203435596424, -2.1213203435596424), Vector(3, 0)
        )
        ends = [
            Part.makeLine(Vector(3, 0), Vector(0, 0)),
            Part.makeLine(Vector(0, 0), Vector(0, 3)),
        ]
        self.assert_swept(Part.Wire([three_quarters.toShape(), *ends]), 4)

    def test_full_circles_and_ellipses_are_one_face(self):
        self.assert_swept(circle(3), 1)
        self.assert_swept(Part.Circle(Vector(0, 0), Vector(0, 0, -1), 3).toShape(), 1)
        self.assert_swept(circle(2, x=5), 1)
        self.assert_swept(Part.Wire([Part.Ellipse(Vector(0, 0), 4, 2).toShape()]), 1)
        self.assert_swept(
            Part.Wire([Part.Ellipse(Vector(1, 3), Vector(-2, 1), Vector(0, 0)).toShape()]), 1
        )

    def test_splines(self):
        closed = Part.BSplineCurve()
        closed.interpolate(
            [Vector(3, 0), Vector(0, 2), Vector(-3, 0), Vector(0, -2)], PeriodicFlag=True
        )
        self.assert_swept(Part.Wire([closed.toShape()]), 1)
        uneven_weights = Part.BSplineCurve()
        uneven_weights.buildFromPolesMultsKnots(
            [Vector(3, 0), Vector(3, 4), Vector(0, 3), Vector(-3, 2), Vector(-3, 0)],
            [4, 1, 4],
            [0, 0.4, 1],
            False,
            3,
            [1, 2, 1, 1, 3],
        )
        base = Part.makeLine(Vector(-3, 0), Vector(3, 0))
        self.assert_swept(Part.Wire([uneven_weights.toShape(), base]), 3)

    def test_holes(self):
        self.assert_swept(disc(3, hole=2), 2)
        self.assert_swept(Part.makeCompound([circle(3), circle(2)]), 2)
        wires = [slot(12, 2), circle(1, x=-4), circle(1), circle(1, x=4)]
        self.assert_swept(Part.makeCompound(wires), 9)

    def test_a_sketch_counts_in_its_own_plane(self):
        doc = FreeCAD.newDocument()
        self.addCleanup(FreeCAD.closeDocument, doc.Name)
        sketch = doc.addObject("Sketcher::SketchObject", "Sketch")
        corners = [Vector(-5, -1), Vector(5, -1), Vector(5, 1), Vector(-5, 1)]
        for a, b in zip(corners, corners[1:] + corners[:1], strict=True):
            sketch.addGeometry(Part.LineSegment(a, b))
        sketch.Placement = Placement(Vector(7, 8, 9), Rotation(Vector(1, 1, 0), 70))
        doc.recompute()
        plain = sweep_profile(sag(), rectangle(10, 2))
        self.assertLess(
            (sweep_profile(sag(), sketch.Shape).CenterOfMass - plain.CenterOfMass).Length, 1e-6
        )


def area_and_centroid(shape):
    face = shape if shape.Faces else Part.makeFace(shape, "Part::FaceMakerBullseye")
    return face.Area, face.CenterOfMass


class TestRefused(unittest.TestCase):
    def refused(self, sentence, shape):
        with self.assertRaisesRegex(DocumentError, sentence):
            sweep_profile(sag(), shape)

    def test_each_is_a_sentence(self):
        self.refused("profile is empty", Part.Shape())
        self.refused("profile is empty", Part.Vertex(0, 0, 0))
        self.refused("not closed", Part.makePolygon([Vector(0, 0), Vector(2, 2), Vector(2, 0)]))
        self.refused(
            "not closed", Part.makeCompound([circle(2), Part.makeLine(Vector(0, 0), Vector(1, 0))])
        )
        self.refused("xy-plane: z runs from 1 mm to 1 mm", polygon((0, 0, 1), (2, 0, 1), (2, 2, 1)))
        self.refused("xy-plane", polygon((0, 0, 1), (2, 0, 0), (2, 2, 1)))
        self.refused("xy-plane", Part.makeBox(1, 1, 1))
        self.refused("crosses or touches itself", polygon((0, 0), (2, 2), (2, 0), (0, 2)))
        self.refused("crosses or touches itself", Part.makeCompound([circle(2), circle(2, x=1)]))
        self.refused("crosses or touches itself", polygon((0, 0), (1, 0), (2, 0)))
        self.refused("2 separate parts", Part.makeCompound([circle(1, x=-3), circle(1, x=3)]))
        self.refused("2 faces", Part.makeCompound([disc(1), disc(1).translated(Vector(5, 0))]))
        self.refused("mm across", circle(1e-6))
        self.refused("would fold", rectangle(400, 1))

    def test_curvature_that_does_not_belong_to_the_frames(self):
        nodes = twisted(QUARTER)
        wrong = changed(nodes, curvature=nodes.curvature + [0, 0, 300])
        with self.assertRaisesRegex(DocumentError, "times the volume of its length"):
            sweep_profile(wrong, rectangle(20, 1))

    def test_a_corner_that_reaches_the_centre_of_the_bend(self):
        bend = rod([arc(0.05, 0.5)], 10)
        self.assertTrue(sweep_profile(bend, polygon((0, -1), (49.8, 0), (0, 1))).isValid())
        with self.assertRaisesRegex(DocumentError, "radius of 50 mm.*would fold"):
            sweep_profile(bend, polygon((0, -1), (50.2, 0), (0, 1)))
