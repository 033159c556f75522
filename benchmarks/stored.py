# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rows as files: what pictures and report are made from."""

import csv
from dataclasses import astuple, fields
from pathlib import Path

from benchmarks.among import Among
from benchmarks.left_out import LeftOut
from benchmarks.measure import Mesh, Race, Work
from benchmarks.outcomes import Outcome
from benchmarks.peers.parent import Peer
from benchmarks.profile_solve import Part
from benchmarks.runs import Run
from benchmarks.scaling import Drag, Scaling
from benchmarks.studies import Study

FOLDER = Path(__file__).resolve().parents[1] / "docs" / "benchmarks"
FILES = {
    Work: "work.csv",
    Race: "race.csv",
    Mesh: "mesh.csv",
    Scaling: "scaling.csv",
    Drag: "drag.csv",
    LeftOut: "left-out.csv",
    Peer: "peers.csv",
    Outcome: "extreme.csv",
    Among: "contact.csv",
    Part: "profile.csv",
    Study: "studies.csv",
    Run: "runs.csv",
}


def write(rows: list):
    """Rows of one kind into its file, six digits a number."""
    kind = type(rows[0])
    FOLDER.mkdir(parents=True, exist_ok=True)
    with open(FOLDER / FILES[kind], "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(field.name for field in fields(kind))
        table.writerows([_text(value) for value in astuple(row)] for row in rows)


def read(kind) -> list:
    """The stored rows of one kind; none if their part was never run."""
    if not (FOLDER / FILES[kind]).exists():
        return []
    with open(FOLDER / FILES[kind], newline="", encoding="utf-8") as file:
        return [
            kind(**{field.name: _value(row[field.name], field.type) for field in fields(kind)})
            for row in csv.DictReader(file)
        ]


def _text(value):
    return f"{value:.6g}" if isinstance(value, float) else value


def _value(text, kind):
    if kind is str:
        return text
    if text == "":
        return None
    if kind is bool:
        return text == str(True)
    return int(text) if kind in (int, int | None) else float(text)
