# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report of what cables come near to: distances known by construction, parts and links, the table."""

import math

from FreeCAD import Placement, Rotation, Vector
from scenes import TOP, DocumentTest

from freecad_cable.document import interference, make
from freecad_cable.errors import DocumentError

RADIUS = 3.5

# The solid is measured by triangles, another cable by a polyline.
FACETS = RADIUS / 20


class InterferenceTest(DocumentTest):
    """An arch in the plane y = 0, highest over x = 60."""

    def setUp(self):
        super().setUp()
        self.cable_between_pins()
        self.end.Roll = "180 deg"
        self.compute()
        self.top = 1e3 * max(point.z for point in self.cable.NodePosition)

    def box(self, name, gap, size=(40, 40, 10)):
        """A box over the arch; ``gap`` [mm] between the surfaces."""
        box = self.doc.addObject("Part::Box", name)
        box.Length, box.Width, box.Height = size
        box.Placement.Base = Vector(60 - size[0] / 2, -size[1] / 2, self.top + RADIUS + gap)
        self.doc.recompute()
        return box

    def rows(self, *arguments, **keywords):
        self.doc.recompute()
        return interference.report(self.doc, *arguments, **keywords)

    def test_its_own_connectors_do_not_count(self):
        self.assertEqual(self.rows(), [])

    def test_a_box_at_a_known_distance(self):
        box = self.box("Roof", 4)
        for gap, verdict in ((4, "Clear"), (0, "Contact"), (-2, "Interference")):
            box.Placement.Base.z = self.top + RADIUS + gap
            (row,) = self.rows()
            self.assertEqual((row.cable, row.other, row.verdict), ("Cable", "Roof", verdict))
            # A box has no facets; the top of the arch lies between two nodes.
            self.assertAlmostEqual(row.distance, gap, delta=0.02 * RADIUS)
            self.assertNear(row.point, (60, 0, self.top), 1)
            self.assertAlmostEqual(row.position, 150, delta=1)
        self.assertEqual(self.rows(limit="1 mm"), [row])
        box.Placement.Base.z = self.top + RADIUS + 4
        self.assertEqual(self.rows(limit="3 mm"), [])
        self.cable.Clearance = "5 mm"
        (row,) = self.rows(limit="3 mm")
        self.assertEqual(row.verdict, "Too close")

    def test_the_least_distance_is_found_between_the_samples(self):
        """A thin wire across a leg of the arch, nearer to it than the samples are to each other."""
        wire = self.doc.addObject("Part::Cylinder", "Wire")
        wire.Radius, wire.Height = 0.2, 40
        for height in (20.0, 20.9, 21.7):
            wire.Placement = Placement(Vector(-8, -20, height), Rotation(Vector(1, 0, 0), -90))
            self.doc.recompute()
            exact = self.cable.Centreline.Shape.distToShape(wire.Shape)[0] - RADIUS
            (row,) = self.rows()
            self.assertAlmostEqual(row.distance, exact, delta=0.02)

    def test_two_cables(self):
        """The second is the first, turned by a quarter about the vertical through the middle and lifted."""
        kind, lift = self.type, 9.0
        pins = [self.pin(f"Pin{y}", (60, y, lift)) for y in (-60, 60)]
        self.doc.recompute()
        start, end = (make.terminal(self.doc, (pin, TOP)) for pin in pins)
        other = make.cable(self.doc, start=start, end=end, cable_type=kind, length="300 mm")
        (row,) = self.rows()
        self.assertEqual((row.cable, row.other), (self.cable.Label, other.Label))
        self.assertAlmostEqual(row.distance, lift - 2 * RADIUS, delta=FACETS)
        self.assertNear(row.point, (60, 0, self.top), 1)
        other.Visibility = False
        self.assertEqual(self.rows(), [])

    def test_two_cables_in_the_same_place_interfere(self):
        twin = make.cable(
            self.doc, start=self.start, end=self.end, cable_type=self.type, length="320 mm"
        )
        (row,) = self.rows()
        self.assertEqual((row.other, row.verdict), (twin.Label, "Interference"))
        self.assertAlmostEqual(row.distance, -2 * RADIUS, delta=FACETS)

    def test_parts_and_links(self):
        unit = self.doc.addObject("App::Part", "Unit")
        unit.addObject(self.box("Roof", 2))
        twin = self.doc.addObject("App::Link", "Twin")
        twin.LinkedObject = unit
        twin.Placement.Base = Vector(0, 0, 3)
        self.assertEqual([round(row.distance) for row in self.rows()], [2, 5])
        unit.Placement.Base = Vector(0, 0, 1)
        self.assertEqual([round(row.distance) for row in self.rows()], [3, 5])
        self.doc.Roof.Visibility = False
        self.assertEqual(self.rows(), [])
        self.assertEqual([round(row.distance) for row in self.rows([self.doc.Roof])], [3])

    def test_cables_inside_a_moved_assembly(self):
        assembly = self.doc.addObject("App::Part", "Assembly")
        assembly.addObjects([self.left, self.right, self.box("Roof", 2)])
        assembly.addObject(self.cable)
        (before,) = self.rows()
        assembly.Placement = Placement(Vector(3, -4, 5), Rotation(Vector(1, 2, -3), 20))
        (row,) = self.rows()
        self.assertEqual((row.other, row.verdict), (before.other, before.verdict))
        self.assertAlmostEqual(row.distance, before.distance, delta=1e-6)
        self.assertNear(row.point, assembly.Placement.multVec(before.point), 1e-2)

    def test_a_cable_into_its_own_connector(self):
        """Not where it is held, but farther in."""
        self.right.Height, self.right.Radius = 60, 8
        self.right.Placement.Base.z = -60
        self.start.Reverse = self.end.Reverse = True
        self.left.Height, self.left.Radius = 60, 8
        self.left.Placement.Base.z = -60
        rows = self.rows()
        self.assertEqual({row.verdict for row in rows}, {"Interference"})
        self.assertEqual({row.other for row in rows}, {"Left", "Right"})

    def test_a_cable_without_an_answer_comes_last(self):
        self.box("Roof", 2)
        broken = make.cable(self.doc, start=self.start, end=self.end, length="50 mm")
        rows = self.rows()
        self.assertEqual([row.cable for row in rows], [self.cable.Label, broken.Label])
        self.assertTrue(math.isnan(rows[-1].distance))
        self.assertIn("120 mm apart", rows[-1].verdict)

    def test_the_table(self):
        self.box("Roof", -2)
        self.box("Second roof", 3).Label = "=Second 'roof'"
        rows = self.rows()
        sheet = interference.sheet(self.doc, rows)
        self.doc.recompute()
        self.assertEqual(sheet.TypeId, "Spreadsheet::Sheet")
        self.assertEqual(sheet.get("C1"), "Distance [mm]")
        self.assertEqual([sheet.get(f"H{i}") for i in (2, 3)], ["Interference", "Clear"])
        self.assertEqual(sheet.get("B3"), "=Second 'roof'")
        self.assertAlmostEqual(sheet.get("C2"), rows[0].distance, delta=1e-3 * 2)
        again = interference.sheet(self.doc, rows[:1])
        self.doc.recompute()
        self.assertIs(again, sheet)
        with self.assertRaises(ValueError):
            sheet.get("H3")

    def test_a_limit_that_is_none(self):
        for limit in ("10 kg", "far", None, math.nan, math.inf):
            with self.assertRaisesRegex(DocumentError, "must be a length"):
                self.rows(limit=limit)

    def test_a_solid_that_is_none(self):
        with self.assertRaisesRegex(DocumentError, "one is 5; it must be an object"):
            self.rows(solids=[5])
