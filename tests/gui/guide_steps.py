# SPDX-License-Identifier: LGPL-2.1-or-later
"""The steps of docs/guide.md: what a person does in the window, and the same as a macro.

The test of the guide does both and compares; docs/pictures/guide.py does the first and takes the pictures.
"""

from unittest import mock

import FreeCAD
import FreeCADGui
import Part
from FreeCAD import Placement, Rotation, Vector
from PySide import QtGui
from task_panel import press

from freecad_cable.document import make

EDGES = "Left.Edge3", "Right.Edge3"
LENGTH, LIMIT = 380.0, 30.0
"""[mm]"""

MOVED = Vector(200, 55, 0)
"""where the right connector goes [mm]"""


def assembly(document):
    """A board with two connectors and a wall between them that has a hole."""
    unit = document.addObject("App::Part", "Unit")
    board = document.addObject("Part::Box", "Board")
    board.Length, board.Width, board.Height = 260, 120, 4
    board.Placement.Base = Vector(0, 0, -4)
    wall = document.addObject("Part::Feature", "Wall")
    hole = Part.makeCylinder(12, 8, Vector(-2, 60, 70), Vector(1, 0, 0))
    wall.Shape = Part.makeBox(4, 120, 110).cut(hole)
    wall.Placement.Base = Vector(130, 0, 0)
    pins = []
    for name, x, y in (("Left", 30, 40), ("Right", 230, 80)):
        pin = document.addObject("Part::Cylinder", name)
        pin.Radius, pin.Height = 7, 20
        pin.Placement = Placement(Vector(x, y, 0), Rotation())
        pins.append(pin)
    unit.addObjects([board, wall, *pins])
    document.recompute()
    return unit


def edge_of_hole(wall):
    """The name of the edge of the hole on the side of the left connector."""
    circles = [
        (edge.Curve.Center.x, f"Edge{i}")
        for i, edge in enumerate(wall.Shape.Edges, 1)
        if isinstance(edge.Curve, Part.Circle)
    ]
    return min(circles)[1]


def numbers(document, shortest):
    """What the guide says of its cable, in mm and N; ``shortest`` is the least length, before there was a wall."""
    cable, route = document.Cable, document.Route
    return {
        "shortest": shortest,
        "length": cable.SolvedLength.Value,
        "radius": cable.SmallestBendRadius.Value,
        "clearance": cable.SmallestClearance.Value,
        "force": cable.EndForce.Length,
        "route": route.Length.Value,
    }


def by_macro():
    """The steps without a window; gives the numbers."""
    document = FreeCAD.newDocument("Macro")
    unit = assembly(document)
    start, end = (make.terminal(document, (unit, edge)) for edge in EDGES)
    end.Condition = "Swivel"
    cable = make.cable(document, start=start, end=end)
    cable.CableType.MinBendRadius = LIMIT
    cable.LengthMode = "Shortest"
    document.recompute()
    shortest = cable.SolvedLength.Value
    cable.LengthMode, cable.Length = "Fixed", LENGTH
    cable.Update = "Live"
    document.recompute()
    hole = make.ring(document, (unit, f"Wall.{edge_of_hole(document.Wall)}"), slides=True)
    make.hold(cable, hole)
    document.recompute()
    cable.Obstacles = [(unit, ("Wall.", "Board."))]
    document.recompute()
    make.route(document, cable)
    document.recompute()
    document.Right.Placement.Base = MOVED
    document.recompute()
    return numbers(document, shortest)


class Hand:
    """The steps in the window, in order. ``look(name)`` is called when there is something to see, ``rest()`` waits
    until the window has nothing more to do."""

    def __init__(self, look, rest, folder):
        self.look, self.rest, self.folder = look, rest, folder

    def steps(self):
        return (
            self.open_the_assembly,
            self.select_two_edges,
            self.run_a_cable,
            self.say_how_sharply_it_may_bend,
            self.give_it_a_length,
            self.lead_it_through_the_hole,
            self.keep_it_out_of_the_parts,
            self.compare_it_with_a_spline,
            self.move_a_connector,
            self.write_the_report,
        )

    def do(self):
        for number, step in enumerate(self.steps(), 1):
            step()
            self.rest()
            self.look(f"{number:02d}-{step.__name__.replace('_', '-')}")
        return numbers(self.document, self.shortest)

    def open_the_assembly(self):
        FreeCADGui.activateWorkbench("CableWorkbench")
        self.document = FreeCAD.newDocument("Guide")
        self.document.UndoMode = 1
        self.unit = assembly(self.document)
        view = FreeCADGui.activeView()
        view.setCameraOrientation(Rotation(Vector(0, 0, 1), 25) * Rotation(Vector(1, 0, 0), 65))
        view.fitAll()

    def select_two_edges(self):
        self._select(*EDGES)

    def run_a_cable(self):
        FreeCADGui.runCommand("Cable_Cable")

    def say_how_sharply_it_may_bend(self):
        self.document.Cable.End.Condition = "Swivel"
        self.document.CableType.MinBendRadius = LIMIT
        self.document.recompute()

    def give_it_a_length(self):
        mode = _widget("LengthMode")
        mode.setCurrentIndex(mode.findData("Shortest"))
        self.rest()
        self.shortest, self.said = self.document.Cable.SolvedLength.Value, _widget("Said").text()
        mode.setCurrentIndex(mode.findData("Fixed"))
        self.rest()
        _widget("Length").setProperty("rawValue", LENGTH)
        self.rest()
        update = _widget("Update")
        update.setCurrentIndex(update.findData("Live"))

    def lead_it_through_the_hole(self):
        press()
        self.rest()
        self._select(f"Wall.{edge_of_hole(self.document.Wall)}")
        FreeCADGui.Selection.addSelection(self.document.Name, "Cable")
        FreeCADGui.runCommand("Cable_Ring")
        FreeCADGui.Selection.clearSelection()

    def keep_it_out_of_the_parts(self):
        self.document.Cable.Obstacles = [(self.unit, ("Wall.", "Board."))]
        self.document.recompute()

    def compare_it_with_a_spline(self):
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(self.document.Name, "Cable")
        FreeCADGui.runCommand("Cable_Route")
        FreeCADGui.Selection.clearSelection()

    def move_a_connector(self):
        self.document.Right.Placement.Base = MOVED

    def write_the_report(self):
        self.document.saveAs(f"{self.folder}/guide.FCStd")
        with mock.patch.object(QtGui.QDesktopServices, "openUrl"):
            FreeCADGui.runCommand("Cable_Report")
        self.document.CableReport.ViewObject.doubleClicked()

    def _select(self, *edges):
        FreeCADGui.Selection.clearSelection()
        for edge in edges:
            FreeCADGui.Selection.addSelection(self.document.Name, self.unit.Name, edge)


def _widget(name):
    (found,) = FreeCADGui.getMainWindow().findChildren(QtGui.QWidget, name)
    return found
