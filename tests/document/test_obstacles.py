# SPDX-License-Identifier: LGPL-2.1-or-later
"""Obstacles: found through parts, links and groups, left out of reach, and named where they are wrong."""

import numpy as np
import Part
from FreeCAD import Placement, Rotation, Vector
from scenes import TOP, DocumentTest

from freecad_cable.document import make, results
from freecad_cable.document.obstacles import crowded
from freecad_cable.document.read_scene import read_scene
from freecad_cable.errors import DocumentError

TURN = Rotation(Vector(0, 0, 1), 30)
MOVE = Placement(Vector(3, -4, 5), Rotation(Vector(1, 2, -3), 20))


class ObstacleTest(DocumentTest):
    """A cable between two pins, and a block high above its middle, in reach."""

    def setUp(self):
        super().setUp()
        self.cable_between_pins()
        self.block = self.box("Block")
        self.compute()

    def box(self, name):
        box = self.doc.addObject("Part::Box", name)
        box.Length = box.Width = box.Height = 8
        box.Placement.Base = Vector(56, -4, 132)
        return box

    def crossing(self, **arguments):
        """A cable across the other, below it."""
        pins = [self.pin(f"Pin{y}", (60, y, 60), (0, -y, 0)) for y in (-60, 60)]
        self.doc.recompute()
        start, end = (make.terminal(self.doc, (pin, TOP)) for pin in pins)
        return make.cable(self.doc, start=start, end=end, length="130 mm", **arguments)

    def centres(self):
        """Centres [mm] of the obstacles of the scene."""
        self.doc.recompute()
        self.assertTrue(self.cable.isValid(), self.cable.Status)
        obstacles = read_scene(self.cable).obstacles
        return sorted(tuple((1e3 * o.vertices.mean(axis=0)).round(6)) for o in obstacles)

    def centre(self, *placements):
        way = Placement()
        for placement in (*placements, self.block.Placement):
            way = way * placement
        return tuple(round(x, 6) for x in way.multVec(Vector(4, 4, 4)))


class FindingTest(ObstacleTest):
    def test_a_solid(self):
        self.cable.Obstacles = self.block
        self.assertEqual(self.centres(), [self.centre()])
        (made,) = read_scene(self.cable).obstacles
        self.assertEqual(made.place, "obstacle Block")
        self.assertEqual(len(made.triangles), 12)

    def test_parts_links_arrays_and_groups(self):
        """Each instance once, wherever it is moved; a hidden part of an assembly is not there."""
        assembly = self.doc.addObject("App::Part", "Assembly")
        unit = self.doc.addObject("App::Part", "Unit")
        unit.addObject(self.block)
        twin = self.doc.addObject("App::Link", "Twin")
        twin.LinkedObject = unit
        twin.Placement.Base = Vector(0, 30, 0)
        pair = self.doc.addObject("App::Link", "Pair")
        pair.LinkedObject, pair.ElementCount = self.block, 2
        places = [Placement(Vector(20, 0, 110), Rotation()), Placement(Vector(40, 0, 110), TURN)]
        group = self.doc.addObject("App::DocumentObjectGroup", "Group")
        group.addObject(self.box("Grouped"))
        assembly.addObjects([unit, twin, pair, group])
        assembly.Placement = MOVE
        self.doc.recompute()
        for element, place in zip(pair.ElementList, places, strict=True):
            element.Placement = place
        self.doc.recompute()
        self.cable.Obstacles = assembly
        tip = self.block.Placement.inverse()
        expected = [
            self.centre(MOVE),
            self.centre(MOVE, twin.Placement),
            self.centre(MOVE),
            *(self.centre(MOVE, place * tip) for place in places),
        ]
        self.assertEqual(self.centres(), sorted(expected))
        self.block.Placement.Base += Vector(0, 0, -3)
        self.assertNotEqual(self.centres(), sorted(expected))
        unit.Visibility = False
        self.assertEqual(len(self.centres()), 4)

    def test_it_follows_every_move(self):
        unit = self.doc.addObject("App::Part", "Unit")
        unit.addObject(self.block)
        self.doc.recompute()
        for reference in (unit, (unit, "Block."), self.block):
            self.cable.Obstacles = reference
            self.compute()
            for moved in (unit, self.block):
                moved.Placement = moved.Placement * Placement(Vector(0.5, 0, 0.5), Rotation())
                moved.purgeTouched()
                self.assertIn("Touched", self.cable.State)
                self.assertEqual(self.centres(), [self.centre(unit.Placement)])

    def test_inside_an_assembly_the_coordinates_are_those_of_the_assembly(self):
        assembly = self.doc.addObject("App::Part", "Assembly")
        assembly.Placement = MOVE
        assembly.addObjects([self.block, self.left, self.right])
        assembly.addObject(self.cable)
        self.cable.Obstacles = self.block
        self.assertEqual(self.centres(), [self.centre()])

    def test_a_compound_is_its_solids(self):
        compound = self.doc.addObject("Part::Feature", "Imported")
        compound.Shape = Part.makeCompound(
            [Part.makeBox(5, 5, 5, Vector(60, y, 130)) for y in (0, 20)]
            + [Part.makeLine((0, 0, 0), (1, 0, 0))]
        )
        self.cable.Obstacles = compound
        self.assertEqual(self.centres(), [(62.5, 2.5, 132.5), (62.5, 22.5, 132.5)])

    def test_its_own_connectors_may_be_obstacles(self):
        self.cable.Obstacles = [self.left, self.right]
        self.doc.recompute()
        self.assertEqual(len(read_scene(self.cable).obstacles), 2)

    def test_out_of_reach_costs_nothing_and_changes_nothing(self):
        before = self.cable.SolvedInputs
        self.block.Placement.Base.z = 500
        self.cable.Obstacles = self.block
        self.assertEqual(self.centres(), [])
        self.assertEqual(self.cable.SolvedInputs, before)
        self.block.Placement.Base.z = 132
        self.assertEqual(self.centres(), [self.centre()])
        self.assertNotEqual(self.cable.SolvedInputs, before)

    def test_another_cable_is_a_tube(self):
        other = self.crossing()
        self.cable.Obstacles = other
        self.compute()
        (tube,) = read_scene(self.cable).obstacles
        self.assertEqual((tube.kind, tube.radius), ("tube", 0.0035))
        points = [Part.Vertex(Vector(*(1e3 * point))) for point in tube.points]
        away = [other.Centreline.Shape.distToShape(point)[0] for point in points]
        self.assertLess(max(away), 1e-6)
        nodes = np.array([tuple(v) for v in other.NodePosition])
        self.assertLess(tube.nearest(nodes).distance.max(), -0.0035 * (1 - 1 / 20))

    def test_two_cables_held_in_the_same_place(self):
        """It is said why they bend so sharply as they part."""
        other = make.cable(
            self.doc,
            start=self.start,
            end=self.end,
            cable_type=self.type,
            length="320 mm",
            obstacles=self.cable,
        )
        said = crowded(read_scene(other))
        self.assertEqual(len(said), 2)
        for place, sentence in zip(("start", "end"), said, strict=True):
            self.assertIn(f"at {place} it is held 7 mm inside {self.cable.Label};", sentence)
        beside = make.terminal(self.doc, (self.left, TOP), offset=Placement(Vector(0, 8, 0), TURN))
        beside.recompute()
        other.Start = beside
        self.assertEqual(crowded(read_scene(other)), said[1:])

    def test_clearance(self):
        self.cable.Obstacles, self.cable.Clearance = self.block, "3 mm"
        self.doc.recompute()
        scene = read_scene(self.cable)
        self.assertAlmostEqual(scene.clearance, 0.003, delta=1e-15)
        # In a hole, as a solved cable leaves it.
        for clearance, falls_short in ((2.99, False), (0.42, True)):
            self.cable.SmallestClearance = clearance
            results.write_status(self.cable, scene)
            said = "its smallest clearance is 0.42 mm where 3 mm is asked for"
            self.assertEqual(said in self.cable.Status, falls_short)

    def test_what_keeps_it_clear_is_said(self):
        """An obstacle that the cable does not touch pushes nothing."""
        top = 1e3 * max(self.cable.NodePosition, key=lambda place: place[2])
        self.block.Placement.Base = top - Vector(4, 4, 0)
        self.cable.Obstacles = self.block
        said = "only because it is pushed away"
        self.compute()
        self.assertEqual(self.cable.ContactObstacles, ["Block"])
        self.assertNotIn(said, self.cable.Status)
        self.cable.Clearance = "2 mm"
        self.compute()
        self.assertIn(
            f"keeps clear of Block at {self.cable.ContactPlaces[0]:.4g} mm", self.cable.Status
        )
        self.assertIn(said, self.cable.Status)
        self.block.Placement.Base.z = 150
        self.compute()
        self.assertNotIn(said, self.cable.Status)

    def test_make(self):
        cable = make.cable(
            self.doc,
            start=self.start,
            end=self.end,
            length="300 mm",
            obstacles=[self.block, (self.left, "")],
            clearance="2 mm",
        )
        self.doc.recompute()
        self.assertEqual({root for root, _ in cable.Obstacles}, {self.block, self.left})
        self.assertEqual(cable.Clearance.Value, 2)
        with self.assertRaisesRegex(DocumentError, "must be an object"):
            make.cable(self.doc, start=self.start, end=self.end, obstacles="Block")


class ErrorTest(ObstacleTest):
    def check(self, *words):
        self.assertFailed(self.cable, "Obstacles", *words)
        self.assertNothingShown(self.cable)

    def test_two_cables_cannot_both_be_first(self):
        other = self.crossing(obstacles=self.cable)
        self.cable.Obstacles = other
        self.doc.recompute()
        # FreeCAD computes one of them, and not what depends on it when that fails.
        self.assertEqual(sorted("Invalid" in c.State for c in (self.cable, other)), [False, True])
        for cable in (self.cable, other):
            self.assertIn("only one can have the other", cable.Status)
            self.assertNothingShown(cable)
        self.cable.Obstacles = None
        self.compute()

    def test_what_follows_from_the_cable(self):
        self.cable.Obstacles = self.cable.Centreline
        self.check("Centreline", "follows from the cable itself")

    def test_the_assembly_that_holds_the_cable(self):
        assembly = self.doc.addObject("App::Part", "Assembly")
        assembly.addObjects([self.block, self.left, self.right])
        assembly.addObject(self.cable)
        self.cable.Obstacles = assembly
        self.check("Assembly")
        self.cable.Obstacles = self.block
        self.compute()

    def test_no_solid(self):
        self.cable.Obstacles = self.type
        self.check(self.type.Label, "no solid")

    def test_a_part_that_is_gone(self):
        unit = self.doc.addObject("App::Part", "Unit")
        unit.addObjects([self.block, self.box("Rest")])
        self.cable.Obstacles = (unit, "Block.")
        self.compute()
        unit.removeObject(self.block)
        self.doc.removeObject("Block")
        self.cable.touch()
        self.check("Block", "not inside Unit")

    def test_a_part_taken_out_of_the_container_of_the_cable(self):
        unit = self.doc.addObject("App::Part", "Unit")
        unit.addObjects([self.block, self.left, self.right])
        unit.addObject(self.cable)
        self.cable.Obstacles = self.block
        self.compute()
        unit.removeObject(self.block)
        self.check("Block is not inside Unit")

    def test_a_clearance_that_is_none(self):
        self.cable.Clearance = -1
        self.assertFailed(self.cable, "Clearance", "-1 mm", "at least 0 mm")
        self.cable.Clearance = 1e300
        self.assertFailed(self.cable, "Clearance", "finite number")

    def test_an_unsolved_cable_as_obstacle(self):
        other = self.crossing()
        self.cable.Obstacles = other
        self.compute()
        other.Length = "100 mm"
        self.doc.recompute()
        self.assertNothingShown(self.cable)
        self.assertIn(f"{other.Label}, Length", self.cable.Status)
