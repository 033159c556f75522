# SPDX-License-Identifier: LGPL-2.1-or-later
"""References in every form a user may give them."""

import FreeCAD
from scenes import DocumentTest

from freecad_cable.document.reference import based_beside, find, pairs
from freecad_cable.errors import DocumentError

VECTOR = FreeCAD.Vector


class ReferenceTest(DocumentTest):
    """Assembly ⊃ unit ⊃ box; a link to the unit and a plain group, both in the assembly."""

    def setUp(self):
        super().setUp()
        self.assembly = self.add("App::Part", "Assembly", (100, 0, 0))
        self.unit = self.add("App::Part", "Unit", (0, 10, 0))
        self.box = self.add("Part::Box", "Box", (0, 0, 1))
        self.unit.addObject(self.box)
        self.assembly.addObject(self.unit)
        self.link = self.add("App::Link", "Twin", (0, 0, 1000))
        self.link.LinkedObject = self.unit
        self.assembly.addObject(self.link)
        self.group = self.doc.addObject("App::DocumentObjectGroup", "Group")
        self.assembly.addObject(self.group)
        self.post = self.add("Part::Cylinder", "Post", (0, 0, 5))
        self.group.addObject(self.post)
        self.doc.recompute()

    def add(self, kind, name, base):
        obj = self.doc.addObject(kind, name)
        obj.Placement.Base = VECTOR(*base)
        return obj

    def referrer(self, container=None):
        obj = self.doc.addObject("App::FeaturePython", "Referrer")
        if container:
            container.addObject(obj)
        return obj

    def test_at_the_top_every_form_leads_from_the_top(self):
        for given in (
            (self.box, "Face6"),
            (self.unit, "Box.Face6"),
            (self.assembly, "Unit.Box.Face6"),
        ):
            found = based_beside(self.referrer(), given)
            self.assertEqual(found, (self.assembly, "Unit.Box.Face6"))
            self.assertNear(find(found).element.CenterOfMass, (105, 15, 11))

    def test_inside_the_assembly_every_form_leads_from_the_sibling(self):
        for given in (
            (self.box, "Face6"),
            (self.unit, "Box.Face6"),
            (self.assembly, "Unit.Box.Face6"),
        ):
            found = based_beside(self.referrer(self.assembly), given)
            self.assertEqual(found, (self.unit, "Box.Face6"))
            self.assertNear(find(found).element.CenterOfMass, (5, 15, 11))

    def test_inside_the_unit(self):
        found = based_beside(self.referrer(self.unit), (self.assembly, "Unit.Box.Face6"))
        self.assertEqual(found, (self.box, "Face6"))
        self.assertNear(find(found).element.CenterOfMass, (5, 5, 11))

    def test_through_a_link(self):
        for given in ((self.link, "Box.Face6"), (self.assembly, "Twin.Box.Face6")):
            found = based_beside(self.referrer(), given)
            self.assertEqual(found, (self.assembly, "Twin.Box.Face6"))
            self.assertNear(find(found).element.CenterOfMass, (105, 5, 1011))
            inside = based_beside(self.referrer(self.assembly), given)
            self.assertEqual(inside, (self.link, "Box.Face6"))
            self.assertNear(find(inside).element.CenterOfMass, (5, 5, 1011))

    def test_a_plain_group_is_passed_over(self):
        for given in (
            (self.post, "Edge1"),
            (self.group, "Post.Edge1"),
            (self.assembly, "Group.Post.Edge1"),
        ):
            self.assertEqual(based_beside(self.referrer(), given), (self.assembly, "Post.Edge1"))
            for beside in (self.assembly, self.group):
                self.assertEqual(based_beside(self.referrer(beside), given), (self.post, "Edge1"))

    def test_a_whole_object(self):
        for given in (
            (self.box, ""),
            (self.unit, "Box"),
            (self.unit, "Box."),
            (self.assembly, "Unit.Box"),
        ):
            found = based_beside(self.referrer(), given)
            self.assertEqual(found, (self.assembly, "Unit.Box."))
            self.assertIsNone(find(found).element)
            self.assertNear(find(found).placement.Base, (100, 10, 1))

    def test_a_link_group_and_a_link_array_move_their_elements(self):
        box = self.add("Part::Box", "Loose", (0, 0, 0))
        group = self.add("App::LinkGroup", "Links", (0, 0, -50))
        group.ElementList = [box]
        array = self.add("App::Link", "Array", (0, 0, 0))
        array.LinkedObject, array.ElementCount = self.box, 2
        self.doc.recompute()
        array.ElementList[1].Placement.Base = VECTOR(7, 0, 0)
        self.doc.recompute()
        found = based_beside(self.referrer(), (box, "Face6"))
        self.assertEqual(found, (group, "Loose.Face6"))
        self.assertNear(find(found).element.CenterOfMass, (5, 5, -40))
        second = based_beside(self.referrer(), (array, "1.Face6"))
        self.assertEqual(second, (array, "1.Face6"))
        self.assertNear(find(second).element.CenterOfMass, (12, 5, 10))

    def test_what_is_elsewhere_is_refused(self):
        outside = self.add("Part::Box", "Outside", (0, 0, 0))
        with self.assertRaisesRegex(DocumentError, "Outside is not inside Assembly"):
            based_beside(self.referrer(self.assembly), (outside, "Face1"))
        with self.assertRaisesRegex(DocumentError, "Assembly contains Referrer"):
            based_beside(self.referrer(self.assembly), (self.assembly, ""))

    def test_what_is_missing_is_named(self):
        for path, words in (
            ("Face60", "Face60 of Box is missing"),
            ("?Face6", "Face6 of Box is missing"),
            ("Gone.Face1", "Gone is not inside Box"),
        ):
            with self.assertRaisesRegex(DocumentError, words):
                find((self.box, path))

    def test_pairs_of_whatever_is_given(self):
        box, post = self.box, self.post
        for given, expected in (
            (None, []),
            (box, [(box, "")]),
            ((box, "Face1"), [(box, "Face1")]),
            ([box, "Face1"], [(box, "Face1")]),
            ([(box, ("Face1", "Face2"))], [(box, "Face1"), (box, "Face2")]),
            ([(box, ())], [(box, "")]),
            ([(box, "Vertex1"), post], [(box, "Vertex1"), (post, "")]),
        ):
            self.assertEqual(pairs(given), expected)
        for given in ("Face1", 3, (box, 3), (box, None), [("Box", "Face1")]):
            with self.assertRaisesRegex(DocumentError, "it must be an object, or a pair"):
                pairs(given)
