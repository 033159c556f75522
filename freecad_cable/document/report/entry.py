# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the report says of each cable, read from the document, in FreeCAD's mm and in its coordinates."""

import math
from dataclasses import dataclass, field
from enum import Enum

import FreeCAD
import numpy as np
from FreeCAD import Placement, Vector

from ...errors import CableError
from ...geometry.curves import Curve
from ...problem import Free
from ...problem.reach import chord_through
from ...routes import METHODS
from ...shape.centreline import centreline
from ...shape.units import from_si, vectors_from_si
from .. import interference
from ..cable import Cable
from ..doubts import doubts, unknowns
from ..proxy import proxy_of
from ..read_held import read_held
from ..reference import container
from ..route import routed_scene
from ..sentences import in_language
from ..stiffness_band import band
from ..stored_solution import nodes

translate = FreeCAD.Qt.translate

SAMPLES = 200
"""Points on a line of the report."""

NEAR = "20 mm"
"""How far around it looks for what a cable comes near to."""

HELD = 1e-3
"""What an enforced bend radius may lack, relative: the mesh leaves that between its nodes."""


class Verdict(Enum):
    """What a reader has to do with a cable; the worst first."""

    NOT_SOLVED = "Not solved"
    FAILS = "Fails"
    UNKNOWN = "To be checked"
    HOLDS = "Holds"

    @property
    def text(self):
        """What a reader reads."""
        return {
            Verdict.NOT_SOLVED: translate("CableReport", "Not solved"),
            Verdict.FAILS: translate("CableReport", "Fails"),
            Verdict.UNKNOWN: translate("CableReport", "To be checked"),
            Verdict.HOLDS: translate("CableReport", "Holds"),
        }[self]


@dataclass(frozen=True)
class Load:
    """What a terminal or a support exerts on the cable."""

    place: str
    force: Vector
    """[N]"""
    moment: Vector
    """[N m]"""


@dataclass(frozen=True, eq=False)
class Line:
    """A sampled curve: points [mm], distance from the start along it [mm], curvature [1/mm]."""

    points: list
    arc_length: list
    curvature: list


@dataclass(eq=False)
class Entry:
    """A cable in the report. What a cable without an answer lacks keeps its default."""

    cable: object
    label: str
    sentence: str
    """its status"""
    failures: list = field(default_factory=list)
    """why it fails, as sentences"""
    doubts: list = field(default_factory=list)
    """what has to be checked, as sentences"""
    verdict: Verdict = Verdict.NOT_SOLVED
    allowed: float = 0.0
    """smallest bend radius of the centreline that the type allows; 0: no limit is known"""
    relative_margin: float = math.nan
    """of the bend radius, relative to what is allowed"""
    clearance: float = math.inf
    nearest: str = ""
    """what it comes nearest to, if anything is near"""
    straight: float = math.nan
    """straight way from terminal to terminal over the supports"""
    stretches: list = field(default_factory=list)
    """pairs of the place where a stretch ends and its length"""
    loads: list = field(default_factory=list)
    centre: Vector = field(default_factory=Vector)
    """of mass"""
    line: Line | None = None
    spline: Line | None = None
    spline_length: float = math.nan
    spline_radius: float = math.nan
    band: list = field(default_factory=list)
    """``Bound`` of the stiffness where the type states them"""
    supports: list = field(default_factory=list)
    """pairs of a label and a place, of what holds it"""

    @property
    def risk(self):
        """Sorts the worst first; where nothing fails, the smallest margin."""
        margin = self.relative_margin
        order = list(Verdict).index(self.verdict)
        return order, -math.inf if math.isnan(margin) else margin, self.label


def collect(doc) -> list[Entry]:
    """Of every cable of the document, the worst first."""
    cables = [obj for obj in doc.Objects if proxy_of(obj, Cable)]
    near = interference.report(doc, limit=NEAR) if cables else []
    return sorted((_entry(cable, near) for cable in cables), key=lambda entry: entry.risk)


def _entry(cable, near):
    out_of_date = translate("CableReport", "It is out of date; recompute the document.")
    if not cable.isValid() or not cable.SolvedInputs or cable.OutOfDate:
        return Entry(cable, cable.Label, in_language(cable.Status) or out_of_date)
    if "Touched" in cable.State:
        return Entry(cable, cable.Label, out_of_date)
    where = _placement(cable)
    entry = Entry(cable, cable.Label, in_language(cable.Status), supports=_places(cable, where))
    if cable.BendRadiusMargin.Value != cable.SmallestBendRadius.Value:
        entry.allowed = cable.SmallestBendRadius.Value - cable.BendRadiusMargin.Value
        entry.relative_margin = cable.BendRadiusMargin.Value / entry.allowed
    entry.straight, entry.stretches = _lengths(cable)
    entry.loads = _loads(cable, where)
    entry.centre = where.multVec(cable.CentreOfMass)
    entry.line = _line(cable, where)
    _add_spline(entry, where)
    _add_band(entry)
    _judge(entry)
    _add_clearance(entry, [row for row in near if cable.Label in (row.cable, row.other)])
    if entry.failures:
        entry.verdict = Verdict.FAILS
    else:
        entry.verdict = Verdict.UNKNOWN if entry.doubts else Verdict.HOLDS
    return entry


def _add_band(entry):
    try:
        entry.band = band(entry.cable)
    except CableError as error:
        said = translate(
            "CableReport", "Its shape at the bounds of its stiffness is not known: {error}"
        )
        entry.doubts.append(said.format(error=in_language(str(error))))
    for bound in entry.band:
        if entry.allowed > bound.radius and entry.relative_margin >= 0:
            said = translate(
                "CableReport", "It holds, but with {stiffness} it bends to {radius} mm."
            )
            stiffness = f"{bound.name}BendingStiffness"
            entry.doubts.append(said.format(stiffness=stiffness, radius=f"{bound.radius:.4g}"))


def _judge(entry):
    """What speaks against the cable alone."""
    cable, kind = entry.cable, entry.cable.CableType
    least = -HELD if cable.BendRadiusMode == "Enforce" else 0.0
    if entry.relative_margin < least:
        said = translate("CableReport", "It bends to {radius} mm; {allowed} mm is allowed.")
        radius, allowed = f"{cable.SmallestBendRadius.Value:.4g}", f"{entry.allowed:.4g}"
        entry.failures.append(said.format(radius=radius, allowed=allowed))
    if not cable.Stable:
        entry.failures.append(translate("CableReport", "It does not stay in this shape."))
    if not entry.allowed:
        said = translate("CableReport", "{type} has no smallest bend radius to compare with.")
        entry.doubts.append(said.format(type=kind.Label))
    warnings = [said.replace("Warning: ", "") for said in (*doubts(kind), *unknowns(kind))]
    entry.doubts += map(in_language, (*cable.FormedPlaces, *warnings))


def _add_clearance(entry, rows):
    """The least distance to anything, and what speaks against the cable there."""
    if math.isfinite(entry.cable.SmallestClearance.Value):
        entry.clearance = entry.cable.SmallestClearance.Value
    for row in rows:
        other = row.other if row.cable == entry.label else row.cable
        if math.isnan(row.distance):
            said = translate("CableReport", "Its distance to {other} is not known: {reason}")
            entry.doubts.append(said.format(other=other, reason=in_language(row.verdict)))
            continue
        if row.distance < entry.clearance or not entry.nearest:
            entry.clearance, entry.nearest = min(row.distance, entry.clearance), other
        if row.verdict == "Interference":
            said = translate("CableReport", "It enters {other} by {depth} mm.")
            entry.failures.append(said.format(other=other, depth=f"{-row.distance:.3g}"))
        elif row.verdict == "Too close" and row.distance < entry.cable.Clearance.Value:
            said = translate(
                "CableReport", "It is {distance} mm from {other}; its clearance is {clearance} mm."
            )
            distance, clearance = f"{row.distance:.3g}", f"{entry.cable.Clearance.Value:.3g}"
            entry.failures.append(said.format(distance=distance, other=other, clearance=clearance))


def _lengths(cable):
    """The straight way, and where each stretch ends and how long it is."""
    scene = read_held(cable)
    held = (scene.start, *scene.supports, scene.end)
    free = any(isinstance(each, Free) for each in held)
    straight = math.nan if free else from_si("length", chord_through([h.position for h in held]))
    ends = [from_si("length", cable.NodeArcLength[node]) for node in cable.NodeOfSupport]
    ends.append(cable.SolvedLength.Value)
    places = [*(each.Label for each in cable.Supports), cable.End.Label]
    lengths = np.diff([0.0, *ends]).tolist()
    return straight, list(zip(places, lengths, strict=True))


def _loads(cable, where):
    turn = where.Rotation.multVec
    named = [(cable.Start.Label, cable.StartForce, cable.StartMoment)]
    supports = zip(cable.Supports, cable.SupportForces, cable.SupportMoments, strict=True)
    named += [(each.Label, force, moment) for each, force, moment in supports]
    named.append((cable.End.Label, cable.EndForce, cable.EndMoment))
    return [Load(label, turn(force), turn(moment)) for label, force, moment in named]


def _places(cable, where):
    held = [cable.Start, *cable.Supports, cable.End]
    return [(each.Label, where.multVec(each.Frame.Base)) for each in held]


def _line(cable, where):
    curve = centreline(nodes(cable))
    places = np.linspace(curve.FirstParameter, curve.LastParameter, SAMPLES).tolist()
    points = [where.multVec(curve.value(place)) for place in places]
    return Line(points, places, [curve.curvature(place) for place in places])


def _add_spline(entry, where):
    """A spline that cannot be drawn is left out."""
    try:
        route = METHODS["Spline"](routed_scene(entry.cable, "Spline"))
    except CableError:
        return
    curve = Curve(route.arc_length, route.position, route.tangent)
    every = max(1, len(route.arc_length) // SAMPLES)
    points = [where.multVec(point) for point in vectors_from_si(route.position[::every])]
    entry.spline = Line(
        points,
        from_si("length", route.arc_length[::every]).tolist(),
        from_si("curvature", curve.curvature[::every]).tolist(),
    )
    entry.spline_length = from_si("length", route.length)
    entry.spline_radius = from_si("length", route.smallest_bend_radius)


def _placement(obj):
    """From the coordinates of the container of ``obj`` to those of the document."""
    placement, above = Placement(), container(obj)
    while above is not None:
        placement, above = above.Placement * placement, container(above)
    return placement
