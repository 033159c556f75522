# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the objects look in tree and window, and what of it a file keeps."""

import os
import tempfile
import unittest
import zipfile

import FreeCAD

from freecad_cable.document import make


class ViewsTest(unittest.TestCase):
    def setUp(self):
        self.document = FreeCAD.newDocument("Views")
        left = self.document.addObject("Part::Box", "Left")
        right = self.document.addObject("Part::Box", "Right")
        right.Placement.Base = FreeCAD.Vector(200, 0, 0)
        self.document.recompute()
        start = make.terminal(self.document, (left, "Face6"))
        end = make.terminal(self.document, (right, "Face6"))
        self.cable = make.cable(self.document, start=start, end=end)
        self.route = make.route(self.document, self.cable)
        for number, kind in enumerate((make.clamp, make.clip, make.ring, make.sleeve), 1):
            kind(
                self.document,
                (left, f"Vertex{number}"),
                position="60 mm",
                **({"radius": "9 mm"} if kind is make.ring else {}),
            )
        self.document.recompute()

    def tearDown(self):
        FreeCAD.closeDocument(self.document.Name)

    def reopened(self, without=None):
        """The document, saved and opened again, perhaps without one member of its file."""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "views.FCStd")
            self.document.saveAs(path)
            FreeCAD.closeDocument(self.document.Name)
            if without:
                with zipfile.ZipFile(path) as file:
                    members = {n: file.read(n) for n in file.namelist() if n != without}
                with zipfile.ZipFile(path, "w") as file:
                    for name, content in members.items():
                        file.writestr(name, content)
            self.document = FreeCAD.openDocument(path)
        return self.document

    def ours(self):
        return [o for o in self.document.Objects if hasattr(o, "Proxy")]

    def views(self):
        return {o.Name: type(o.ViewObject.Proxy).__name__ for o in self.ours()}

    def test_every_object_has_its_view_and_icon(self):
        self.assertEqual(len(self.ours()), 10)
        for obj in self.ours():
            view = obj.ViewObject.Proxy
            self.assertEqual(type(view).__name__, type(obj.Proxy).__name__ + "View")
            self.assertTrue(os.path.isfile(view.getIcon()), obj.Name)
            self.assertTrue(obj.ViewObject.Visibility, obj.Name)

    def test_what_belongs_to_a_cable_stands_under_it(self):
        children = self.cable.ViewObject.Proxy.claimChildren()
        expected = [self.cable.Start, self.cable.End, self.cable.Centreline, self.route]
        self.assertCountEqual(children, expected)
        self.cable.Supports = [self.document.Ring, self.document.Clamp]
        children = self.cable.ViewObject.Proxy.claimChildren()
        self.assertCountEqual(children, [*expected, *self.cable.Supports])

    def test_a_file_keeps_what_is_hidden(self):
        self.route.ViewObject.Visibility = False
        views = self.views()
        document = self.reopened()
        self.assertEqual(self.views(), views)
        self.assertTrue(document.Cable.ViewObject.Visibility)
        self.assertFalse(document.Route.ViewObject.Visibility)
        self.assertEqual(len(document.Cable.ViewObject.Proxy.claimChildren()), 4)

    def test_a_file_written_without_a_window_is_seen(self):
        views = self.views()
        document = self.reopened(without="GuiDocument.xml")
        self.assertEqual(self.views(), views)
        self.assertTrue(document.Cable.ViewObject.Visibility)
        self.assertEqual(len(document.Cable.ViewObject.Proxy.claimChildren()), 4)
