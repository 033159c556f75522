# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids as obstacles: closed, near enough to the surface, and made once."""

import unittest
from unittest import mock

import FreeCAD
import numpy as np
import Part
from FreeCAD import Placement, Rotation, Vector

from freecad_cable.errors import ProblemError
from freecad_cable.shape import obstacle

MOVE = Placement(Vector(30, -20, 50), Rotation(Vector(1, 2, -3), 77))
RADIUS = 0.0035


def distances(shape):
    """Of points all over the faces of a shape: how far the obstacle says they are from it [mm]."""
    made = obstacle.placed("distances", shape).mesh(RADIUS, "obstacle")
    points = []
    for face in shape.Faces:
        low_u, high_u, low_v, high_v = face.ParameterRange
        for u in np.linspace(low_u, high_u, 53):
            for v in np.linspace(low_v, high_v, 53):
                if face.isPartOfDomain(u, v):
                    points.append(tuple(face.valueAt(u, v)))
    return 1e3 * made.nearest(1e-3 * np.array(points)).distance


class ObstacleTest(unittest.TestCase):
    def setUp(self):
        obstacle._kept.clear()

    def test_triangles_are_near_the_surface(self):
        """Of flat faces exactly; of round ones within a share of the radius of the cable. The mesher keeps its
        deflection but for a factor below 2."""
        self.assertLess(abs(distances(Part.makeBox(30, 20, 10))).max(), 1e-9)
        for shape in (
            Part.makeSphere(20),
            Part.makeCylinder(10, 50),
            Part.makeTorus(30, 5),
            Part.makeBox(40, 30, 20).cut(Part.makeCylinder(8, 50, Vector(20, 15, -5))),
        ):
            off = abs(distances(shape)).max()
            self.assertLess(off, 2 * obstacle.COARSEST * 1e3 * RADIUS)
            self.assertGreater(off, 0)

    def test_inside_is_negative(self):
        ball = obstacle.placed("Ball", Part.makeSphere(20)).mesh(RADIUS, "obstacle")
        inside, outside = ball.nearest(np.array([[0.001, 0.002, 0.018], [0, 0, 0.03]])).distance
        self.assertLess(inside, 0)
        self.assertAlmostEqual(outside, 0.01, delta=1e-3 * obstacle.COARSEST * 3.5)

    def test_it_stands_where_the_shape_does(self):
        shape = Part.makeBox(30, 20, 10)
        here = obstacle.placed("Box", shape).mesh(RADIUS, "obstacle")
        shape.Placement = MOVE
        there = obstacle.placed("Box", shape).mesh(RADIUS, "obstacle")
        expected = [tuple(MOVE.multVec(Vector(*(1e3 * v)))) for v in here.vertices]
        self.assertLess(np.abs(1e3 * there.vertices - expected).max(), 1e-9)
        low, high = obstacle.placed("Box", shape).bounds
        self.assertTrue((low <= there.vertices.min(axis=0) + 1e-12).all())
        self.assertTrue((high >= there.vertices.max(axis=0) - 1e-12).all())

    def test_what_has_neither_moved_nor_changed_is_not_taken_apart_again(self):
        def bounds(shape):
            return [it.bounds.tolist() for _, it in obstacle.solids("One", shape)]

        one = Part.makeBox(30, 20, 10)
        first = obstacle.solids("One", one)
        self.assertIs(obstacle.solids("One", Part.Shape(one)), first)
        here = bounds(one)
        one.Placement = MOVE
        self.assertEqual(bounds(one), [obstacle.placed("Alone", one).bounds.tolist()])
        self.assertNotEqual(bounds(one), here)
        one.Placement = Placement()
        self.assertEqual(bounds(one), here)
        self.assertNotEqual(bounds(Part.makeBox(1, 1, 1)), here)

    def test_what_is_added_to_a_compound_is_seen(self):
        compound = Part.makeCompound([Part.makeBox(30, 20, 10)])
        self.assertEqual(len(obstacle.solids("Compound", compound)), 1)
        compound.add(Part.makeSphere(5))
        # FreeCAD 1.0 and later go on saying one themselves.
        self.assertEqual(len(obstacle.solids("Compound", compound)), len(compound.Solids))

    def test_one_that_was_inside_out_is_seen_when_it_is_turned(self):
        inside_out = Part.makeBox(30, 20, 10).reversed()
        with self.assertRaises(ProblemError):
            obstacle.placed("Turned", inside_out).mesh(RADIUS, "obstacle")
        obstacle.placed("Turned", inside_out.reversed()).mesh(RADIUS, "obstacle")

    def test_it_is_made_once_for_the_same_shape(self):
        box = Part.makeBox(30, 20, 10)
        real = obstacle.MeshPart.meshFromShape
        with mock.patch.object(obstacle.MeshPart, "meshFromShape", side_effect=real) as mesher:
            first = obstacle.placed("Once", box).mesh(RADIUS, "obstacle")
            self.assertIs(obstacle.placed("Once", Part.Shape(box)).mesh(RADIUS, "obstacle"), first)
            self.assertEqual(mesher.call_count, 1)
            moved = Part.Shape(box)
            moved.Placement = MOVE
            obstacle.placed("Once", moved).mesh(1.01 * RADIUS, "obstacle")
            self.assertEqual(mesher.call_count, 1)
            obstacle.placed("Once", Part.makeBox(30, 20, 11)).mesh(RADIUS, "obstacle")
            self.assertEqual(mesher.call_count, 2)
            obstacle.placed("Once", Part.makeBox(30, 20, 11)).mesh(RADIUS / 4, "obstacle")
            self.assertEqual(mesher.call_count, 3)

    def test_the_triangles_of_the_window_are_neither_used_nor_lost(self):
        ball = Part.makeSphere(20)
        plain = obstacle.placed("Plain", Part.makeSphere(20)).mesh(RADIUS, "obstacle")
        ball.tessellate(0.05)
        shown = ball.countElement("Face"), len(ball.Faces[0].tessellate(10)[0])
        made = obstacle.placed("Shown", ball).mesh(RADIUS, "obstacle")
        self.assertEqual(len(made.triangles), len(plain.triangles))
        self.assertEqual((ball.countElement("Face"), len(ball.Faces[0].tessellate(10)[0])), shown)

    def test_a_shape_turned_inside_out(self):
        box = Part.makeBox(30, 20, 10)
        box.reverse()
        with self.assertRaises(ProblemError):
            obstacle.placed("Reversed", box).mesh(RADIUS, "obstacle")


assert FreeCAD  # loaded before Part
