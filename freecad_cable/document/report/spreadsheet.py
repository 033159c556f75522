# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report as a spreadsheet of the document."""

import math

COLUMNS = (
    ("Cable", lambda e: e.label),
    ("Verdict", lambda e: e.verdict.value),
    ("Length [mm]", lambda e: e.cable.SolvedLength.Value),
    ("Cut length [mm]", lambda e: e.cable.CutLength.Value),
    ("Straight way [mm]", lambda e: e.straight),
    ("Smallest bend radius [mm]", lambda e: e.cable.SmallestBendRadius.Value),
    ("at [mm]", lambda e: e.cable.SmallestBendRadiusAt.Value),
    ("Allowed [mm]", lambda e: e.allowed or math.nan),
    ("Margin [mm]", lambda e: e.cable.BendRadiusMargin.Value if e.allowed else math.nan),
    ("Margin [%]", lambda e: 100 * e.relative_margin),
    ("Clearance [mm]", lambda e: e.clearance),
    ("to", lambda e: e.nearest),
    ("Spline route [mm]", lambda e: e.spline_length),
    ("Its bend radius [mm]", lambda e: e.spline_radius),
    ("Force at start [N]", lambda e: e.loads[0].force.Length),
    ("Moment at start [N m]", lambda e: e.loads[0].moment.Length),
    ("Force at end [N]", lambda e: e.loads[-1].force.Length),
    ("Moment at end [N m]", lambda e: e.loads[-1].moment.Length),
    ("Mass [g]", lambda e: 1e3 * e.cable.Mass),
    ("Centre x [mm]", lambda e: e.centre.x),
    ("Centre y [mm]", lambda e: e.centre.y),
    ("Centre z [mm]", lambda e: e.centre.z),
    ("Error estimate [mm]", lambda e: e.cable.ErrorEstimate.Value),
    ("Solve time [s]", lambda e: e.cable.SolveTime),
    ("What it says", lambda e: " ".join([*e.failures, *e.doubts]) or e.sentence),
)

WITHOUT_ANSWER = ("Cable", "Verdict", "What it says")
"""Columns that a cable without an answer fills."""


def sheet(doc, entries, name="CableReport"):
    """The entries in a spreadsheet called ``name``, a row each; the one of that name is filled anew."""
    table = doc.getObject(name)
    if table is None or table.TypeId != "Spreadsheet::Sheet":
        table = doc.addObject("Spreadsheet::Sheet", name)
    table.clearAll()
    for number, (title, value) in enumerate(COLUMNS):
        column = chr(ord("A") + number)
        table.set(f"{column}1", title)
        for row, entry in enumerate(entries, 2):
            if entry.line is None and title not in WITHOUT_ANSWER:
                continue
            table.set(f"{column}{row}", _cell(value(entry)))
    table.setStyle(f"A1:{chr(ord('A') + len(COLUMNS) - 1)}1", "bold")
    return table


def _cell(value):
    if isinstance(value, str):
        # An apostrophe makes text of what looks like a formula.
        return f"'{value}"
    return f"{value:.6g}" if math.isfinite(value) else ""
