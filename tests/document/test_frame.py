# SPDX-License-Identifier: LGPL-2.1-or-later
"""Frames from geometry: where a cable leaves, which way, and that the frame moves with the part.

Distances of 1e-9 mm and cosines of 1e-12 are rounding of coordinates of some 100 mm.
"""

import Part
from FreeCAD import Placement, Rotation, Vector
from scenes import DocumentTest

from freecad_cable.document.frame import frame_of
from freecad_cable.document.reference import find
from freecad_cable.errors import DocumentError

MOVE = Placement(Vector(30, -20, 50), Rotation(Vector(1, 2, -3), 77))


class FrameTest(DocumentTest):
    def solid(self, shape):
        obj = self.doc.addObject("Part::Feature", "Solid")
        obj.Shape = shape
        return obj

    def element(self, obj, wanted):
        """Name of the one edge or face for which ``wanted`` holds."""
        edges = enumerate(obj.Shape.Edges, 1)
        named = [(f"Edge{i}", edge) for i, edge in edges if not edge.Degenerated]
        named += [(f"Face{i}", face) for i, face in enumerate(obj.Shape.Faces, 1)]
        (name,) = [name for name, part in named if wanted(part)]
        return name

    def circle(self, obj, centre, radius):
        return self.element(
            obj,
            lambda part: (
                isinstance(getattr(part, "Curve", None), Part.Circle)
                and part.Curve.Center.distanceToPoint(Vector(*centre)) < 1e-9
                and abs(part.Curve.Radius - radius) < 1e-9
            ),
        )

    def cylinder(self, obj, radius):
        return self.element(
            obj,
            lambda part: (
                isinstance(getattr(part, "Surface", None), Part.Cylinder)
                and abs(part.Surface.Radius - radius) < 1e-9
            ),
        )

    def frame(self, obj, name, **options):
        return frame_of(find((obj, name)), **options).placement

    def assertLeaves(self, frame, base, direction):
        self.assertNear(frame.Base, base)
        self.assertNear(frame.Rotation.multVec(Vector(0, 0, 1)), direction, 1e-12)

    def assertMoved(self, frame, expected):
        self.assertNear(frame.Base, expected.Base)
        self.assertTrue(frame.Rotation.isSame(expected.Rotation, 1e-12))

    def test_out_of_both_ends_of_a_pin(self):
        pin = self.solid(Part.makeCylinder(3, 10))
        self.assertLeaves(self.frame(pin, self.circle(pin, (0, 0, 10), 3)), (0, 0, 10), (0, 0, 1))
        self.assertLeaves(self.frame(pin, self.circle(pin, (0, 0, 0), 3)), (0, 0, 0), (0, 0, -1))

    def test_out_of_both_sides_of_a_hole_in_a_plate(self):
        plate = self.solid(Part.makeBox(40, 40, 5).cut(Part.makeCylinder(3, 5, Vector(10, 10, 0))))
        top, bottom = self.circle(plate, (10, 10, 5), 3), self.circle(plate, (10, 10, 0), 3)
        self.assertLeaves(self.frame(plate, top), (10, 10, 5), (0, 0, 1))
        self.assertLeaves(self.frame(plate, bottom), (10, 10, 0), (0, 0, -1))

    def test_off_the_plate_at_the_foot_of_a_pin(self):
        part = Part.makeBox(40, 40, 5).fuse(Part.makeCylinder(3, 20, Vector(10, 10, 0)))
        part = self.solid(part.removeSplitter())
        self.assertLeaves(
            self.frame(part, self.circle(part, (10, 10, 5), 3)), (10, 10, 5), (0, 0, 1)
        )

    def test_out_of_a_blind_hole(self):
        block = Part.makeBox(40, 40, 40).cut(Part.makeCylinder(3, 30, Vector(10, 10, 10)))
        block = self.solid(block)
        floor = self.circle(block, (10, 10, 10), 3)
        self.assertLeaves(self.frame(block, floor), (10, 10, 10), (0, 0, 1))

    def test_away_from_the_part_where_no_flat_face_meets_the_circle(self):
        for z, way, cone in (
            (10, 1, Part.makeCone(3, 1, 5, Vector(0, 0, 10))),
            (0, -1, Part.makeCone(1, 3, 5, Vector(0, 0, -5))),
        ):
            part = self.solid(Part.makeCylinder(3, 10).fuse(cone).removeSplitter())
            edge = self.circle(part, (0, 0, z), 3)
            self.assertLeaves(self.frame(part, edge), (0, 0, z), (0, 0, way))

    def test_a_circle_without_a_solid_leaves_along_its_axis(self):
        circle = self.solid(Part.makeCircle(3, Vector(1, 2, 3), Vector(0, -1, 0)))
        self.assertLeaves(self.frame(circle, "Edge1"), (1, 2, 3), (0, -1, 0))

    def test_out_of_a_face(self):
        box = self.solid(Part.makeBox(10, 20, 30))
        for name, base, direction in (
            ("Face1", (0, 10, 15), (-1, 0, 0)),
            ("Face2", (10, 10, 15), (1, 0, 0)),
            ("Face6", (5, 10, 30), (0, 0, 1)),
        ):
            self.assertLeaves(self.frame(box, name), base, direction)

    def test_out_of_the_far_end_of_a_cylindrical_face(self):
        part = self.solid(
            Part.makeBox(20, 20, 20).fuse(Part.makeCylinder(3, 30, Vector(10, 10, 10)))
        )
        face = self.cylinder(part, 3)
        self.assertLeaves(self.frame(part, face), (10, 10, 40), (0, 0, 1))
        self.assertLeaves(self.frame(part, face, reverse=True), (10, 10, 20), (0, 0, -1))

    def test_reverse_turns_into_the_part(self):
        pin = self.solid(Part.makeCylinder(3, 10))
        frame = self.frame(pin, self.circle(pin, (0, 0, 10), 3), reverse=True)
        self.assertLeaves(frame, (0, 0, 10), (0, 0, -1))
        self.assertLeaves(
            self.frame(self.solid(Part.makeBox(10, 20, 30)), "Face6", reverse=True),
            (5, 10, 30),
            (0, 0, -1),
        )
        pin.Placement = MOVE
        turned = MOVE * Placement(Vector(), Rotation(Vector(1, 0, 0), 180))
        self.assertMoved(self.frame(pin, "", reverse=True), turned)

    def test_a_vertex_takes_its_axes_from_its_part_or_from_another_object(self):
        box = self.solid(Part.makeBox(10, 20, 30))
        box.Placement = MOVE
        corner = box.Shape.Vertexes[0].Point
        frame = self.frame(box, "Vertex1")
        self.assertNear(frame.Base, corner)
        self.assertTrue(frame.Rotation.isSame(MOVE.Rotation, 1e-12))
        axes = self.solid(Part.makeBox(1, 1, 1))
        axes.Placement.Rotation = Rotation(Vector(0, 1, 0), 90)
        frame = self.frame(box, "Vertex1", axes=find((axes, "")))
        self.assertLeaves(frame, corner, (1, 0, 0))

    def test_the_frame_moves_with_the_part_as_a_rigid_body(self):
        part = (
            Part.makeBox(40, 40, 5)
            .fuse(Part.makeCylinder(3, 20, Vector(10, 10, 0)))
            .removeSplitter()
        )
        part = self.solid(part)
        names = [self.circle(part, (10, 10, 20), 3), self.cylinder(part, 3), "Face1", "Vertex1", ""]
        before = {name: self.frame(part, name) for name in names}
        part.Placement = MOVE
        for name in names:
            self.assertMoved(self.frame(part, name), MOVE * before[name])

    def test_a_circle_of_no_size_is_refused(self):
        dot = self.doc.addObject("Part::Feature", "Dot")
        dot.Shape = Part.Circle(Vector(1, 2, 3), Vector(0, 0, 1), 1e-8).toShape()
        with self.assertRaisesRegex(DocumentError, "no size; choose another"):
            frame_of(find((dot, "Edge1")))

    def test_what_has_no_direction_is_refused(self):
        box, ball = self.solid(Part.makeBox(1, 1, 1)), self.solid(Part.makeSphere(2))
        for obj, name in ((box, "Edge1"), (ball, "Face1"), (ball, "Edge1")):
            with self.assertRaisesRegex(DocumentError, f"{name} of Solid.* gives no direction"):
                self.frame(obj, name)
        with self.assertRaisesRegex(DocumentError, "only a vertex takes a second entry"):
            self.frame(box, "Face1", axes=find((ball, "")))
