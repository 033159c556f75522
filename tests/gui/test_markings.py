# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the window draws over a cable: colours, the tightest place, forces, contacts; and never an old state."""

import os
import tempfile

import FreeCAD
from FreeCAD import Vector
from window import WindowTest

from freecad_cable.document import make
from freecad_cable.gui.views.markings import GOOD, NO_LIMIT, SCARCE, VIOLATED, colour

DRAWN = ("ColourByBendRadius", "ShowTightest", "ShowForces", "ShowContacts")


class MarkingsTest(WindowTest):
    def setUp(self):
        super().setUp()
        floor = self.document.addObject("Part::Box", "Floor")
        floor.Length, floor.Width = 60, 40
        floor.Placement.Base = Vector(-40, -15, -90)
        self.make_cable(length="310 mm", obstacles=[floor])
        self.view, self.drawn = self.cable.ViewObject, self.cable.ViewObject.Proxy
        for name in DRAWN:
            setattr(self.view, name, True)

    def all_drawn(self):
        drawn = self.drawn
        return [each.shown for each in (drawn.skin, drawn.tightest, drawn.forces, drawn.contacts)]

    def reds(self):
        """Share of the points that are red."""
        near = [
            max(abs(a - b) for a, b in zip(rgb, VIOLATED, strict=True)) < 1e-3
            for rgb in self.drawn.skin.colours
        ]
        return sum(near) / len(near)

    def test_colours(self):
        self.assertEqual(colour(-1e-9), VIOLATED)
        self.assertEqual(colour(0), SCARCE)
        self.assertEqual(colour(0.1), SCARCE)
        self.assertEqual(colour(7), GOOD)
        self.assertEqual(colour(float("inf")), GOOD)

    def test_everything(self):
        self.assertTrue(self.cable.ContactPlaces)
        self.assertEqual(self.all_drawn(), [True] * 4)
        self.assertEqual(self.drawn.forces.count, 2)
        self.assertEqual(self.drawn.contacts.count, len(self.cable.ContactPlaces))
        self.assertEqual(self.reds(), 0)

    def test_red_is_what_violates(self):
        radius = self.cable.SmallestBendRadius.Value - self.kind.OuterDiameter.Value / 2
        self.kind.MinBendRadius = radius - 0.1
        self.compute()
        self.assertEqual(self.reds(), 0)
        self.kind.MinBendRadius = radius + 5
        self.compute()
        self.assertGreater(self.reds(), 0.01)
        self.assertLess(self.reds(), 0.9)
        self.kind.MinBendRadius = 0
        self.compute()
        for a, b in zip(self.drawn.skin.colours[0], NO_LIMIT, strict=True):
            self.assertAlmostEqual(a, b, delta=1e-6)

    def test_what_is_not_wanted_is_not_drawn(self):
        for k, name in enumerate(DRAWN):
            setattr(self.view, name, False)
            self.assertEqual(self.all_drawn(), [j > k for j in range(4)])

    def test_hidden_and_shown(self):
        self.view.Visibility = False
        self.assertEqual(self.all_drawn(), [False] * 4)
        self.view.Visibility = True
        self.assertEqual(self.all_drawn(), [True] * 4)

    def test_a_cable_that_failed_shows_nothing(self):
        self.cable.Length = 100
        self.compute()
        self.assertIn("Invalid", self.cable.State)
        self.assertTrue(self.cable.Shape.isNull())
        self.assertEqual(self.all_drawn(), [False] * 4)
        self.cable.Length = 310
        self.compute()
        self.assertEqual(self.all_drawn(), [True] * 4)

    def test_nothing_is_marked_while_it_moves(self):
        self.open_panel(self.cable)
        slider = self.widget("LengthSlider")
        slider.setSliderDown(True)
        slider.setValue(slider.value() + 50)
        self.wait_for(lambda: self.drawn.line.shown)
        self.assertEqual(self.all_drawn(), [False] * 4)
        slider.setSliderDown(False)
        self.rest()
        self.assertTrue(self.drawn.skin.shown)
        self.cancel()
        self.assertEqual(self.all_drawn(), [True] * 4)

    def test_the_panel_switches_them(self):
        self.open_panel(self.cable)
        self.widget("ColourByBendRadius").click()
        self.assertFalse(self.view.ColourByBendRadius)
        self.assertFalse(self.drawn.skin.shown)
        self.ok()

    def test_they_are_there_after_opening(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "marked.FCStd")
            self.document.saveAs(path)
            FreeCAD.closeDocument(self.document.Name)
            self.document = FreeCAD.openDocument(path)
        self.name = self.document.Name
        self.pump(0.1)
        self.view = self.document.Cable.ViewObject
        self.drawn = self.view.Proxy
        self.assertEqual(self.all_drawn(), [True] * 4)

    def test_a_cable_with_a_profile(self):
        sketch = self.document.addObject("Sketcher::SketchObject", "Sketch")
        import Part

        corners = [(-6, -1), (6, -1), (6, 1), (-6, 1), (-6, -1)]
        for a, b in zip(corners, corners[1:], strict=False):
            sketch.addGeometry(Part.LineSegment(Vector(*a, 0), Vector(*b, 0)))
        self.document.recompute()
        self.cable.Profile = sketch
        self.compute()
        self.assertTrue(self.cable.isValid(), self.cable.Status)
        self.assertTrue(self.drawn.skin.shown)

    def test_a_second_cable_is_marked_alone(self):
        other = make.cable(
            self.document, start=self.start, end=self.end, cable_type=self.kind, length="330 mm"
        )
        self.compute()
        self.assertFalse(other.ViewObject.Proxy.skin.shown)
