# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of one cable on the page, and that of the cable types."""

import math
from html import escape

import FreeCAD

from ..sentences import in_language

translate = FreeCAD.Qt.translate

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
            (translate("CableReport", "Length"), _pairs(_length(entry))),
            (translate("CableReport", "Bend and clearance"), _pairs(_bend(entry))),
            (translate("CableReport", "Forces and moments on the cable"), _loads(entry)),
            (translate("CableReport", "Mass, and how it was solved"), _pairs(_model(entry))),
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
        section = escape(in_language(kind.Status))
        rows.append(
            f'<tr><td>{escape(kind.Label)}</td><td class="text">{section}</td><td class="text">{lines}</td></tr>'
        )
    title = translate("CableReport", "Cable types")
    heads = (
        f"<th>{translate('CableReport', 'Type')}</th>",
        f'<th class="text">{translate("CableReport", "Section")}</th>',
        f'<th class="text">{translate("CableReport", "Where its numbers are from")}</th>',
    )
    head = f"<tr>{''.join(heads)}</tr>"
    return f"<section><h2>{title}</h2><table>{head}{''.join(rows)}</table></section>"


def tolerance(length):
    """[mm] by which a cable of this cut length may be longer."""
    return next((more for up_to, more in TOLERANCES if length <= up_to), BEYOND * length)


def _length(entry):
    cable = entry.cable
    solved, cut = cable.SolvedLength.Value, cable.CutLength.Value
    if not math.isnan(entry.straight):
        yield translate("CableReport", "Straight way over the supports"), _mm(entry.straight)
        yield (
            translate("CableReport", "Slack"),
            f"{_mm(solved - entry.straight)}, {100 * (solved / entry.straight - 1):.1f} %",
        )
    if len(entry.stretches) > 1:
        for place, stretch in entry.stretches:
            yield translate("CableReport", "… to {place}").format(place=place), _mm(stretch)
    yield translate("CableReport", "Length between the terminals"), _mm(solved)
    if cable.LengthMode == "Shortest":
        yield (
            translate("CableReport", "Shortest and longest that will do"),
            f"{_mm(cable.ShortestLength.Value)}, {_mm(cable.LongestLength.Value)}",
        )
    allowances = cable.StartAllowance.Value, cable.EndAllowance.Value
    yield (
        translate("CableReport", "Allowance at start and end"),
        f"{_mm(allowances[0])}, {_mm(allowances[1])}",
    )
    yield translate("CableReport", "Rounded up by"), _mm(cut - solved - sum(allowances))
    yield translate("CableReport", "Cut length"), f"<b>{_mm(cut)}</b> +{tolerance(cut):.0f}/−0"
    if not math.isnan(entry.spline_length):
        difference = entry.spline_length - solved
        share = 100 * difference / solved
        yield (
            translate("CableReport", "Spline route"),
            f"{_mm(entry.spline_length)} ({difference:+.1f} mm, {share:+.1f} %)",
        )


def _bend(entry):
    cable, kind = entry.cable, entry.cable.CableType
    modes = {
        "Check": translate("CableReport", "checked"),
        "Enforce": translate("CableReport", "enforced"),
    }
    strands = {
        "Slip": translate("CableReport", "If the strands slip"),
        "Stick": translate("CableReport", "If the strands stick"),
    }
    yield (
        translate("CableReport", "Smallest bend radius"),
        translate("CableReport", "{radius} at {place}").format(
            radius=_radius(cable.SmallestBendRadius.Value),
            place=_mm(cable.SmallestBendRadiusAt.Value),
        ),
    )
    if entry.allowed:
        inside = kind.BendRadiusConvention == "Inside"
        stated = entry.allowed - (kind.OuterDiameter.Value / 2 if inside else 0)
        where = (
            translate("CableReport", "{radius} at the inside of the bend")
            if inside
            else translate("CableReport", "{radius} at the centreline")
        )
        yield (
            translate("CableReport", "Allowed"),
            f"{_mm(entry.allowed)} ({where.format(radius=_mm(stated))})",
        )
        yield (
            translate("CableReport", "Margin"),
            f"{_mm(cable.BendRadiusMargin.Value)}, {100 * entry.relative_margin:.1f} %",
        )
    else:
        yield translate("CableReport", "Allowed"), translate("CableReport", "not known")
    yield translate("CableReport", "Mode"), modes[cable.BendRadiusMode]
    if not math.isnan(entry.spline_radius):
        yield translate("CableReport", "Of the spline route"), _radius(entry.spline_radius)
    for bound in entry.band:
        shape = translate("CableReport", "{radius}, up to {distance} beside this shape")
        yield (
            strands[bound.name],
            shape.format(radius=_radius(bound.radius), distance=_mm(bound.shift)),
        )
    if math.isfinite(entry.clearance):
        nearest = (
            translate("CableReport", "{distance} to {nearest}") if entry.nearest else "{distance}"
        )
        yield (
            translate("CableReport", "Least clearance"),
            nearest.format(distance=_mm(entry.clearance), nearest=escape(entry.nearest)),
        )
    else:
        yield (
            translate("CableReport", "Least clearance"),
            translate("CableReport", "nothing within 20 mm"),
        )
    yield translate("CableReport", "Clearance asked for"), _mm(cable.Clearance.Value)


def _loads(entry):
    parts = translate("CableReport", "of it x, y, z")
    heads = (
        "",
        translate("CableReport", "Force [N]"),
        parts,
        translate("CableReport", "Moment [N m]"),
        parts,
    )
    head = f"<tr>{''.join(f'<th>{each}</th>' for each in heads)}</tr>"
    touching = translate("CableReport", "{obstacle}, at {place}")
    rows = [
        f"<tr><td>{escape(load.place)}</td><td>{load.force.Length:.3g}</td><td>{_vector(load.force)}</td>"
        f"<td>{load.moment.Length:.3g}</td><td>{_vector(load.moment)}</td></tr>"
        for load in entry.loads
    ]
    cable = entry.cable
    contacts = zip(cable.ContactObstacles, cable.ContactPlaces, cable.ContactForces, strict=True)
    for name, place, force in contacts:
        where = touching.format(obstacle=escape(in_language(name)), place=_mm(place))
        rows.append(
            f"<tr><td>{where}</td><td>{force.Length:.3g}</td><td>{_vector(force)}</td><td></td><td></td></tr>"
        )
    return f'<div class="scroll"><table>{head}{"".join(rows)}</table></div>'


def _model(entry):
    cable, centre = entry.cable, entry.centre
    yes, no = translate("CableReport", "yes"), translate("CableReport", "no")
    stays = yes if cable.Stable else f"<b>{no}</b>"
    balance = translate("CableReport", "to {residual}, relative")
    balance = balance.format(residual=f"{cable.BalanceResidual:.1g}")
    model = [escape(in_language(line)) for line in cable.ModelUsed]
    yield translate("CableReport", "Cable type"), escape(cable.CableType.Label)
    yield translate("CableReport", "Mass"), f"{1e3 * cable.Mass:.2f} g"
    yield (
        translate("CableReport", "Centre of mass"),
        f"({centre.x:.1f}, {centre.y:.1f}, {centre.z:.1f}) mm",
    )
    yield translate("CableReport", "Stays in this shape"), stays
    yield translate("CableReport", "Error estimate"), f"{cable.ErrorEstimate.Value:.2g} mm"
    yield translate("CableReport", "Balance of forces and moments"), balance
    yield translate("CableReport", "Time of the solve"), f"{1e3 * cable.SolveTime:.0f} ms"
    yield translate("CableReport", "Model"), "<br>".join(model)


def _pairs(pairs):
    rows = (
        f'<tr><td>{escape(name)}</td><td class="text">{value}</td></tr>' for name, value in pairs
    )
    return f"<table>{''.join(rows)}</table>"


def _mm(length):
    return f"{length:.1f} mm".replace("-", "−")


def _radius(radius):
    return _mm(radius) if radius < LONG_BEND else translate("CableReport", "straight")


def _vector(vector):
    return ", ".join(f"{value:.3g}".replace("-", "−") for value in vector)
