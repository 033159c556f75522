# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report as a spreadsheet of the document."""

import math

import FreeCAD

translate = FreeCAD.Qt.translate


def columns():
    """Pairs of the heading, in the language of the window, and what stands below it."""
    return (
        (translate("CableReport", "Cable"), lambda e: e.label),
        (translate("CableReport", "Verdict"), lambda e: e.verdict.text),
        (translate("CableReport", "Length [mm]"), lambda e: e.cable.SolvedLength.Value),
        (translate("CableReport", "Cut length [mm]"), lambda e: e.cable.CutLength.Value),
        (translate("CableReport", "Straight way [mm]"), lambda e: e.straight),
        (
            translate("CableReport", "Smallest bend radius [mm]"),
            lambda e: e.cable.SmallestBendRadius.Value,
        ),
        (translate("CableReport", "at [mm]"), lambda e: e.cable.SmallestBendRadiusAt.Value),
        (translate("CableReport", "Allowed [mm]"), lambda e: e.allowed or math.nan),
        (
            translate("CableReport", "Margin [mm]"),
            lambda e: e.cable.BendRadiusMargin.Value if e.allowed else math.nan,
        ),
        (translate("CableReport", "Margin [%]"), lambda e: 100 * e.relative_margin),
        (translate("CableReport", "Clearance [mm]"), lambda e: e.clearance),
        (translate("CableReport", "to"), lambda e: e.nearest),
        (translate("CableReport", "Spline route [mm]"), lambda e: e.spline_length),
        (translate("CableReport", "Its bend radius [mm]"), lambda e: e.spline_radius),
        (translate("CableReport", "Force at start [N]"), lambda e: e.loads[0].force.Length),
        (translate("CableReport", "Moment at start [N m]"), lambda e: e.loads[0].moment.Length),
        (translate("CableReport", "Force at end [N]"), lambda e: e.loads[-1].force.Length),
        (translate("CableReport", "Moment at end [N m]"), lambda e: e.loads[-1].moment.Length),
        (translate("CableReport", "Mass [g]"), lambda e: 1e3 * e.cable.Mass),
        (translate("CableReport", "Centre x [mm]"), lambda e: e.centre.x),
        (translate("CableReport", "Centre y [mm]"), lambda e: e.centre.y),
        (translate("CableReport", "Centre z [mm]"), lambda e: e.centre.z),
        (translate("CableReport", "Error estimate [mm]"), lambda e: e.cable.ErrorEstimate.Value),
        (translate("CableReport", "Solve time [s]"), lambda e: e.cable.SolveTime),
        (
            translate("CableReport", "What it says"),
            lambda e: " ".join([*e.failures, *e.doubts]) or e.sentence,
        ),
    )


def sheet(doc, entries, name="CableReport"):
    """The entries in a spreadsheet called ``name``, a row each; the one of that name is filled anew."""
    table = doc.getObject(name)
    if table is None or table.TypeId != "Spreadsheet::Sheet":
        table = doc.addObject("Spreadsheet::Sheet", name)
    table.clearAll()
    shown = columns()
    for number, (title, value) in enumerate(shown):
        column = chr(ord("A") + number)
        table.set(f"{column}1", title)
        for row, entry in enumerate(entries, 2):
            if entry.line is None and number not in (0, 1, len(shown) - 1):
                continue  # without an answer there is its name, the verdict, and what it says
            table.set(f"{column}{row}", _cell(value(entry)))
    table.setStyle(f"A1:{chr(ord('A') + len(shown) - 1)}1", "bold")
    return table


def _cell(value):
    if isinstance(value, str):
        # An apostrophe makes text of what looks like a formula.
        return f"'{value}"
    return f"{value:.6g}" if math.isfinite(value) else ""
