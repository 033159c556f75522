# SPDX-License-Identifier: LGPL-2.1-or-later
"""The satellite of the demo: what holds its cables, what they keep clear of, how short they are."""

import unittest
from dataclasses import replace
from types import SimpleNamespace

import FreeCAD
import Part
from FreeCAD import Vector

from freecad_cable.demo import satellite, table
from freecad_cable.demo.satellite_wiring import CLEARANCE, CLIPS, HOLES, RUNS
from freecad_cable.document.read_scene import read_scene
from freecad_cable.equilibrium import find_equilibrium

TOUCHING = 0.01
"""[of the radius] Depth that the solver leaves between nodes."""


def setUpModule():
    global document, pairs
    document = FreeCAD.newDocument("Satellite")
    unittest.addModuleCleanup(FreeCAD.closeDocument, document.Name)
    pairs = []
    for pair in satellite.build(document):
        document.recompute()
        pairs.append(pair)


class SatelliteTest(unittest.TestCase):
    def test_at_least_nine_cables_over_every_hole_and_clip(self):
        self.assertGreaterEqual(len(pairs), 9)
        over = [name for run in RUNS.values() for name in run.over]
        self.assertEqual(sorted(over), sorted([*HOLES, *CLIPS]))

    def test_every_cable_passes_its_holes_and_clips(self):
        for cable, _ in pairs:
            line = cable.Centreline.Shape
            for name in RUNS[cable.Label].over:
                with self.subTest(cable=cable.Label, over=name):
                    held = HOLES.get(name) or CLIPS[name]
                    gap = line.distToShape(Part.Vertex(Vector(*held.centre)))[0]
                    inside = held.radius if name in HOLES else held.bore
                    self.assertLess(gap + cable.CableType.OuterDiameter.Value / 2, inside)

    def test_the_bend_is_allowed_and_a_millimetre_less_would_not_be(self):
        for cable, _ in pairs:
            with self.subTest(cable.Label):
                self.assertTrue(cable.isValid(), cable.Status)
                self.assertGreaterEqual(cable.BendRadiusMargin.Value, 0)
                scene = read_scene(cable)
                rod = replace(scene.rod, length=scene.rod.length - 1e-3)
                shorter = find_equilibrium(replace(scene, rod=rod))
                self.assertTrue(shorter.status.success, shorter.message)
                self.assertLess(shorter.min_bend_radius[0], rod.min_bend_radius)

    def test_cables_keep_clear_measured_on_the_solids(self):
        """Of the solids themselves; the solver has triangles. The cable's own plugs are left out with its ends."""
        solids = Part.getShape(document.getObject("Satellite")).Solids
        clips = [Vector(*clip.centre) for clip in CLIPS.values()]
        for cable, _ in pairs:
            radius = cable.CableType.OuterDiameter.Value / 2
            points = middle(cable)
            wire = Part.makePolygon(points)
            least = (
                -TOUCHING * radius if RUNS[cable.Label].lies_on else CLEARANCE - TOUCHING * radius
            )
            reach = wire.BoundBox
            reach.enlarge(radius + CLEARANCE)
            for solid in solids:
                a_clip = any(solid.BoundBox.isInside(centre) for centre in clips)
                if solid.BoundBox.intersect(reach) and not a_clip:
                    with self.subTest(cable.Label):
                        self.assertGreater(solid.distToShape(wire)[0] - radius, least)

    def test_one_cable_lies_on_the_floor(self):
        lying = [cable for cable, _ in pairs if RUNS[cable.Label].lies_on]
        self.assertTrue(lying)
        for cable in lying:
            depth = TOUCHING * cable.CableType.OuterDiameter.Value / 2
            self.assertAlmostEqual(cable.SmallestClearance.Value, 0, delta=depth)


class ClaimTest(unittest.TestCase):
    def test_base_and_sign(self):
        one = SimpleNamespace(length=90, spline_length=100, radius=1, spline_radius=3, allowed=2)
        two = SimpleNamespace(length=330, spline_length=300, radius=1, spline_radius=1, allowed=2)
        for each in (one, two):
            each.difference = each.spline_length - each.length
            each.relative_difference = 100 * each.difference / each.spline_length
        said = table.claim([one, two])
        self.assertIn("420.0 mm, are 5.0 % longer than their spline routes, 400.0 mm", said)
        self.assertIn("the mean over the cables is 0.0 % longer", said)
        self.assertIn("1 of 2 cables are shorter", said)
        self.assertIn("1 of the splines", said)
        self.assertIn("are 10.0 % shorter", table.claim([one]))


def middle(cable):
    """Of the centreline, without its ends."""
    (edge,) = cable.Centreline.Shape.Edges
    points = edge.discretize(400)
    return points[12:-12]
