# SPDX-License-Identifier: LGPL-2.1-or-later
"""The comparison as a table, for the screen and as a file."""

import csv
from dataclasses import dataclass


@dataclass(frozen=True)
class Column:
    head: str
    unit: str
    value: str
    """name in ``Comparison``"""
    decimals: int | None = None
    """None: text"""

    def cell(self, comparison):
        value = getattr(comparison, self.value)
        if value is None:
            return "-"
        if self.decimals is None:
            return value
        # Plus zero: what rounds to nothing has no sign.
        return f"{round(value, self.decimals) + 0.0:.{self.decimals}f}"


COLUMNS = (
    Column("cable", "", "label"),
    Column("type", "", "type"),
    Column("length", "mm", "length", 1),
    Column("spline length", "mm", "spline_length", 1),
    Column("difference", "mm", "difference", 1),
    Column("difference", "% of spline", "relative_difference", 1),
    Column("bend radius", "mm", "radius", 1),
    Column("spline bend radius", "mm", "spline_radius", 1),
    Column("allowed", "mm", "allowed", 2),
    Column("margin", "mm", "margin", 2),
    Column("clearance", "mm", "clearance", 1),
    Column("solve time", "s", "solve_time", 3),
)
"""The form of Table 2 of the paper, see ``table_1``, with bend radii; the difference is spline less cable."""


def write_csv(path, comparisons):
    """One row a cable, with the digits that the document has."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file)
        rows.writerow(f"{c.head} [{c.unit}]" if c.unit else c.head for c in COLUMNS)
        rows.writerows([getattr(one, c.value) for c in COLUMNS] for one in comparisons)


def in_words(comparisons):
    """Lines of text, heads and units above the columns."""
    rows = [[c.head for c in COLUMNS], [c.unit for c in COLUMNS]]
    rows += [[c.cell(one) for c in COLUMNS] for one in comparisons]
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    for row in rows:
        aligned = (
            cell.ljust(width) if column.decimals is None else cell.rjust(width)
            for cell, width, column in zip(row, widths, COLUMNS, strict=True)
        )
        yield "  ".join(aligned).rstrip()


def claim(comparisons):
    """The sentence on how much shorter the cables are than the spline routes, with its base."""
    cables, splines = (
        sum(getattr(c, of) for c in comparisons) for of in ("length", "spline_length")
    )
    share = 100 * (splines - cables) / splines
    mean = sum(c.relative_difference for c in comparisons) / len(comparisons)
    shorter = sum(c.difference > 0 for c in comparisons)
    sharp = sum(c.spline_radius < c.allowed for c in comparisons)
    return (
        f"All cables together, {cables:.1f} mm, are {_than(share)} than their spline routes, {splines:.1f} mm; "
        f"the mean over the cables is {_than(mean)}; each time relative to the splines. "
        f"{shorter} of {len(comparisons)} cables are shorter than their spline. "
        f"{sharp} of the splines bend more sharply than allowed."
    )


def _than(share):
    return f"{abs(share):.1f} % {'shorter' if share > 0 else 'longer'}"
