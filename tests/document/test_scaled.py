# SPDX-License-Identifier: LGPL-2.1-or-later
"""What stands in a link that scales it: a place keeps its directions, and a cable is thicker, not only longer."""

import math

from FreeCAD import Placement, Rotation, Vector
from scenes import TOP, DocumentTest

from freecad_cable.document import interference, make
from freecad_cable.document.read_scene import read_scene

RADIUS = 3.5
FACETS = RADIUS / 20


class ScaledTest(DocumentTest):
    """A unit, and a link to it."""

    def setUp(self):
        super().setUp()
        self.unit = self.doc.addObject("App::Part", "Unit")
        self.link = self.doc.addObject("App::Link", "Twin")
        self.link.LinkedObject = self.unit
        self.link.Placement = Placement(Vector(0, 80, 0), Rotation(10, 20, 30))


class TerminalTest(ScaledTest):
    def setUp(self):
        super().setUp()
        self.system = self.doc.addObject("PartDesign::CoordinateSystem", "System")
        self.system.Placement = Placement(Vector(1, 2, 3), Rotation(40, 90, 20))
        self.unit.addObjects([self.system, self.doc.addObject("Part::Box", "Box")])
        self.doc.recompute()

    def test_the_directions_are_those_without_the_scale(self):
        at_system = make.terminal(self.doc, (self.link, "System."))
        at_vertex = make.terminal(self.doc, [(self.link, "Box.Vertex1"), (self.link, "System.")])
        expected = self.link.Placement.Rotation * self.system.Placement.Rotation
        for scale in (1, 2, 3, 0.5):
            self.link.Scale = scale
            self.compute()
            for terminal in (at_system, at_vertex):
                self.assertTrue(terminal.Frame.Rotation.isSame(expected, 1e-12), scale)
            place = self.link.Placement.multVec(self.system.Placement.Base * scale)
            self.assertNear(at_system.Frame.Base, place)

    def test_a_scale_that_leaves_no_directions(self):
        terminal = make.terminal(self.doc, (self.link, "System."))
        for scale in (Vector(1, 2, 1), Vector(-1, -1, -1)):
            self.link.ScaleVector = scale
            self.assertFailed(terminal, "Reference", "System is stretched or mirrored", "one scale")
        self.link.ScaleVector = Vector(1, 1, 1)
        self.compute()


class CableTest(ScaledTest):
    """A cable in the unit, and another one that the link comes near to."""

    def setUp(self):
        super().setUp()
        pins = self.pin("Low", (60, -60, 70), (0, 1, 0)), self.pin("High", (60, 90, 70), (0, -1, 0))
        self.unit.addObjects(pins)
        start, end = (
            make.terminal(self.doc, (pin, TOP), inside=self.unit, condition="Swivel")
            for pin in pins
        )
        self.inner = make.cable(self.doc, start=start, end=end, length="180 mm")
        self.cable_between_pins()
        self.end.Condition = "Swivel"
        self.cable.Obstacles = (self.link, f"{self.inner.Name}.")
        self.link.Placement = Placement(Vector(-40, -30, 0), Rotation(5, 0, 0))
        self.doc.recompute()

    def apart(self):
        """The distance of the surfaces, from the exact shapes."""
        solid = self.link.getSubObject(f"{self.inner.Name}.")
        return self.cable.Centreline.Shape.distToShape(solid)[0] - RADIUS

    def test_another_cable_is_scaled_with_its_section(self):
        self.unit.Visibility = False
        for scale in (1, 2, 0.5):
            self.link.Scale = scale
            self.compute()
            (tube,) = read_scene(self.cable).obstacles
            self.assertAlmostEqual(1e3 * tube.radius, scale * RADIUS, delta=1e-9)
            self.assertAlmostEqual(
                self.cable.SmallestClearance.Value, self.apart(), delta=2 * FACETS
            )
            self.assertEqual(self.cable.ContactObstacles, [])
            found = interference.report(self.doc, limit="100 mm")
            (row,) = [r for r in found if {r.cable, r.other} == self.labels()]
            self.assertAlmostEqual(row.distance, self.apart(), delta=2 * FACETS)

    def labels(self):
        return {self.cable.Label, self.inner.Label}

    def test_the_scaled_cable_is_measured_along_its_own_length(self):
        """Only the link can be seen, and a box beside it, halfway along."""
        self.unit.Visibility = self.cable.Visibility = False
        for scale in (1, 2, 0.5):
            self.link.Scale = scale
            middle = self.link.getSubObject(f"{self.inner.Name}.", retType=4).multVec(
                1e3 * self.inner.NodePosition[len(self.inner.NodePosition) // 2]
            )
            ball = self.doc.getObject("Ball") or self.doc.addObject("Part::Sphere", "Ball")
            ball.Radius = 2
            ball.Placement.Base = middle + Vector(0, 0, 30)
            self.doc.recompute()
            solid = self.link.getSubObject(f"{self.inner.Name}.")
            (row,) = interference.report(self.doc, [ball], "100 mm")
            exact = solid.distToShape(ball.Shape)[0]
            self.assertAlmostEqual(row.distance, exact, delta=2 * FACETS * scale + 0.1)
            self.assertLess(row.point.distanceToPoint(ball.Placement.Base), 31 + scale * RADIUS)

    def test_one_that_is_stretched(self):
        self.link.ScaleVector = Vector(1, 2, 1)
        self.assertFailed(self.cable, "Obstacles", "is stretched or mirrored")
        self.unit.Visibility = False
        (row,) = [r for r in interference.report(self.doc) if r.cable == self.inner.Label]
        self.assertTrue(math.isnan(row.distance))
        self.assertIn("is stretched or mirrored", row.verdict)
