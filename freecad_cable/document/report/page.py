# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report as one HTML page that needs nothing beside it."""

import math
from base64 import b64encode
from html import escape
from pathlib import Path

import FreeCAD
from FreeCAD import Vector

from . import drawing, plot
from .entry import Verdict
from .tables import details, types

STYLE = Path(__file__).parents[3] / "resources" / "report.css"

translate = FreeCAD.Qt.translate


def overview():
    """Pairs of the heading of a column and what stands in it."""
    return (
        (
            translate("CableReport", "Cable"),
            lambda e: f'<a href="#{_anchor(e)}">{escape(e.label)}</a>',
        ),
        (translate("CableReport", "Verdict"), lambda e: _verdict(e)),
        (
            translate("CableReport", "Length<br>[mm]"),
            lambda e: _number(e.cable.SolvedLength.Value, 1),
        ),
        (
            translate("CableReport", "Cut length<br>[mm]"),
            lambda e: _number(e.cable.CutLength.Value, 1),
        ),
        (
            translate("CableReport", "Smallest bend<br>radius [mm]"),
            lambda e: _number(e.cable.SmallestBendRadius.Value, 1),
        ),
        (translate("CableReport", "Allowed<br>[mm]"), lambda e: _number(e.allowed or math.nan, 1)),
        (translate("CableReport", "Margin"), lambda e: _number(100 * e.relative_margin, 1, " %")),
        (translate("CableReport", "Clearance<br>[mm]"), lambda e: _number(e.clearance, 1)),
        (translate("CableReport", "Spline route<br>[mm]"), lambda e: _number(e.spline_length, 1)),
        (
            translate("CableReport", "Its bend<br>radius [mm]"),
            lambda e: _number(e.spline_radius, 1),
        ),
        (translate("CableReport", "Largest end<br>force [N]"), lambda e: _load(e, "force")),
        (translate("CableReport", "Largest end<br>moment [N m]"), lambda e: _load(e, "moment")),
        (translate("CableReport", "Mass<br>[g]"), lambda e: _number(1e3 * e.cable.Mass, 1)),
        (translate("CableReport", "Error<br>[mm]"), lambda e: f"{e.cable.ErrorEstimate.Value:.2g}"),
        (
            translate("CableReport", "Solved in<br>[ms]"),
            lambda e: _number(1e3 * e.cable.SolveTime, 0),
        ),
    )


def notes():
    """What a reader must know of the overview."""
    return (
        translate(
            "CableReport",
            "The worst cable comes first: those without an answer, those that fail, those of which something is not "
            "known; among equals the smallest margin. The margin is by how much the smallest bend radius is above the "
            "allowed one, relative to that. Bend radii are those of the centreline.",
        ),
        translate(
            "CableReport",
            "Clearance is the least distance of the cable's surface to any visible solid and any other cable, where "
            "one is within 20 mm of it, except where the cable is held. Coordinates, forces and moments are in the "
            "coordinates of the document; forces and moments are those of the connectors and supports on the cable.",
        ),
        translate(
            "CableReport",
            "The spline route is the curve through the same terminals and supports that a drawing would show, without "
            "stiffness, weight and given length. Tolerances of the cut length are those of IPC/WHMA-A-620, Table 11-1, "
            "as an industry review draft has them.",
        ),
    )


def page(title, meta, entries, edges, picture=None) -> str:
    """The page. ``meta``: what stands under the title; ``edges`` as ``drawing.outlines`` gives them; ``picture``: bytes
    of a PNG of the window, or None."""
    solved = [entry for entry in entries if entry.line]
    body = [
        f"<h1>{escape(title)}</h1>",
        f'<p class="meta">{escape(meta)}</p>',
        f"<p>{_counts(entries)}</p>",
        _overview(entries, solved),
        *(f'<p class="note">{note}</p>' for note in notes()),
        _pictures(solved, edges, picture),
        *(_section(entry, edges, solved) for entry in entries),
        types(entries),
    ]
    # Of the page: in a language without a translation it is English, as headless.
    language = translate("CableReport", "en")
    return (
        f'<!DOCTYPE html>\n<html lang="{language}"><head><meta charset="utf-8"><title>{escape(title)}</title>'
        f"<style>{STYLE.read_text(encoding='utf-8')}</style></head>\n<body>\n"
        + "\n".join(body)
        + "\n</body></html>\n"
    )


def _counts(entries):
    if not entries:
        return translate("CableReport", "The document has no cables.")
    found = {verdict: sum(e.verdict is verdict for e in entries) for verdict in Verdict}
    said = [
        f'<span class="verdict {_class(verdict)}">{verdict.text}: {count}</span>'
        for verdict, count in found.items()
        if count
    ]
    return f"{translate('CableReport', 'Cables')}: {len(entries)}&emsp;{'&emsp;'.join(said)}"


def _overview(entries, solved):
    if not entries:
        return ""
    columns = overview()
    head = "".join(f"<th>{title}</th>" for title, _ in columns)
    rows = []
    for entry in entries:
        shown = columns if entry.line else columns[:2]
        cells = "".join(f"<td>{value(entry)}</td>" for _, value in shown)
        if not entry.line:
            cells += f'<td class="text" colspan="{len(columns) - 2}">{escape(entry.sentence)}</td>'
        rows.append(f"<tr>{cells}</tr>")
    return (
        f'<div class="scroll"><table class="wide"><thead><tr>{head}</tr></thead><tbody>{"".join(rows)}</tbody></table>'
        f"</div>{_sums(solved)}"
    )


def _sums(solved):
    if not solved:
        return ""
    length = sum(e.cable.SolvedLength.Value for e in solved)
    cut = sum(e.cable.CutLength.Value for e in solved)
    mass = sum(e.cable.Mass for e in solved)
    shares = (entry.centre * (entry.cable.Mass / mass) for entry in solved)
    centre = sum(shares, Vector())
    said = translate(
        "CableReport",
        "Together: length {length} mm, cut length {cut} mm, mass {mass} g, centre of mass {centre} mm.",
    ).format(
        length=f"{length:.1f}",
        cut=f"{cut:.1f}",
        mass=f"{1e3 * mass:.1f}",
        centre=f"({centre.x:.1f}, {centre.y:.1f}, {centre.z:.1f})",
    )
    return f"<p>{said}</p>"


def _pictures(solved, edges, picture):
    if not solved:
        return ""
    shown = [drawing.all_cables(solved, edges, view) for view in drawing.VIEWS]
    if picture:
        caption = translate("CableReport", "As the window shows it")
        shown.insert(
            0,
            f'<figure><img alt="" src="data:image/png;base64,{b64encode(picture).decode()}">'
            f"<figcaption>{caption}</figcaption></figure>",
        )
    return f'<div class="columns">{"".join(shown)}</div>'


def _section(entry, edges, solved):
    head = f'<section id="{_anchor(entry)}"><h2>{escape(entry.label)} {_verdict(entry)}</h2>'
    reasons = [*entry.failures, *entry.doubts]
    said = f"<p>{escape(entry.sentence)}</p>"
    if reasons and entry.line:
        said = f'<ul class="reasons">{"".join(f"<li>{escape(r)}</li>" for r in reasons)}</ul>{said}'
    if not entry.line:
        return f"{head}{said}</section>"
    tint = drawing.colour(solved.index(entry))
    figures = drawing.one_cable(entry, edges, tint) + plot.curvature(entry, tint)
    return f'{head}{said}<div class="columns"><div>{figures}</div><div>{details(entry)}</div></div></section>'


def _verdict(entry):
    return f'<span class="verdict {_class(entry.verdict)}">{entry.verdict.text}</span>'


def _class(verdict):
    return verdict.value.lower().replace(" ", "-")


def _anchor(entry):
    return f"cable-{entry.cable.Name}"


def _number(value, digits, unit=""):
    return f"{value:.{digits}f}{unit}".replace("-", "−") if math.isfinite(value) else "–"


def _load(entry, name):
    return f"{max(getattr(load, name).Length for load in (entry.loads[0], entry.loads[-1])):.2g}"
