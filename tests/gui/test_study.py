# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command that makes and runs a study, and the colours of its shapes."""

import unittest

import FreeCAD
import FreeCADGui

from freecad_cable.document import make, solving, studying
from freecad_cable.gui.commands import COMMANDS
from freecad_cable.study.colours import scale


class StudyTest(unittest.TestCase):
    def setUp(self):
        self.document = FreeCAD.newDocument("Study")
        self.addCleanup(FreeCAD.closeDocument, "Study")
        left = self.document.addObject("Part::Box", "Left")
        right = self.document.addObject("Part::Box", "Right")
        right.Placement.Base = FreeCAD.Vector(200, 0, 0)
        self.document.recompute()
        start = make.terminal(self.document, (left, "Face6"))
        end = make.terminal(self.document, (right, "Face6"))
        self.cable = make.cable(self.document, start=start, end=end, length="300 mm")
        self.document.recompute()
        solving.wait(self.document)

    def select(self, obj):
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(self.document.Name, obj.Name)

    def test_the_command_makes_one_and_runs_it_again(self):
        command = COMMANDS["Cable_Study"]
        self.select(self.cable)
        self.assertTrue(command.IsActive())
        command.Activated()
        study = self.document.getObject("Study")
        self.assertEqual(list(study.DrawnValues), [300 + 7.5 * k for k in range(9)])
        self.assertEqual(self.cable.Length.Value, 300)
        self.assertIn(study.Sheet, study.ViewObject.Proxy.claimChildren())
        study.Count = 3
        self.document.recompute()
        self.assertTrue(study.OutOfDate)
        self.select(study)
        command.Activated()
        self.assertEqual(len(study.DrawnValues), 3)
        self.document.undo()
        self.assertEqual(len(study.DrawnValues), 9)
        self.document.undo()
        self.document.undo()
        self.assertIsNone(self.document.getObject("Study"))
        self.assertEqual(self.cable.Length.Value, 300)

    def test_shapes_have_the_colours_of_their_values(self):
        study = make.study(
            self.document, self.cable, varied="Length", values=[300, 340, 320], draw="Solids"
        )
        studying.run(study)
        wanted = scale([300, 340, 320])
        found = iter(study.ViewObject.DiffuseColor)
        for solid, colour in zip(study.Shape.SubShapes, wanted, strict=True):
            for _ in solid.Faces:
                for a, b in zip(next(found), colour, strict=False):
                    self.assertAlmostEqual(a, b, delta=0.01)
        study.Draw = "Centrelines"
        studying.run(study)
        self.assertEqual(len(study.ViewObject.LineColorArray), 3)
