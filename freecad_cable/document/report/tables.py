# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of one cable on the page, and that of the cable types."""

import math
from html import escape

TOLERANCES = ((300, 25), (1500, 50), (3000, 100), (7500, 150))
"""Cut length up to [mm], and by how much a cable may be longer [mm]: IPC/WHMA-A-620 Table 11-1, as an industry review
draft has it."""

BEYOND = 0.05
"""Tolerance of a longer one, relative."""

LONG_BEND = 1e6
"""[mm] From here on a cable is straight to whoever reads."""


def details(entry):
    """Length, bend, loads and model of a solved cable."""
    return "".join(
        f"<h3>{title}</h3>{table}"
        for title, table in (
            ("Length", _pairs(_length(entry))),
            ("Bend and clearance", _pairs(_bend(entry))),
            ("Forces and moments on the cable", _loads(entry)),
            ("Mass, and how it was solved", _pairs(_model(entry))),
        )
    )


def types(entries):
    """The cable types and where their numbers are from."""
    kinds = {entry.cable.CableType for entry in entries if entry.cable.CableType}
    if not kinds:
        return ""
    rows = []
    for kind in sorted(kinds, key=lambda kind: kind.Label):
        lines = "<br>".join(escape(line) for line in kind.Provenance)
        rows.append(
            f'<tr><td>{escape(kind.Label)}</td><td class="text">{escape(kind.Status)}</td><td class="text">{lines}</td>'
            "</tr>"
        )
    head = '<tr><th>Type</th><th class="text">Section</th><th class="text">Where its numbers are from</th></tr>'
    return f"<section><h2>Cable types</h2><table>{head}{''.join(rows)}</table></section>"


def tolerance(length):
    """[mm] by which a cable of this cut length may be longer."""
    return next((more for up_to, more in TOLERANCES if length <= up_to), BEYOND * length)


def _length(entry):
    cable = entry.cable
    solved, cut = cable.SolvedLength.Value, cable.CutLength.Value
    if not math.isnan(entry.straight):
        yield "Straight way over the supports", _mm(entry.straight)
        yield (
            "Slack",
            f"{_mm(solved - entry.straight)}, {100 * (solved / entry.straight - 1):.1f} %",
        )
    if len(entry.stretches) > 1:
        for place, stretch in entry.stretches:
            yield f"… to {place}", _mm(stretch)
    yield "Length between the terminals", _mm(solved)
    if cable.LengthMode == "Shortest":
        yield (
            "Shortest and longest that will do",
            f"{_mm(cable.ShortestLength.Value)}, {_mm(cable.LongestLength.Value)}",
        )
    allowances = cable.StartAllowance.Value, cable.EndAllowance.Value
    yield "Allowance at start and end", f"{_mm(allowances[0])}, {_mm(allowances[1])}"
    yield "Rounded up by", _mm(cut - solved - sum(allowances))
    yield "Cut length", f"<b>{_mm(cut)}</b> +{tolerance(cut):.0f}/−0"
    if not math.isnan(entry.spline_length):
        difference = entry.spline_length - solved
        share = 100 * difference / solved
        yield "Spline route", f"{_mm(entry.spline_length)} ({difference:+.1f} mm, {share:+.1f} %)"


def _bend(entry):
    cable, kind = entry.cable, entry.cable.CableType
    yield (
        "Smallest bend radius",
        f"{_radius(cable.SmallestBendRadius.Value)} at {_mm(cable.SmallestBendRadiusAt.Value)}",
    )
    if entry.allowed:
        inside = kind.BendRadiusConvention == "Inside"
        stated = entry.allowed - (kind.OuterDiameter.Value / 2 if inside else 0)
        where = "inside of the bend" if inside else "centreline"
        yield "Allowed", f"{_mm(entry.allowed)} ({_mm(stated)} at the {where})"
        yield "Margin", f"{_mm(cable.BendRadiusMargin.Value)}, {100 * entry.relative_margin:.1f} %"
    else:
        yield "Allowed", "not known"
    yield "Mode", cable.BendRadiusMode
    if not math.isnan(entry.spline_radius):
        yield "Of the spline route", _radius(entry.spline_radius)
    for bound in entry.band:
        told = "strands slip" if bound.name == "Slip" else "strands stick"
        yield (
            f"If the {told}",
            f"{_radius(bound.radius)}, up to {_mm(bound.shift)} beside this shape",
        )
    if math.isfinite(entry.clearance):
        to = f" to {escape(entry.nearest)}" if entry.nearest else ""
        yield "Least clearance", f"{_mm(entry.clearance)}{to}"
    else:
        yield "Least clearance", "nothing within 20 mm"
    yield "Clearance asked for", _mm(cable.Clearance.Value)


def _loads(entry):
    head = "<tr><th></th><th>Force [N]</th><th>of it x, y, z</th><th>Moment [N m]</th><th>of it x, y, z</th></tr>"
    rows = [
        f"<tr><td>{escape(load.place)}</td><td>{load.force.Length:.3g}</td><td>{_vector(load.force)}</td>"
        f"<td>{load.moment.Length:.3g}</td><td>{_vector(load.moment)}</td></tr>"
        for load in entry.loads
    ]
    cable = entry.cable
    contacts = zip(cable.ContactObstacles, cable.ContactPlaces, cable.ContactForces, strict=True)
    rows += [
        f"<tr><td>{escape(name)}, at {_mm(place)}</td><td>{force.Length:.3g}</td><td>{_vector(force)}</td><td></td>"
        "<td></td></tr>"
        for name, place, force in contacts
    ]
    return f'<div class="scroll"><table>{head}{"".join(rows)}</table></div>'


def _model(entry):
    cable, centre = entry.cable, entry.centre
    yield "Cable type", escape(cable.CableType.Label)
    yield "Mass", f"{1e3 * cable.Mass:.2f} g"
    yield "Centre of mass", f"({centre.x:.1f}, {centre.y:.1f}, {centre.z:.1f}) mm"
    yield "Stays in this shape", "yes" if cable.Stable else "<b>no</b>"
    yield "Error estimate", f"{cable.ErrorEstimate.Value:.2g} mm"
    yield "Balance of forces and moments", f"to {cable.BalanceResidual:.1g}, relative"
    yield "Time of the solve", f"{1e3 * cable.SolveTime:.0f} ms"
    yield "Model", "<br>".join(escape(line) for line in cable.ModelUsed)


def _pairs(pairs):
    rows = (
        f'<tr><td>{escape(name)}</td><td class="text">{value}</td></tr>' for name, value in pairs
    )
    return f"<table>{''.join(rows)}</table>"


def _mm(length):
    return f"{length:.1f} mm".replace("-", "−")


def _radius(radius):
    return _mm(radius) if radius < LONG_BEND else "straight"


def _vector(vector):
    return ", ".join(f"{value:.3g}".replace("-", "−") for value in vector)
