# SPDX-License-Identifier: LGPL-2.1-or-later
import unittest

import FreeCAD
import known_curves
import numpy as np
import Part
from FreeCAD import Vector
from known_curves import arc, changed, coil, rod, sag, turning

from freecad_cable.geometry import rotation
from freecad_cable.shape.centreline import ACCURACY, centreline, centreline_wire


class TestCentreline(unittest.TestCase):
    def assert_follows(self, nodes, accuracy=ACCURACY):
        """Position, tangent and curvature at the nodes; length."""
        curve = centreline(nodes)
        length = nodes.arc_length[-1] * 1e3
        allowed = accuracy * length
        # An error a of a quintic over a span h goes like 64 a (u (1 - u))³: its first derivative is at
        # most 6 a/h, its second 24 a/h².
        span = np.diff(curve.getKnots()).min()
        tangents = rotation.tangent(nodes.quaternion)
        curvature = np.linalg.norm(nodes.curvature[:, :2], axis=1) / 1e3
        for r, t, kappa in zip(nodes.position * 1e3, tangents, curvature, strict=True):
            s = curve.parameter(Vector(*r))
            self.assertLess((curve.value(s) - Vector(*r)).Length, 2 * allowed)
            self.assertLess((curve.tangent(s)[0] - Vector(*t)).Length, 6 * allowed / span)
            self.assertAlmostEqual(curve.curvature(s), kappa, delta=24 * allowed / span**2)
        # Moved aside by a everywhere, a curve gets longer by a times its turn.
        self.assertAlmostEqual(curve.length(), length, delta=allowed * (turning(nodes) + 1e-6))
        return curve

    def test_rod_like_curves(self):
        for name, nodes in known_curves.rod_like().items():
            with self.subTest(name):
                curve = self.assert_follows(nodes)
                self.assertIn(curve.Continuity, ("C2", "CN"))

    def test_uneven_nodes(self):
        s = 0.73 * (1 - np.cos(np.linspace(0, np.pi, 61))) / 2
        fine = sag(1000)
        near = np.unique(np.round(s / 0.73 * 1000).astype(int))
        self.assert_follows(known_curves.picked(fine, near))

    def test_from_ten_nodes_to_four_hundred(self):
        self.assert_follows(sag(399))
        # Nine pieces turn by up to 0.7 rad each: Hermite's remainder, R 0.7⁶/46080 for an arc, is a
        # few times what is allowed to finer nodes.
        self.assert_follows(sag(9), accuracy=1e-5)

    def test_the_parameter_is_the_arc_length(self):
        nodes = sag(100)
        curve = centreline(nodes)
        for s, r in zip(nodes.arc_length * 1e3, nodes.position * 1e3, strict=True):
            self.assertLess((curve.value(s) - Vector(*r)).Length, 2 * ACCURACY * 730)
        self.assertAlmostEqual(curve.LastParameter, 730, delta=2 * ACCURACY * 730)

    def test_as_many_poles_as_the_shape_needs(self):
        self.assertLess(centreline(sag(400)).NbPoles, 1.5 * centreline(sag(50)).NbPoles)

    def test_between_two_nodes_of_an_arc(self):
        nodes = rod([arc(0.05, 1.0)], 1)
        curve = centreline(nodes)
        centre = Vector(50, 0, 0)
        distances = [(curve.value(s) - centre).Length for s in np.linspace(0, 50, 30)]
        # Hermite's remainder for an arc of 1 rad: R/46080.
        np.testing.assert_allclose(distances, 50, atol=50 / 46080)

    def test_curvature_jumps_without_ringing(self):
        for name, nodes in known_curves.with_jumps().items():
            with self.subTest(name):
                curve = centreline(nodes)
                self.assertEqual(curve.Continuity, "C1")
                length = nodes.arc_length[-1] * 1e3
                tightest = np.linalg.norm(nodes.curvature, axis=1).max() / 1e3
                seen = [curve.curvature(s) for s in np.linspace(0, length, 2000)]
                # Straight or exactly as bent as the arc, to 1 %, within a thousandth of the length.
                bent = np.array(seen) > 0.01 * tightest
                self.assertLess(max(seen), 1.01 * tightest)
                self.assertGreater(np.array(seen)[bent].min(), 0.99 * tightest)
                self.assertAlmostEqual(curve.length(), length, delta=1e-6 * length * turning(nodes))

    def test_a_stretched_rod(self):
        nodes = changed(sag(), position=1.1 * sag().position)
        curve = centreline(nodes)
        self.assertAlmostEqual(curve.length() / (1.1 * 730), 1, delta=1e-6 * turning(nodes))


class TestNativeSweep(unittest.TestCase):
    def setUp(self):
        self.doc = FreeCAD.newDocument()
        self.addCleanup(FreeCAD.closeDocument, self.doc.Name)

    def test_the_centreline_is_a_spine(self):
        curves = {
            **known_curves.rod_like(),
            "ten nodes": sag(9),
            "four hundred nodes": sag(399),
            "tight coil": rod([coil(0.02, 0.012, 5)], 100),
        }
        for name, nodes in curves.items():
            with self.subTest(name):
                solid = self.sweep(centreline_wire(nodes), nodes)
                self.assertTrue(solid.isValid())
                self.assertEqual(solid.ShapeType, "Solid")
                # The native sweep approximates to 1e-4 mm of 4 mm.
                volume = np.pi * 4**2 * nodes.arc_length[-1] * 1e3
                self.assertAlmostEqual(solid.Volume / volume, 1, delta=5e-5)

    def sweep(self, wire, nodes):
        spine = self.doc.addObject("Part::Feature", "Spine")
        spine.Shape = wire
        section = self.doc.addObject("Part::Feature", "Section")
        axis = Vector(*rotation.tangent(nodes.quaternion[0]))
        start = Vector(*(nodes.position[0] * 1e3))
        section.Shape = Part.Wire([Part.Circle(start, axis, 4).toShape()])
        sweep = self.doc.addObject("Part::Sweep", "Sweep")
        sweep.Sections, sweep.Spine = [section], (spine, ["Edge1"])
        sweep.Solid, sweep.Frenet = True, False
        self.doc.recompute()
        return sweep.Shape
