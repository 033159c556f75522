# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cable among nested and linked parts: it follows every move, inside and outside of their assembly."""

from FreeCAD import Placement, Rotation, Vector
from scenes import TOP, DocumentTest

from freecad_cable.document import make
from freecad_cable.document.reference import container

TURN = Placement(Vector(15, -10, 25), Rotation(Vector(1, 1, 2), 20))


class AssemblyTest(DocumentTest):
    """Assembly ⊃ unit ⊃ pin, and a second instance of the unit by a link, 120 mm beside it."""

    def setUp(self):
        super().setUp()
        self.assembly = self.doc.addObject("App::Part", "Assembly")
        self.unit = self.doc.addObject("App::Part", "Unit")
        self.part = self.pin("Pin", (0, 0, 0))
        self.unit.addObject(self.part)
        self.twin = self.doc.addObject("App::Link", "Twin")
        self.twin.LinkedObject = self.unit
        self.twin.Placement.Base = Vector(120, 0, 0)
        self.assembly.addObjects([self.unit, self.twin])
        self.assembly.Placement = Placement(Vector(0, 0, 500), Rotation(Vector(0, 0, 1), 90))
        self.doc.recompute()

    def add_cable(self, inside):
        ends = [
            make.terminal(self.doc, (root, f"Pin.{TOP}"), inside=inside)
            for root in (self.unit, self.twin)
        ]
        self.cable = make.cable(self.doc, start=ends[0], end=ends[1], length="300 mm")
        self.route = make.route(self.doc, self.cable)
        self.compute()
        return self.cable

    def ends(self):
        """Where the ends of both pins are, in the coordinates of the cable."""
        outside = Placement() if container(self.cable) else self.assembly.Placement
        tip = self.part.Placement * Placement(Vector(0, 0, 10), Rotation())
        return [(outside * unit.Placement * tip).Base for unit in (self.unit, self.twin)]

    def assertConnected(self):
        self.compute()
        wire = self.cable.Centreline.Shape.Edges[0]
        for at, expected in zip(
            (wire.FirstParameter, wire.LastParameter), self.ends(), strict=True
        ):
            self.assertNear(wire.valueAt(at), expected, 1e-6)
            self.assertNear(
                self.route.Shape.Edges[0].valueAt(
                    0 if at == 0 else self.route.Shape.Edges[0].LastParameter
                ),
                expected,
                1e-6,
            )

    def test_it_follows_every_move(self):
        for inside in (self.assembly, None):
            self.add_cable(inside)
            self.assertConnected()
            for moved in (self.part, self.unit, self.twin, self.assembly):
                moved.Placement = TURN * moved.Placement
                self.assertConnected()

    def test_it_follows_a_move_of_which_the_touch_was_taken_back(self):
        """As assembly solvers do."""
        for inside in (self.assembly, None):
            self.add_cable(inside)
            for moved in (self.unit, self.twin):
                moved.Placement = TURN * moved.Placement
                for obj in (moved, self.assembly):
                    obj.purgeTouched()
                self.assertConnected()

    def test_inside_a_move_of_the_assembly_solves_nothing(self):
        cable = self.add_cable(self.assembly)
        before = cable.SolvedInputs, cable.NodePosition
        self.assembly.Placement = TURN
        self.compute()
        self.assertEqual((cable.SolvedInputs, cable.NodePosition), before)

    def test_gravity_is_said_in_the_container(self):
        """The assembly is turned about z, so inside and outside both see the same shape."""
        inside = self.add_cable(self.assembly).SmallestBendRadius.Value
        outside = self.add_cable(None).SmallestBendRadius.Value
        self.assertAlmostEqual(inside / outside, 1, delta=1e-4)

    def test_put_into_the_assembly_it_takes_its_terminals_along(self):
        cable = self.add_cable(None)
        family = {cable, cable.Start, cable.End, cable.Centreline, self.route}
        self.assembly.addObject(cable)
        self.assertEqual({obj for obj in family if container(obj) is self.assembly}, family)
        self.assertEqual(cable.End.Reference, [(self.twin, (f"Pin.{TOP}",))])
        self.assertConnected()
        self.assembly.removeObjects(sorted(family, key=lambda obj: obj.Name))
        self.assertEqual(cable.End.Reference, [(self.assembly, (f"Twin.Pin.{TOP}",))])
        self.assertConnected()

    def test_a_link_to_the_assembly_shows_the_cable_too(self):
        self.add_cable(self.assembly)
        link = self.doc.addObject("App::Link", "Copy")
        link.LinkedObject = self.assembly
        self.compute()
        self.assertIn(f"{self.cable.Name}.", link.getSubObjects())
