# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rows of a study as a native spreadsheet, and as a drawing."""

import math

import numpy as np

from ..shape.units import from_si
from ..study.colours import scale
from ..study.plot import Panel, svg
from .complaint import in_row

COLUMNS = (
    ("Length [mm]", "length", "length"),
    ("Smallest bend radius [mm]", "smallest_bend_radius", "length"),
    ("at [mm]", "smallest_bend_radius_at", "length"),
    ("Margin [mm]", "bend_radius_margin", "length"),
    ("Clearance [mm]", "smallest_clearance", "length"),
    ("Contact force [N]", "contact_force", None),
    ("Start force [N]", "start_force", None),
    ("Start moment [N m]", "start_moment", None),
    ("End force [N]", "end_force", None),
    ("End moment [N m]", "end_moment", None),
    ("Energy [J]", "energy", None),
    ("Stable", "stable", None),
    ("Holds", "holds", None),
    ("Position error [mm]", "position_error", "length"),
    ("Time [s]", "time", None),
)
"""Head, field of the row, kind of unit that is not SI."""

LAST = 2000
"""Rows that go into the sheet: writing more takes longer than solving them."""


def write(study, names, rows, chosen):
    """Put the rows of a study, with the ``chosen`` of the ``COLUMNS``, in the place of those of its last run. All other
    cells of its spreadsheet are the user's: where one is in the way, as where there is no spreadsheet, the rows go into
    a new one."""
    heads = [f"'{head}" for head in (*names, *(head for head, *_ in chosen), "Note")]
    lines = [heads]
    lines += ([*map(_number, row.values), *_cells(study.Cable, row, chosen)] for row in rows[:LAST])
    if len(rows) > LAST:
        lines.append([f"'and {len(rows) - LAST} more"])
    size = len(heads), len(lines)
    before, after = _area(*(study.SheetSize or (0, 0))), _area(*size)
    sheet = study.Sheet
    if not _has_room(sheet, after - before):
        sheet = study.Sheet = study.Document.addObject("Spreadsheet::Sheet", f"{study.Name}Rows")
        sheet.Label = f"{study.Label} rows"
        before = set()
    coloured = len(names) == 1
    # A cell that is cleared loses the name that the user may have given it, so only where it goes, or its colour.
    for cell in before - (after if coloured else after - _area(1, len(lines))):
        sheet.clear(cell)
    for number, line in enumerate(lines, 1):
        for column, text in enumerate(line):
            cell = f"{_letters(column)}{number}"
            if text or cell in before:
                sheet.set(cell, text)
    sheet.setStyle(f"A1:{_letters(len(heads) - 1)}1", "bold")
    if coloured:
        for number, colour in enumerate(scale([row.values[0] for row in rows])[:LAST], 2):
            sheet.setBackground(f"A{number}", (*colour, 0.5))
    study.SheetSize = size
    sheet.recompute()


def _area(width, height):
    """Names of the cells of a table."""
    columns = [_letters(column) for column in range(width)]
    return {f"{letters}{row}" for letters in columns for row in range(1, height + 1)}


def _has_room(sheet, cells):
    """Whether it is a spreadsheet in which these are empty."""
    if sheet is None or sheet.TypeId != "Spreadsheet::Sheet":
        return False
    return not any(sheet.getContents(cell) for cell in cells)


def note(cable, row) -> str:
    """What a row says in words; empty if nothing."""
    return " ".join(in_row(cable, text) for text in (row.note, row.error) if text)


def columns(study) -> dict[str, list[str]]:
    """What the spreadsheet of a study says: heads, and the cells under each as text. Where the length is varied two
    columns say it; that is one here."""

    def text(column, row):
        said = study.Sheet.getContents(f"{_letters(column)}{row}").lstrip("'=")
        try:
            return _number(float(said))  # without the digits that FreeCAD adds
        except ValueError:
            return said

    width, height = study.SheetSize
    return {
        text(column, 1): [text(column, row) for row in range(2, height + 1)]
        for column in range(width)
    }


def _cells(cable, row, chosen):
    for _, field, kind in chosen:
        value = getattr(row, field)
        if isinstance(value, bool):
            yield "'yes" if value else "'no"
        elif value is None or not math.isfinite(value):
            yield ""
        else:
            yield _number(from_si(kind, value) if kind else value)
    said = note(cable, row)
    # An apostrophe makes text of what looks like a formula.
    yield f"'{said}" if said else ""


def _number(value):
    return f"{value:.6g}"


def _letters(column):
    """A, B, … Z, AA, …"""
    text = chr(ord("A") + column % 26)
    return text if column < 26 else _letters(column // 26 - 1) + text


def plot(study, name, rows, jumps, limit) -> str:
    """Bend radius, end forces and energy over the values, as SVG."""

    def of(field, kind=None):
        found = [getattr(row, field) for row in rows]
        return [from_si(kind, v) if kind and v is not None else v for v in found]

    panels = [
        Panel(
            "Smallest bend radius [mm]",
            of("smallest_bend_radius", "length"),
            None if limit is None else from_si("length", limit),
        ),
        Panel("Force of the connector at the end [N]", of("end_force")),
        Panel("Energy [J]", of("energy")),
    ]
    values = [row.values[0] for row in rows]
    return svg(study.Label, name, values, panels, [jump.value for jump in jumps])


def histogram(study, rows, limit) -> str:
    """What share of the cases has at most a bend radius, as SVG."""
    radii = sorted(
        from_si("length", row.smallest_bend_radius)
        for row in rows
        if row.smallest_bend_radius is not None and math.isfinite(row.smallest_bend_radius)
    )
    if not radii:
        return svg(study.Label, "none of the cases has a shape", [0.0, 1.0], [])
    chosen = np.unique(np.linspace(0, len(radii) - 1, 200).astype(int))
    panel = Panel("Share of the cases that bend as sharply", [(k + 1) / len(radii) for k in chosen])
    lines = () if limit is None else [from_si("length", limit)]
    inside = [line for line in lines if radii[0] <= line <= radii[-1]]
    return svg(
        study.Label, "smallest bend radius [mm]", [radii[k] for k in chosen], [panel], inside
    )
