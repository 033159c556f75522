# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench and its commands, in a window."""

import unittest
from unittest import mock

import FreeCAD
import FreeCADGui
import Part
from PySide import QtGui
from task_panel import press

from freecad_cable.document import make, solving
from freecad_cable.errors import DocumentError
from freecad_cable.gui.commands import COMMANDS

SUPPORTS = ["Clamp", "Sleeve", "Ring", "Clip"]
OF_ALL = ["Check All", "Report"]
TITLES = [
    "Cable Terminal",
    "Cable",
    *SUPPORTS,
    "Shortest Length",
    "Comparison Route",
    "Study",
    *OF_ALL,
    "Example",
]
OF_A_CABLE = ["Shortest Length", "Comparison Route", "Study", *OF_ALL]


def active():
    """Titles of the commands that can be used now."""
    commands = [FreeCADGui.Command.get(name) for name in COMMANDS]
    titles = [c.getInfo()["menuText"] for c in commands if c.isActive()]
    # It needs nothing.
    return [title for title in titles if title != "Example"]


class WorkbenchTest(unittest.TestCase):
    def test_toolbar_and_menu_offer_the_commands(self):
        FreeCADGui.activateWorkbench("CableWorkbench")
        window = FreeCADGui.getMainWindow()
        (toolbar,) = [b for b in window.findChildren(QtGui.QToolBar) if b.objectName() == "Cable"]
        self.assertEqual([a.text().replace("&", "") for a in toolbar.actions()], TITLES)
        # Those that are shown: after a change of language or workbench, FreeCAD has old ones still.
        shown = [a for a in window.menuBar().actions() if a.isVisible()]
        menus = [m for m in window.menuBar().findChildren(QtGui.QMenu) if m.menuAction() in shown]
        (menu,) = [m for m in menus if m.title().replace("&", "") == "Cable"]
        self.assertEqual([a.text().replace("&", "") for a in menu.actions()], TITLES)
        self.assertTrue(all(not a.icon().isNull() for a in toolbar.actions()))


class CommandTest(unittest.TestCase):
    """Two plates, 200 mm apart, in a moved container; the faces that look at each other."""

    def setUp(self):
        FreeCADGui.activateWorkbench("CableWorkbench")
        self.document = FreeCAD.newDocument("Commands")
        self.document.UndoMode = 1
        self.part = self.document.addObject("App::Part", "Unit")
        self.part.Placement.Base = FreeCAD.Vector(0, 0, 50)
        for name, x in (("Left", -110), ("Right", 100)):
            plate = self.document.addObject("Part::Box", name)
            plate.Placement.Base = FreeCAD.Vector(x, 0, 0)
            self.part.addObject(plate)
        self.document.recompute()
        FreeCADGui.Selection.clearSelection()

    def tearDown(self):
        FreeCAD.closeDocument(self.document.Name)

    def select(self, *paths):
        FreeCADGui.Selection.clearSelection()
        for path in paths:
            root, _, rest = path.partition(".")
            FreeCADGui.Selection.addSelection(self.document.Name, root, rest)

    def names(self):
        return {obj.Name for obj in self.document.Objects}

    def run_command(self, name):
        """The objects that a command made, checked to be one step of undo."""
        before, steps = self.names(), self.document.UndoCount
        FreeCADGui.runCommand(name)
        if FreeCADGui.Control.activeDialog():
            QtGui.QApplication.processEvents()
            press()
        solving.wait(self.document)  # a busy computer finds them beside the window
        made = self.names() - before
        self.assertEqual(self.document.UndoCount, steps + 1)
        self.document.undo()
        self.assertEqual(self.names(), before)
        self.document.redo()
        self.assertEqual(self.names(), before | made)
        return [self.document.getObject(name) for name in made]

    def of(self, proxy, objects):
        return [o for o in objects if type(getattr(o, "Proxy", None)).__name__ == proxy]

    def test_what_is_selected_decides_what_can_be_used(self):
        self.assertEqual(active(), [])
        self.select("Unit.Left.Face2")
        self.assertEqual(active(), ["Cable Terminal", *SUPPORTS])
        self.select("Unit.Left.Face2", "Unit.Right.Face1")
        self.assertEqual(active(), ["Cable"])
        self.select("Unit.Left.")
        self.assertEqual(active(), [])
        self.select("Unit.Left.Vertex1")
        self.assertEqual(active(), [])

    def test_a_terminal_sits_on_the_face_picked_inside_a_moved_part(self):
        self.select("Unit.Left.Face2")
        (terminal,) = self.of("Terminal", self.run_command("Cable_Terminal"))
        middle = FreeCAD.Vector(-100, 5, 55)
        self.assertLess(terminal.Placement.Base.distanceToPoint(middle), 1e-6)

    def test_a_terminal_sits_on_the_copy_picked_and_not_on_the_original(self):
        copy = self.document.addObject("App::Link", "Copy")
        copy.LinkedObject = self.part
        copy.Placement.Base = FreeCAD.Vector(0, 300, 0)
        self.document.recompute()
        self.select("Copy.Left.Face2")
        (terminal,) = self.of("Terminal", self.run_command("Cable_Terminal"))
        middle = FreeCAD.Vector(-100, 305, 5)
        self.assertLess(terminal.Placement.Base.distanceToPoint(middle), 1e-6)

    def test_a_cable_between_two_faces(self):
        self.select("Unit.Left.Face2", "Unit.Right.Face1")
        made = self.run_command("Cable_Cable")
        self.assertEqual(len(self.of("Terminal", made)), 2)
        (cable,) = self.of("Cable", made)
        self.assertTrue(cable.isValid(), cable.Status)
        self.assertTrue(cable.Shape.isValid())
        self.select(cable.Name)
        self.assertEqual(active(), OF_A_CABLE)
        (route,) = self.of("Route", self.run_command("Cable_Route"))
        self.assertTrue(route.Shape.isValid())

    def test_a_cable_between_two_terminals(self):
        ends = []
        for face in ("Unit.Left.Face2", "Unit.Right.Face1"):
            self.select(face)
            ends += self.of("Terminal", self.run_command("Cable_Terminal"))
        self.select(f"{ends[0].Name}.Edge1", ends[1].Name)
        self.assertEqual(active(), ["Cable"])
        (cable,) = self.of("Cable", self.run_command("Cable_Cable"))
        self.assertEqual([cable.Start, cable.End], ends)

    def cable(self):
        """A cable between the plates, beside them in their part."""
        plates = self.document.Left, self.document.Right
        ends = [
            make.terminal(self.document, (plate, face), inside=self.part)
            for plate, face in zip(plates, ("Face2", "Face1"), strict=True)
        ]
        kind = make.cable_type(self.document, "Multi-core cable 7 mm", min_bend_radius="20 mm")
        cable = make.cable(
            self.document, start=ends[0], end=ends[1], cable_type=kind, length="240 mm"
        )
        self.document.recompute()
        return cable

    def hole(self, name, x):
        """A plate across the cable, and its hole as it is picked."""
        plate = self.document.addObject("Part::Feature", name)
        hole = Part.makeCylinder(9, 4, FreeCAD.Vector(-2, 0, 0), FreeCAD.Vector(1, 0, 0))
        plate.Shape = Part.makeBox(2, 60, 60, FreeCAD.Vector(-1, -30, -30)).cut(hole)
        plate.Placement.Base = FreeCAD.Vector(x, 5, 5)
        self.part.addObject(plate)
        edges = enumerate(plate.Shape.Edges, 1)
        number = next(i for i, edge in edges if isinstance(edge.Curve, Part.Circle))
        return f"Unit.{name}.Edge{number}"

    def test_supports_alone(self):
        self.select(self.hole("Plate", 0))
        for kind in SUPPORTS:
            (made,) = self.of(kind, self.run_command(f"Cable_{kind}"))
            self.assertTrue(made.isValid(), made.Status)
            self.assertLess(made.Placement.Base.distanceToPoint(FreeCAD.Vector(0, 5, 55)), 1.001)
            self.assertTrue(made.Slides)

    def test_supports_take_their_place_along_the_cable(self):
        cable = self.cable()
        for kind, x in (("Ring", 0), ("Sleeve", -60), ("Clip", 50)):
            self.select(self.hole(f"Plate{kind}", x), f"Unit.{cable.Name}.Face1")
            self.assertEqual(active(), [*SUPPORTS, *OF_ALL])
            (made,) = self.of(kind, self.run_command(f"Cable_{kind}"))
            self.assertIn(made, cable.Supports)
        self.assertEqual([o.Name for o in cable.Supports], ["Sleeve", "Ring", "Clip"])
        self.assertTrue(cable.isValid(), cable.Status)

    def test_the_shortest_length(self):
        cable = self.cable()
        self.select(f"Unit.{cable.Name}.")
        FreeCADGui.runCommand("Cable_Shortest")
        solving.wait(self.document)
        self.assertEqual(cable.LengthMode, "Shortest")
        self.assertTrue(cable.isValid(), cable.Status)
        self.assertLess(cable.SolvedLength.Value, 240)
        self.assertGreater(cable.SolvedLength.Value, 200)
        self.document.undo()
        self.assertEqual(cable.LengthMode, "Fixed")

    def test_check_all(self):
        cable = self.cable()
        block = self.document.addObject("Part::Box", "Block")
        block.Placement.Base = FreeCAD.Vector(-5, 0, 0)
        self.part.addObject(block)
        block.Placement.Base.z = min(1e3 * p.z for p in cable.NodePosition) - 5
        (sheet,) = self.run_command("Cable_Check")
        self.assertEqual(sheet.TypeId, "Spreadsheet::Sheet")
        self.assertEqual(sheet.get("A2"), cable.Label)
        self.assertEqual((sheet.get("B2"), sheet.get("H2")), ("Block", "Interference"))

    def test_a_command_that_fails_leaves_nothing_behind(self):
        self.select("Unit.Left.Face2", "Unit.Right.Face1")
        before = self.names()
        steps = self.document.UndoCount
        with mock.patch.object(make, "cable", side_effect=DocumentError("no cable today")):
            FreeCADGui.runCommand("Cable_Cable")
        self.assertEqual(self.names(), before)
        self.assertEqual(self.document.UndoCount, steps)
