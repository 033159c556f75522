# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rings at the edges of real holes, whose plate is an obstacle: plain, chamfered, rounded, with a slot."""

import Part
from FreeCAD import Vector
from scenes import TOP, DocumentTest

from freecad_cable.document import make

RADIUS = 10


class HoleTest(DocumentTest):
    def wall(self, change):
        """A wall 4 mm thick with a hole, changed as ``change`` says with its shape and its round edges."""
        hole = Part.makeCylinder(RADIUS, 8, Vector(-2, 60, 70), Vector(1, 0, 0))
        shape = Part.makeBox(4, 120, 110).cut(hole)
        wall = self.doc.addObject("Part::Feature", "Wall")
        wall.Shape = change(shape, [edge for edge in shape.Edges if _is_round(edge)])
        wall.Placement.Base = Vector(130, 0, 0)
        return wall

    def check(self, change):
        """The cable goes up, through the hole at an angle, and down; it keeps clear of the wall, and lies on it."""
        wall = self.wall(change)
        ends = self.pin("Left", (30, 40, 20)), self.pin("Right", (230, 80, 20))
        start, end = (make.terminal(self.doc, (pin, TOP)) for pin in ends)
        end.Condition = "Swivel"
        cable = make.cable(self.doc, start=start, end=end, length="380 mm")
        edges = enumerate(wall.Shape.Edges, 1)
        _, edge = min((e.Curve.Center.x, f"Edge{i}") for i, e in edges if _is_round(e))
        make.hold(cable, make.ring(self.doc, (wall, edge), slides=True))
        cable.Obstacles = [wall]
        self.compute()
        self.assertEqual(cable.Status, "The cable is in equilibrium.")
        self.assertTrue(cable.ContactPlaces)
        # The solver leaves a hundredth of the radius, and an edge that is so deep in a cable of 7 mm shares with it
        # 0.035 mm deep, √(2 · 3.5 · 0.035) mm wide to either side and some mm long: less than 0.05 mm³ for each mm.
        self.assertAlmostEqual(cable.SmallestClearance.Value, 0, delta=0.035)
        self.assertLess(cable.Shape.common(wall.Shape).Volume, 0.05)

    def test_plain(self):
        self.check(lambda shape, edges: shape)

    def test_with_a_chamfer(self):
        self.check(lambda shape, edges: shape.makeChamfer(1.0, edges[:1]))

    def test_with_rounded_edges(self):
        self.check(lambda shape, edges: shape.makeFillet(1.0, edges))

    def test_with_a_slot(self):
        slot = Part.makeBox(8, 30, 4, Vector(-2, 60, 68))
        self.check(lambda shape, edges: shape.cut(slot))


def _is_round(edge):
    return isinstance(edge.Curve, Part.Circle)
