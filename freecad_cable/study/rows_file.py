# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rows of a study as CSV or JSON."""

import csv
import io
import json
import math

from .row import Row

COLUMNS = {
    "length": "m",
    "smallest_bend_radius": "m",
    "smallest_bend_radius_at": "m",
    "bend_radius_margin": "m",
    "smallest_clearance": "m",
    "contact_force": "N",
    "start_force": "N",
    "start_moment": "N m",
    "end_force": "N",
    "end_moment": "N m",
    "energy": "J",
    "stable": "",
    "position_error": "m",
    "solved": "",
    "holds": "",
    "time": "s",
    "note": "",
    "error": "",
}
"""Field of a row: unit."""


def as_csv(names, rows: list[Row]) -> str:
    """Text of a table: the parameters, then ``COLUMNS``; what is not known or infinite is empty."""
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    heads = (f"{name} [{unit}]" if unit else name for name, unit in COLUMNS.items())
    table.writerow([*names, *heads])
    for row in rows:
        table.writerow([*row.values, *(_plain(getattr(row, name)) for name in COLUMNS)])
    return text.getvalue()


def as_json(names, rows: list[Row], summary: dict) -> str:
    """The same as an object with ``parameters``, ``rows`` and ``summary``."""
    data = {
        "schema": 1,
        "parameters": list(names),
        "rows": [
            {"values": list(row.values)} | {name: _plain(getattr(row, name)) for name in COLUMNS}
            for row in rows
        ],
        "summary": summary,
    }
    return json.dumps(data, indent=1, ensure_ascii=False) + "\n"


def _plain(value):
    return None if isinstance(value, float) and not math.isfinite(value) else value
