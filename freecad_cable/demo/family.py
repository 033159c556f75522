# SPDX-License-Identifier: LGPL-2.1-or-later
"""A study of the demo: its shapes and its numbers, read from the document, so that they are what the file holds."""

import csv
from dataclasses import dataclass

import numpy as np

from ..document.study_sheet import columns

SAMPLES = 160
"""Points on a line of the picture."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Family:
    """Shapes and numbers over the values of a study; lengths in mm."""

    title: str
    name: str
    """of the values, with their unit"""
    values: list[float]
    lines: list[np.ndarray]
    """(n, 3) of each value"""
    columns: dict[str, list[str]]
    """head and cells of its spreadsheet"""
    allowed: float
    """smallest bend radius"""
    jumps: list[float]

    @classmethod
    def of(cls, study):
        """Of a study over a range that was run, each value with a shape."""
        cells = columns(study)
        return cls(
            title=study.Label,
            name=next(iter(cells)),
            values=list(study.DrawnValues),
            lines=[np.array(wire.discretize(SAMPLES)) for wire in study.Shape.Wires],
            columns=cells,
            allowed=study.Cable.SmallestBendRadius.Value - study.Cable.BendRadiusMargin.Value,
            jumps=list(study.JumpValues),
        )

    def numbers(self, head) -> list[float]:
        return [float(cell) for cell in self.columns[head]]

    def write_csv(self, path):
        """One row a value, with the digits of the spreadsheet."""
        with open(path, "w", newline="", encoding="utf-8") as file:
            rows = csv.writer(file)
            rows.writerow(self.columns)
            rows.writerows(zip(*self.columns.values(), strict=True))
