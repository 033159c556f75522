# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small documents that the tests of this room start from."""

import unittest

import FreeCAD
import Part
from FreeCAD import Placement, Rotation, Vector

from freecad_cable.document import make

TOP = "Edge3"
"""The circle at the far end of a ``Part::Cylinder``; the cable leaves there, along the cylinder's axis."""

BOTTOM, SIDE = "Edge2", "Edge1"
"""The circle at its near end, and a straight line."""


class DocumentTest(unittest.TestCase):
    """A new document for every test."""

    def setUp(self):
        self.doc = FreeCAD.newDocument()
        self.addCleanup(self.close)

    def close(self):
        if self.doc.Name in FreeCAD.listDocuments():
            FreeCAD.closeDocument(self.doc.Name)

    def pin(self, name, base, axis=(0, 0, 1)):
        """A connector of radius 4 mm whose far end is at ``base``, looking along ``axis``."""
        pin = self.doc.addObject("Part::Cylinder", name)
        pin.Radius, pin.Height = 4, 10
        turn = Rotation(Vector(0, 0, 1), Vector(*axis))
        pin.Placement = Placement(Vector(*base), turn) * Placement(Vector(0, 0, -10), Rotation())
        return pin

    def plate(self, name, base, normal=(0, 0, 1), radius=10):
        """A plate with a round hole whose middle is at ``base``, and the reference to an edge of the hole."""
        plate = self.doc.addObject("Part::Feature", name)
        hole = Part.makeCylinder(radius, 4, Vector(0, 0, -2))
        plate.Shape = Part.makeBox(80, 60, 2, Vector(-40, -30, -2)).cut(hole)
        plate.Placement = Placement(Vector(*base), Rotation(Vector(0, 0, 1), Vector(*normal)))
        (edge,) = (
            f"Edge{i}"
            for i, edge in enumerate(plate.Shape.Edges, 1)
            if isinstance(edge.Curve, Part.Circle)
            and edge.Curve.Center.distanceToPoint(Vector(*base)) < 1e-9
        )
        return plate, edge

    def cable_between_pins(self, **arguments):
        """Two pins 120 mm apart look up, and a cable hangs over from one to the other."""
        self.left, self.right = self.pin("Left", (0, 0, 0)), self.pin("Right", (120, 0, 0))
        self.start = make.terminal(self.doc, (self.left, TOP))
        self.end = make.terminal(self.doc, (self.right, TOP))
        self.type = make.cable_type(self.doc, "Multi-core cable 7 mm")
        given = {"length": "300 mm"} | arguments
        self.cable = make.cable(
            self.doc, start=self.start, end=self.end, cable_type=self.type, **given
        )
        return self.cable

    def compute(self):
        """Recompute; nothing may be left touched or in error."""
        self.doc.recompute()
        for obj in self.doc.Objects:
            self.assertEqual(obj.State, ["Up-to-date"], f"{obj.Label}: {obj.getStatusString()}")

    def assertNear(self, vector, expected, distance=1e-9):
        self.assertLessEqual(Vector(*vector).distanceToPoint(Vector(*expected)), distance)

    def assertFailed(self, obj, *words):
        """``obj`` shows an error with these words, and nothing that looks like an answer."""
        self.doc.recompute()
        self.assertIn("Invalid", obj.State, obj.Status)
        sentence = obj.getStatusString()
        self.assertEqual(sentence, obj.Status)
        for word in (obj.Label, *words):
            self.assertIn(word, sentence)
        self.assertNotIn("Traceback", sentence)
        return sentence

    def assertNothingShown(self, cable):
        """A cable without an answer: no shape, no numbers."""
        self.assertTrue(cable.Shape.isNull())
        for name in ("SolvedLength", "SmallestBendRadius", "ErrorEstimate"):
            self.assertEqual(getattr(cable, name).Value, 0, name)
        for name in ("Mass", "ElasticEnergy", "SolveTime"):
            self.assertEqual(getattr(cable, name), 0, name)
        self.assertEqual(cable.EndForce, Vector())
        self.assertEqual(cable.ModelUsed, [])


class SupportedTest(DocumentTest):
    """Two pins 120 mm apart look up; above and between them a plate with a hole, across the cable."""

    def setUp(self):
        super().setUp()
        self.part, edge = self.plate("Plate", (60, 20, 60), (1, 0, 0))
        self.hole = self.part, edge
        self.cable_between_pins(length="300 mm")
        self.doc.recompute()

    def support(self, kind, **arguments):
        made = getattr(make, kind)(self.doc, self.hole, **arguments)
        self.cable.Supports = [*self.cable.Supports, made]
        return made
