# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cross-sections as closed rational B-splines in their own plane: x along d1, y along d2 [mm]."""

from dataclasses import dataclass

import numpy as np
import Part
from FreeCAD import Placement, Vector

from ..errors import DocumentError

SMALLEST = 1e-3
"""[mm] Smallest radius of a section: OCCT takes points within 10⁻⁷ mm as one."""

# A full circle of radius 1 as one rational quintic (Piegl and Tiller, The NURBS Book, 7.5), with a knot in the
# middle without which OCCT's volumes are off by 10⁻⁵. The usual circle of nine quadratic poles has
# double knots, which the checks of boolean operations refuse as "C0".
CIRCLE = np.array([(0, -3), (2, -3), (9, 3), (0, 9), (-9, 3), (-2, -3), (0, -3)]) / 3
CIRCLE_WEIGHTS = np.array([5, 3, 1, 1, 1, 3, 5]) / 5
CIRCLE_KNOTS, CIRCLE_MULTIPLICITIES = [0.0, 0.5, 1.0], [6, 1, 6]


@dataclass(frozen=True, eq=False)
class Outline:
    """A closed curve, the material on its left; one periodic rational B-spline with corners at full knots."""

    degree: int
    knots: list
    multiplicities: list
    poles: np.ndarray
    """(m, 2) [mm]; the first is not repeated at the end"""
    weights: np.ndarray
    """(m,)"""


@dataclass(frozen=True, eq=False)
class Profile:
    """A cross-section. The centreline is at the origin of its plane."""

    outlines: list
    """outer, then holes"""
    border: np.ndarray
    """(k, 2) points on the outer outline [mm], or of a polygon about it"""
    polygon: np.ndarray
    """(k, 2) points of the outer outline, in order [mm]"""
    inner_radius: float
    """of the largest disc about the centreline within the outer outline [mm]; 0 if it is outside"""


def circle(radius) -> Profile:
    """A round section of ``radius`` [mm]."""
    angle = np.linspace(0, 2 * np.pi, 64, endpoint=False)
    points = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    return Profile(
        outlines=[
            _joined([(5, CIRCLE_KNOTS, CIRCLE_MULTIPLICITIES, radius * CIRCLE, CIRCLE_WEIGHTS)])
        ],
        border=radius / np.cos(np.pi / 64) * points,
        polygon=radius * points,
        inner_radius=radius,
    )


def profile(shape) -> Profile:
    """The section drawn by ``shape``: a closed planar edge, wire, face or sketch, holes allowed.

    Its placement is taken away: what counts are its coordinates in its own plane. Errors:
    ``DocumentError`` if it is empty, open, not in the plane z = 0, crosses itself, or has several parts.
    """
    if shape.isNull() or not shape.Edges:
        raise DocumentError("The profile is empty; it must be a closed planar outline.")
    shape = shape.copy()
    shape.Placement = Placement()
    face = _face(shape)
    outer = face.OuterWire
    holes = [wire for wire in face.Wires if not wire.isSame(outer)]
    origin = Vector(0, 0, 0)
    inside = Part.Face(outer).isInside(origin, 1e-7, True)
    polygon = outer.discretize(Number=100)
    return Profile(
        outlines=[_outline(outer, True)] + [_outline(wire, False) for wire in holes],
        border=np.array([*polygon, *(v.Point for v in outer.Vertexes)])[:, :2],
        polygon=np.array(polygon)[:, :2],
        inner_radius=Part.Vertex(origin).distToShape(outer)[0] if inside else 0.0,
    )


CROSSED = "The profile crosses or touches itself, so it bounds no section."


def _touch(wires):
    return any(
        one.distToShape(other)[0] < 1e-6 for i, one in enumerate(wires) for other in wires[:i]
    )


def _face(shape):
    """The one face of the profile."""
    box = shape.BoundBox
    if max(abs(box.ZMin), abs(box.ZMax)) > 1e-6 * (1 + box.DiagonalLength):
        raise DocumentError(
            "The profile does not lie in its own xy-plane: z runs from "
            f"{box.ZMin:.4g} mm to {box.ZMax:.4g} mm and must be 0."
        )
    if box.DiagonalLength < 2 * SMALLEST:
        raise DocumentError(
            f"The profile is {box.DiagonalLength:.3g} mm across; it must be at least "
            f"{2 * SMALLEST:g} mm."
        )
    if len(shape.Faces) > 1:
        raise DocumentError(f"The profile has {len(shape.Faces)} faces; it must have one.")
    if shape.Faces:
        face = shape.Faces[0]
    else:
        wires = [Part.Wire(edges) for edges in Part.sortEdges(shape.Edges)]
        if not all(wire.isClosed() for wire in wires):
            raise DocumentError("The profile is not closed; its edges must form closed outlines.")
        faces = Part.makeFace(Part.makeCompound(wires), "Part::FaceMakerBullseye").Faces
        if len(faces) > len(wires) or _touch(wires):
            raise DocumentError(CROSSED)
        if len(faces) != 1:
            raise DocumentError(
                f"The profile has {len(faces)} separate parts; it must have one (holes are allowed)."
            )
        face = faces[0]
    if not (face.isValid() and face.Area > 0):
        raise DocumentError(CROSSED)
    return face


def _outline(wire, anticlockwise) -> Outline:
    """The wire as one B-spline, running anticlockwise or clockwise."""
    pieces = [piece for edge in wire.OrderedEdges for piece in _pieces(edge)]
    x, y = np.concatenate([_along(piece) for piece in pieces]).T
    area = np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)) / 2
    if (area > 0) != anticlockwise:
        pieces.reverse()
        for piece in pieces:
            piece.reverse()
    degree = max(piece.Degree for piece in pieces)
    for piece in pieces:
        piece.increaseDegree(degree)
    return _joined(
        [
            (
                degree,
                piece.getKnots(),
                piece.getMultiplicities(),
                np.array(piece.getPoles())[:, :2],
                np.array(piece.getWeights()),
            )
            for piece in pieces
        ]
    )


def _pieces(edge) -> list[Part.BSplineCurve]:
    """An edge as clamped B-splines, end to start in the direction of its wire, alike in weight at both ends."""
    if edge.isClosed() and isinstance(edge.Curve, (Part.Circle, Part.Ellipse)):
        piece = _full(edge.Curve)
    else:
        # Of an arc, Curve.toBSpline is an approximation and Curve.toNurbs another arc.
        exact = edge.toNurbs().Edges[0]
        piece = exact.Curve
        piece.segment(*exact.ParameterRange)
    if edge.Orientation == "Reversed":
        piece.reverse()
    weights = piece.getWeights()
    if np.isclose(weights[0], weights[-1], rtol=1e-12):
        return [piece]
    return [_balanced(bezier) for bezier in piece.toBezier()]


def _full(curve) -> Part.BSplineCurve:
    """A full circle or ellipse, as an affine image of ``CIRCLE``."""
    centre = Vector(*curve.Center)
    right, up = curve.value(0) - centre, curve.value(np.pi / 2) - centre
    piece = Part.BSplineCurve()
    piece.buildFromPolesMultsKnots(
        [centre + right * x + up * y for x, y in CIRCLE.tolist()],
        CIRCLE_MULTIPLICITIES,
        CIRCLE_KNOTS,
        False,
        5,
        CIRCLE_WEIGHTS.tolist(),
    )
    return piece


def _balanced(bezier) -> Part.BSplineCurve:
    """The same curve with the first weight equal to the last, by a Möbius change of its parameter.

    It multiplies the weights by a geometric sequence (Farin, Curves and Surfaces for CAGD, 13.1).
    """
    degree, weights = bezier.Degree, np.array(bezier.getWeights())
    weights *= (weights[0] / weights[-1]) ** (np.arange(degree + 1) / degree)
    piece = Part.BSplineCurve()
    piece.buildFromPolesMultsKnots(
        bezier.getPoles(), [degree + 1] * 2, [0.0, 1.0], False, degree, weights.tolist()
    )
    return piece


def _along(piece):
    """(20, 2) points of a piece, without its last."""
    share = np.linspace(piece.FirstParameter, piece.LastParameter, 21)[:-1]
    return np.array([piece.value(u) for u in share.tolist()])[:, :2]


def _joined(pieces) -> Outline:
    """Clamped pieces (degree, knots, multiplicities, poles, weights), end to start, as one periodic curve.

    The weights of a piece count up to a factor; with the first equal to the last they meet all around.
    """
    degree = pieces[0][0]
    knots, multiplicities, all_poles, all_weights = [0.0], [], [], []
    for _, own_knots, own_multiplicities, poles, weights in pieces:
        start, span = knots[-1], own_knots[-1] - own_knots[0]
        knots += [start + (u - own_knots[0]) / span for u in own_knots[1:]]
        multiplicities += [degree, *own_multiplicities[1:-1]]
        all_poles.append(poles[:-1])
        all_weights.append(weights[:-1] / weights[0])
    return Outline(
        degree,
        knots,
        [*multiplicities, degree],
        np.concatenate(all_poles),
        np.concatenate(all_weights),
    )
