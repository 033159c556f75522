# SPDX-License-Identifier: LGPL-2.1-or-later
"""How near the cables of a document come to its solids and to each other; headless or not.

rows = interference.report(doc)
interference.sheet(doc, rows)
"""

import math
from dataclasses import dataclass
from itertools import combinations
from typing import NamedTuple

import numpy as np
from FreeCAD import Units, Vector

from ..errors import DocumentError, ProblemError
from ..problem import Free, Tube
from ..shape.centreline import centreline
from ..shape.units import from_si, to_si, vector_from_si, vectors_to_si
from .complaint import OBSTACLE
from .obstacles import Piece, Run, pieces, tube
from .read_held import read_held
from .reference import container, from_the_top, is_plain_group
from .stored_solution import nodes

TOUCHING = 0.02
"""Distance, in radii of the cable, up to which surfaces touch: twice what a solve leaves between its nodes."""

LENGTH = Units.Quantity("1 mm").Unit

EXACT = 1e-3
"""What a distance that is reported may be too large, in radii of the cable."""


class Row(NamedTuple):
    """A cable and what it comes near to. Lengths in mm, in the coordinates of the document."""

    cable: str
    other: str
    distance: float
    """least distance of the surfaces; negative: how deep they enter each other"""
    point: Vector
    """of the centreline, where that is"""
    position: float
    """of that point, from the start along the cable"""
    verdict: str
    """Interference, Contact, Too close (nearer than the clearance of the cable), Clear, or why there is none"""


@dataclass(frozen=True, eq=False)
class _Course:
    """A solved cable where it stands in the document, in SI units."""

    run: Run
    tube: Tube
    clearance: float
    curve: object
    """centreline [mm] in its container, without the scale of a link; its parameter is its length from the start"""
    held: tuple
    """lengths from the start [m] where a terminal or a support holds it"""

    @property
    def length(self):
        return to_si("length", self.curve.LastParameter) * self.run.scale

    def at(self, lengths):
        """Points (n, 3) [m] at lengths (n,) [m] from the start."""
        found = map(self.curve.value, from_si("length", lengths / self.run.scale).tolist())
        return vectors_to_si([self.run.matrix.multVec(point) for point in found])


def report(doc, solids=None, limit="10 mm") -> list[Row]:
    """The pairs of a cable and a solid, or of two cables, that are nearer than ``limit`` or than the clearance of the
    cable, the nearest first; what cannot be measured comes last and says why.

    ``solids``: parts and assemblies to look at; None: all that is visible. Where a terminal or a support holds a cable,
    and from there for as long as the cable goes away from a solid, it may be as near as it is. Surfaces of solids
    count to a twentieth of the radius of the cable. Errors: ``DocumentError`` if an argument is none.
    """
    limit = _limit(limit)
    found = [each for root in roots(doc) for each in pieces(root, "")]
    courses, rows = [], []
    for run in found:
        if isinstance(run, Run):
            try:
                courses.append(_course(run))
            except DocumentError as error:
                rows.append(_unknown(run.label, "", error))
    if solids is not None:
        for obj in solids:
            if not hasattr(obj, "getSubObjects"):
                raise DocumentError(f"Of the solids one is {obj!r}; it must be an object.")
        found = [each for obj in solids for each in pieces(*from_the_top(obj))]
    for course in courses:
        for solid in found:
            if isinstance(solid, Piece):
                rows.append(_to_solid(course, solid, max(limit, course.clearance)))
    for one, other in combinations(courses, 2):
        clearance = max(one.clearance, other.clearance)
        rows.append(_row(one, other.tube, (), clearance, max(limit, clearance)))
    return sorted(filter(None, rows), key=lambda row: (math.isnan(row.distance), row.distance))


def sheet(doc, rows, name="Interference"):
    """The rows in a spreadsheet called ``name``; the one of that name is filled anew."""
    table = doc.getObject(name)
    if table is None or table.TypeId != "Spreadsheet::Sheet":
        table = doc.addObject("Spreadsheet::Sheet", name)
    table.clearAll()
    titles = ("Cable", "Other", "Distance [mm]", "x [mm]", "y [mm]", "z [mm]", "Position [mm]")
    for column, title in zip("ABCDEFGH", (*titles, "Verdict"), strict=True):
        table.set(f"{column}1", title)
    table.setStyle("A1:H1", "bold")
    for number, row in enumerate(rows, 2):
        shown = (row.distance, *row.point, row.position)
        for column, text in zip("ABH", (row.cable, row.other, row.verdict), strict=True):
            # An apostrophe makes text of what looks like a formula.
            table.set(f"{column}{number}", f"'{text}")
        if row.other:
            for column, value in zip("CDEFG", shown, strict=True):
                table.set(f"{column}{number}", f"{value:.4g}")
    return table


def _limit(value):
    """[m]"""
    try:
        limit = Units.Quantity(value) if isinstance(value, str) else Units.Quantity(value, LENGTH)
    except (ArithmeticError, TypeError, ValueError):
        limit = None
    if limit is None or limit.Unit != LENGTH or not math.isfinite(limit.Value):
        raise DocumentError(f"The limit is {value!r}; it must be a length, as '10 mm'.")
    return to_si("length", limit)


def roots(doc):
    """What stands at the top of the document and can be seen."""
    for obj in doc.Objects:
        if obj.Visibility and container(obj) is None and not is_plain_group(obj):
            yield obj


def _course(run) -> _Course:
    cable = run.cable
    if cable.OutOfDate:
        raise DocumentError(cable.Status)
    made, scene = tube(run), read_held(cable)
    ends = zip((scene.start, scene.end), (0, -1), strict=True)
    held = [at for end, at in ends if not isinstance(end, Free)] + list(cable.NodeOfSupport)
    lengths = tuple(cable.NodeArcLength[node] * run.scale for node in held)
    return _Course(run, made, scene.clearance, centreline(nodes(cable)), lengths)


def _to_solid(course, solid, limit):
    if _apart(course.tube.bounds, solid.bounds) > limit:
        return None
    place = OBSTACLE + solid.label
    try:
        mesh = solid.placed.mesh(course.tube.radius, place)
    except ProblemError as error:
        return _unknown(course.run.label, solid.label, error.message)
    return _row(course, mesh, course.held, course.clearance, limit)


def _unknown(cable, other, reason):
    return Row(cable, other, math.nan, Vector(), 0.0, str(reason))


def _row(course, other, held, clearance, limit):
    """The row of a cable and an obstacle, or None if they are farther apart than ``limit``. All in m."""
    if _apart(course.tube.bounds, other.bounds) > limit:
        return None
    found = _nearest(course, other, held)
    if found is None or found[0] > limit:
        return None
    distance, place = found
    touching = TOUCHING * course.tube.radius
    if distance < -touching:
        verdict = "Interference"
    elif distance <= touching:
        verdict = "Contact"
    else:
        verdict = "Too close" if distance < clearance - touching else "Clear"
    return Row(
        course.run.label,
        other.place.removeprefix(OBSTACLE),
        from_si("length", distance),
        vector_from_si(course.at(np.array([place]))[0]),
        from_si("length", place),
        verdict,
    )


def _nearest(course, other, held):
    """(distance, length from the start) [m] where the surfaces are nearest, or None if that is where it is held.

    A distance changes by no more than the way along the centreline: what cannot be the least is left out, and the rest
    divided in three, until the spacing does not matter.
    """
    radius, length = course.tube.radius, course.length

    def distance(s):
        return other.nearest(course.at(s)).distance - radius

    s = np.linspace(0, length, 2 + math.ceil(length / radius))
    spacing, found = s[1], distance(s)
    counts = np.ones(len(s), bool)
    for place in held:
        counts[_leaving(found, int(np.argmin(np.abs(s - place))), EXACT * radius)] = False
    if not counts.any():
        return None
    s, found = s[counts], found[counts]
    while spacing > EXACT * radius:
        near = found - spacing / 2 < found.min()
        spacing /= 3
        s = np.clip((s[near, None] + spacing * np.array([-1, 0, 1])).ravel(), 0, length)
        found = distance(s)
    return float(found.min()), float(s[np.argmin(found)])


def _leaving(distances, start, noise):
    """The slice about the sample ``start`` over which distances grow in going away from it."""
    first = last = start
    while first > 0 and distances[first - 1] > distances[first] + noise:
        first -= 1
    while last + 1 < len(distances) and distances[last + 1] > distances[last] + noise:
        last += 1
    return slice(first, last + 1)


def _apart(a, b):
    """Distance of two boxes (2, 3)."""
    return float(np.linalg.norm(np.maximum(np.maximum(a[0] - b[1], b[0] - a[1]), 0)))
