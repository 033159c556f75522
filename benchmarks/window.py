# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long a person waits, in FreeCAD's window: from the move of a slider to the new line of a cable with two supports,
and from the edit of a property to the new solid on the screen, for the ten cables of the demo.

    xvfb-run -a -s "-screen 0 1400x900x24" freecad benchmarks/window.py

Runs in the folder of the checkout, of an installed add-on, on a machine that does nothing else.
"""

import os
import statistics
import sys
import time

import FreeCAD
import FreeCADGui
import Part
from FreeCAD import Placement, Rotation, Vector
from PySide import QtCore, QtGui

sys.path.append("docs/pictures")
from taking import take

MOVES, EDITS = 40, 5

STEP = 4
"""Of the slider, of a thousand: 1 mm of this cable"""

PATIENCE = 20.0
"""[s]"""


def say(line):
    print(line, file=sys.__stdout__, flush=True)


def pump(until):
    """Let the window live until something is so. Its own loop waits without Python, as when a person works."""
    end = time.monotonic() + PATIENCE
    loop, timer = QtCore.QEventLoop(), QtCore.QTimer()
    timer.timeout.connect(lambda: loop.quit() if until() or time.monotonic() > end else None)
    timer.start(1)
    (loop.exec_ if hasattr(loop, "exec_") else loop.exec)()  # Qt 5, Qt 6
    if not until():
        raise TimeoutError


def supported():
    """A cable that hangs between two plates through two rings."""
    from freecad_cable.document import make

    document = FreeCAD.newDocument("Supported")
    turn = Rotation(Vector(0, 0, 1), Vector(1, 0, 0))
    references = []
    for name, x, z in (("A", -100, 0), ("B", -40, -25), ("C", 40, -25), ("D", 100, 0)):
        plate = document.addObject("Part::Feature", name)
        hole = Part.makeCylinder(8, 4, Vector(0, 0, -2))
        plate.Shape = Part.makeBox(40, 40, 2, Vector(-20, -20, -1)).cut(hole)
        plate.Placement = Placement(Vector(x, 0, z), turn)
        edges = enumerate(plate.Shape.Edges, 1)
        number = next(i for i, edge in edges if isinstance(edge.Curve, Part.Circle))
        references.append((plate, f"Edge{number}"))
    document.recompute()
    first, *between, last = references
    start = make.terminal(document, first)
    end = make.terminal(document, last)
    kind = make.cable_type(document, "Multi-core cable 7 mm")
    rings = [make.ring(document, each) for each in between]
    cable = make.cable(document, start=start, end=end, cable_type=kind, supports=rings, slack=0.15)
    document.recompute()
    for terminal, way in ((start, 1), (end, -1)):
        if terminal.Frame.Rotation.multVec(Vector(0, 0, 1)).x * way < 0:
            terminal.Reverse = True
    cable.LengthMode, cable.Length = "Fixed", 245
    return document, cable


def slider():
    """Seconds from a move to the line, and to the line on the screen."""
    from freecad_cable.document import solving
    from freecad_cable.gui.live import live

    document, cable = supported()
    document.recompute()
    solving.wait(document)
    if not cable.isValid():
        raise RuntimeError(cable.Status)
    FreeCADGui.activeDocument().activeView().viewFront()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    cable.ViewObject.doubleClicked()
    (widget,) = FreeCADGui.getMainWindow().findChildren(QtGui.QSlider, "LengthSlider")
    middle, drawn = widget.value(), []
    # Heard, not looked for: to look again and again would take the time of the thread that solves.
    live.moved.connect(lambda key, found, sentence: drawn.append(found))
    widget.setSliderDown(True)
    for move in range(MOVES + 5):
        del drawn[:]
        begin = time.perf_counter()
        widget.setValue(middle + STEP * (1 + move % 20))
        pump(lambda: drawn)
        there = time.perf_counter() - begin
        FreeCADGui.updateGui()
        if move >= 5:  # the first ones build what the others use
            yield there, time.perf_counter() - begin
        if drawn != [drawn[0]] or drawn[0] is None:
            raise RuntimeError("a move without a line")
    widget.setSliderDown(False)
    FreeCADGui.Control.closeDialog()
    FreeCAD.closeDocument(document.Name)


def edits():
    """For each cable of the demo: its name, and seconds from an edit of its length to the solid on the screen."""
    from freecad_cable.demo import equipment
    from freecad_cable.document import solving

    document = FreeCAD.newDocument("Equipment")
    cables = [cable for cable, _ in equipment.build(document)]
    document.recompute()
    solving.wait(document)
    FreeCADGui.SendMsgToActiveView("ViewFit")
    FreeCADGui.updateGui()
    for cable in cables:
        length, times = cable.Length.Value, []
        for edit in range(EDITS):
            begin = time.perf_counter()
            cable.Length = length + 0.5 * (edit + 1)
            document.recompute()
            pump(lambda cable=cable: not cable.OutOfDate)
            FreeCADGui.updateGui()
            times.append(time.perf_counter() - begin)
        if not cable.isValid():
            raise RuntimeError(cable.Status)
        yield cable.Label, times


def milliseconds(times):
    return f"median {1e3 * statistics.median(times):.0f} ms, slowest {1e3 * max(times):.0f} ms"


def measure():
    FreeCADGui.getMainWindow().showMaximized()
    FreeCADGui.activateWorkbench("CableWorkbench")
    load = ", ".join(f"{each:.1f}" for each in os.getloadavg())
    say(f"{os.cpu_count()} cores, load {load}")
    there, shown = zip(*slider(), strict=True)
    say(f"slider to line, two supports: {milliseconds(there)}")
    say(f"slider to line on the screen: {milliseconds(shown)}")
    every = []
    for label, times in edits():
        say(f"edit to solid on the screen, {label}: {milliseconds(times)}")
        every += times
    say(f"edit to solid on the screen, all: {milliseconds(every)}")


take(measure)
