# SPDX-License-Identifier: LGPL-2.1-or-later
"""Supports as objects: where they stand, what they show, and what they say when they cannot."""

import os
import tempfile

import FreeCAD
from FreeCAD import Placement, Rotation, Vector
from scenes import SIDE, DocumentTest

from freecad_cable.document import make
from freecad_cable.document.support import Clamp, Clip, Ring, Sleeve
from freecad_cable.errors import DocumentError

KINDS = {"Clamp": make.clamp, "Clip": make.clip, "Ring": make.ring, "Sleeve": make.sleeve}
MOVE = Placement(Vector(30, -20, 50), Rotation(Vector(1, 2, -3), 77))


class SupportTest(DocumentTest):
    def setUp(self):
        super().setUp()
        self.part, edge = self.plate("Plate", (1, 2, 3), (1, 0, 0), radius=9)
        self.hole = self.part, edge
        self.doc.recompute()

    def assertAxis(self, support, base, axis):
        self.compute()
        self.assertNear(support.Frame.Base, base)
        self.assertLess(support.Frame.Rotation.multVec(Vector(0, 0, 1)).cross(axis).Length, 1e-9)
        self.assertNear(support.Placement.Base, base)

    def test_each_kind_stands_in_the_hole_and_moves_with_the_plate(self):
        for name, make_it in KINDS.items():
            support = make_it(self.doc, self.hole, position="10 mm")
            self.assertEqual(support.Name, name)
            self.part.Placement = Placement(
                Vector(1, 2, 3), Rotation(Vector(0, 0, 1), Vector(1, 0, 0))
            )
            self.assertAxis(support, (1, 2, 3), Vector(1, 0, 0))
            width = 9 * (1 + 3**0.5 / 2) if name == "Clip" else 18  # open over 60 degrees
            self.assertAlmostEqual(support.Shape.BoundBox.YLength, width, delta=1e-6)
            old = self.part.Placement
            self.part.Placement = MOVE * old
            self.assertAxis(
                support, MOVE.multVec(Vector(1, 2, 3)), MOVE.Rotation.multVec(Vector(1, 0, 0))
            )

    def test_properties_and_their_units(self):
        """Names and types are a file format."""
        attached = {
            "Reference": "XLinkSubList",
            "Offset": "Placement",
            "Frame": "Placement",
            "Status": "String",
            "Slides": "Bool",
            "Position": "Distance",
        }
        for proxy, further in (
            (Clamp, {"Reverse": "Bool", "Roll": "Quantity"}),
            (Clip, {"Reverse": "Bool"}),
            (Sleeve, {"Reverse": "Bool"}),
            (Ring, {"Radius": "Distance", "Clearance": "Distance"}),
        ):
            self.assertEqual(
                {prop.name: prop.kind for prop in proxy.TABLE}, attached | further, proxy
            )
            self.assertEqual(proxy.__module__, "freecad_cable.document.support")
            support = KINDS[proxy.__name__](self.doc, self.hole)
            for prop in proxy.TABLE:
                self.assertEqual(
                    support.getTypeIdOfProperty(prop.name), f"App::Property{prop.kind}"
                )
        self.assertEqual(
            [make_it(self.doc, self.hole).Slides for make_it in KINDS.values()],
            [False, False, True, True],
        )

    def test_a_position_holds_and_no_position_slides(self):
        sleeve = make.sleeve(self.doc, self.hole, position="0.25 m")
        self.assertEqual((sleeve.Slides, sleeve.Position.Value), (False, 250))
        self.assertEqual(sleeve.getEditorMode("Position"), [])
        sleeve.Slides = True
        self.assertEqual(sleeve.getEditorMode("Position"), ["Hidden"])
        clamp = make.clamp(self.doc, self.hole)
        self.assertFailed(clamp, "Position", "0 mm", "or let the cable slide")
        self.assertTrue(clamp.Shape.isNull())
        clamp.Slides = True
        self.compute()

    def test_a_ring_has_the_radius_of_its_hole(self):
        ring = make.ring(self.doc, self.hole)
        self.compute()
        self.assertEqual(ring.Radius.Value, 9)
        self.assertEqual(ring.getEditorMode("Radius"), ["ReadOnly"])
        ring.Reference = (self.part, "Vertex1")
        ring.Radius = "6 mm"
        self.compute()
        self.assertEqual(ring.Radius.Value, 6)
        self.assertEqual(ring.getEditorMode("Radius"), [])
        self.assertAlmostEqual(ring.Shape.BoundBox.DiagonalLength, 12 * 2**0.5, delta=1e-6)
        for value, words in (
            (0, "greater than 0"),
            (-1, "greater than 0"),
            (float("nan"), "finite"),
        ):
            ring.Radius = value
            self.assertFailed(ring, "Radius", words)
        ring.Radius = 1e-9
        self.compute()  # the cable will say that it does not pass
        ring.Radius = "6 mm"
        for value, words in ((-1, "at least 0"), ("6 mm", "less than the radius of 6 mm")):
            ring.Clearance = value
            self.assertFailed(ring, "Clearance", words)

    def test_a_cylinder_holds_in_its_middle(self):
        pin = self.pin("Pin", (0, 0, 10))
        self.doc.recompute()
        sleeve = make.sleeve(self.doc, (pin, "Face1"))
        self.assertAxis(sleeve, (0, 0, 5), Vector(0, 0, 1))
        ring = make.ring(self.doc, (pin, "Face1"))
        self.compute()
        self.assertEqual(ring.Radius.Value, 4)

    def test_roll_and_offset_act_in_the_axes_of_the_reference(self):
        clamp = make.clamp(self.doc, self.hole, position=10)
        self.compute()
        plain = clamp.Frame
        clamp.Roll = "30 deg"
        clamp.Offset = Placement(Vector(1, 2, 3), Rotation(Vector(1, 0, 0), 20))
        self.compute()
        expected = plain * Placement(Vector(), Rotation(Vector(0, 0, 1), 30)) * clamp.Offset
        self.assertNear(clamp.Frame.Base, expected.Base)
        self.assertTrue(clamp.Frame.Rotation.isSame(expected.Rotation, 1e-12))
        clamp.Roll = float("nan")
        self.assertFailed(clamp, "Roll", "finite")

    def test_a_hole_inside_linked_and_nested_parts(self):
        """Wherever assembly, copy or plate go, and if an assembly solver takes back the touch."""
        assembly = self.doc.addObject("App::Part", "Assembly")
        unit = self.doc.addObject("App::Part", "Unit")
        unit.addObject(self.part)
        twin = self.doc.addObject("App::Link", "Twin")
        twin.LinkedObject = unit
        twin.Placement.Base = Vector(100, 0, 0)
        assembly.addObjects([unit, twin])
        self.doc.recompute()
        ring = make.ring(self.doc, (twin, f"Plate.{self.hole[1]}"))
        self.assertEqual(ring.Reference, [(assembly, (f"Twin.Plate.{self.hole[1]}",))])
        self.assertAxis(ring, (101, 2, 3), Vector(1, 0, 0))
        for moved in (assembly, twin, self.part):
            moved.Placement = MOVE * moved.Placement
            moved.purgeTouched()
            way = assembly.Placement * twin.Placement * self.part.Placement
            self.assertAxis(ring, way.Base, way.Rotation.multVec(Vector(0, 0, 1)))

    def test_broken_references(self):
        ring = make.ring(self.doc, (self.part, SIDE))
        self.assertFailed(ring, "Reference", "gives no direction")
        ring.Reference = self.hole
        self.compute()
        self.doc.removeObject("Plate")
        self.assertFailed(ring, "Reference", "is empty", "deleted")
        self.assertTrue(ring.Shape.isNull())
        self.assertEqual(ring.Frame, Placement())

    def test_they_come_back_from_a_file(self):
        given = {
            name: make_it(self.doc, self.hole, position="120 mm") for name, make_it in KINDS.items()
        }
        given["Ring"].Clearance = "1 mm"
        self.compute()
        before = {
            name: {
                p.name: str(getattr(obj, p.name)) for p in obj.Proxy.TABLE if "Link" not in p.kind
            }
            for name, obj in given.items()
        }
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "supports.FCStd")
            self.doc.saveAs(path)
            FreeCAD.closeDocument(self.doc.Name)
            self.doc = FreeCAD.openDocument(path)
        for name, values in before.items():
            obj = self.doc.getObject(name)
            self.assertEqual(type(obj.Proxy).__name__, name)
            for prop, value in values.items():
                self.assertEqual(str(getattr(obj, prop)), value, prop)
            obj.touch()
        self.compute()
        self.doc.Plate.Placement.Base += Vector(5, 0, 0)
        self.compute()
        self.assertNear(self.doc.Clip.Frame.Base, (6, 2, 3))

    def test_wrong_arguments(self):
        before = [obj.Name for obj in self.doc.Objects]
        for words, arguments in (
            ("roll is no property of a Ring; known are clearance", {"roll": "3 deg"}),
            ("position is 'half'; it must be something in mm", {"position": "half"}),
            ("it must be an object, or a pair", {"reference": "Plate"}),
        ):
            with self.assertRaisesRegex(DocumentError, words):
                make.ring(self.doc, **{"reference": self.hole, **arguments})
        self.assertEqual([obj.Name for obj in self.doc.Objects], before)
