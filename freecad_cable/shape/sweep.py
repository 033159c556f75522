# SPDX-License-Identifier: LGPL-2.1-or-later
"""The solid of a cable, skinned from the solved frames.

A section point (x, y) follows r + x d1 + y d2. With r, d1, d2 as quintic splines over the nodes and the
outline of the section as a rational spline, all of them together are one B-spline surface; no
sections are placed and none interpolated.
"""

import numpy as np
import Part
from FreeCAD import Vector

from ..errors import DocumentError
from ..geometry import rotation
from .centreline import ACCURACY
from .frames import frames
from .overlap import refuse_overlap
from .profile import SMALLEST, circle, profile
from .spline import DEGREE, Quintic, joined
from .units import from_si

FRAME_ACCURACY = 1e-5
"""Largest error of an axis of the frame at a node; the surface is off by this share of the section."""

LONGEST_FACE = 60.0
"""Length of a face over its shortest span. OCCT takes volumes from 61 points along a face, however
many spans it has, and so misses short bends of a long cable."""

VOLUME_ACCURACY = 1e-2
"""Largest relative difference of the volume from area times length (Pappus)."""

_SHARE, _WEIGHT = np.polynomial.legendre.leggauss(6)
SHARE = np.concatenate(([0], (_SHARE + 1) / 2, [1]))
WEIGHT = np.concatenate(([0], _WEIGHT / 2, [0]))
"""Where in a span the surface is looked at, its ends among them, and the weights of Gauss."""


def sweep_round(nodes, radius) -> Part.Solid:
    """The solid of a round cable of ``radius`` [m] along ``nodes`` (``Nodes`` or ``Solution``), in mm.

    Its frames carry no twist: on a round cable that does not show, and costs poles. Errors:
    ``DocumentError`` if there is no such solid (a bend tighter than the cable, a cable through itself, nodes
    too coarse); the caller shows the centreline instead.
    """
    radius = from_si("length", float(radius))
    if not SMALLEST <= radius < np.inf:
        raise DocumentError(f"The radius is {radius:g} mm; it must be at least {SMALLEST:g} mm.")
    return _sweep([run.untwisted() for run in frames(nodes)], circle(radius))


def sweep_profile(nodes, shape) -> Part.Solid:
    """The solid with the section drawn by ``shape`` (see ``profile``), x along d1 and y along d2, in mm.

    It turns with the material frame. Errors: ``DocumentError`` as ``sweep_round``, or if ``shape`` draws
    no section.
    """
    return _sweep(frames(nodes), profile(shape))


def _sweep(runs, section):
    length = runs[-1].parameter[-1]
    pieces = [x for run in runs for x in _frame_spline(run, length).cut(LONGEST_FACE)]
    _refuse_distortion(pieces, section)
    refuse_overlap(pieces, section.inner_radius)
    try:
        sides = [_sides(pieces, outline) for outline in section.outlines]
        faces = [face for shell in sides for face in shell.Faces]
        solid = _solid(Part.Shell(faces + _caps(pieces, sides)))
        sound = solid.isValid() and solid.isClosed()
    except Part.OCCError as error:
        raise DocumentError(f"The solid of the cable could not be built: {error}") from error
    if not sound:
        raise DocumentError("The solid of the cable is not valid and closed.")
    return solid


def _solid(shell):
    """The inside of a shell that looks outwards. ``Part.Solid`` would find out whether it does from where lines
    pierce it, which takes as long as all else; here it does, because no part of the surface is folded."""
    box = Part.makeBox(1, 1, 1)
    return box.replaceShape([(box.Shells[0], shell)])


def _frame_spline(run, length) -> Quintic:
    """(r, d1, d2), 9 numbers, over a run of a cable of ``length``."""
    _, bend, _ = run.axis(2)
    d1, d1_first, d1_second = run.axis(0)
    d2, d2_first, d2_second = run.axis(1)
    spline = Quintic(
        run.parameter,
        np.hstack([run.position, d1, d2]),
        np.hstack([run.tangent, d1_first, d2_first]),
        np.hstack([bend, d1_second, d2_second]),
    )
    return spline.thinned(np.repeat([ACCURACY * length, FRAME_ACCURACY], [3, 6]))


def _refuse_distortion(pieces, section):
    """``DocumentError`` if the surface folds, or if its volume is not area times length.

    The volume element at (x, y) is det(d1, d2, r' + x d1' + y d2') dx dy ds. To ask OCCT for the volume of
    the solid would take longer than to build it.
    """
    volume = 0.0
    for piece in pieces:
        value, first = piece.at(SHARE)
        normal = rotation.cross(value[..., 3:6], value[..., 6:9])
        element = np.stack([np.sum(normal * first[..., k : k + 3], axis=-1) for k in (0, 3, 6)], -1)
        inside = (element[..., :1] + element[..., 1:] @ section.border.T).min(axis=-1)
        span, point = np.unravel_index(np.argmin(inside), inside.shape)
        if not inside[span, point] > 0:
            along, *across = element[span, point]
            place = piece.parameter[span] + SHARE[point] * piece.step[span]
            raise DocumentError(
                f"The cable bends to a radius of {along / np.hypot(*across):.4g} mm at {place:.4g} mm "
                "from its start, and its section reaches farther than that to the inside of the "
                "bend: its surface would fold."
            )
        volume += float(np.sum(element[..., 0] @ WEIGHT * piece.step))
    expected = pieces[-1].parameter[-1]
    if not abs(volume / expected - 1) < VOLUME_ACCURACY:
        raise DocumentError(
            f"The cable's shape would have {volume / expected:.4g} times the volume of its length. "
            "Solve with more elements."
        )


def _sides(pieces, outline):
    """The side faces over one outline: a shell with shared edges.

    There is one face between two corners of the outline and the two ends of a piece, because that is
    where ``Segment`` cuts the surface.
    """
    knots, multiplicities, poles = joined(pieces, continuity=0)
    r, d1, d2 = poles[:, :3], poles[:, 3:6], poles[:, 6:]
    x, y = outline.poles.T[:, :, None, None]
    surface = Part.BSplineSurface()
    surface.buildFromPolesMultsKnots(
        [[Vector(*pole) for pole in row] for row in (r + x * d1 + y * d2).tolist()],
        outline.multiplicities,
        multiplicities,
        outline.knots,
        knots,
        True,
        False,
        outline.degree,
        DEGREE,
        [[weight] * len(poles) for weight in outline.weights.tolist()],
    )
    return surface.toShell(Segment=True)


def _caps(pieces, sides):
    """The two end faces, looking outwards."""
    caps = []
    for piece, end, sense in ((pieces[0], 0, -1), (pieces[-1], -1, 1)):
        wires = [Part.Wire(_ring(shell, piece.parameter[end])) for shell in sides]
        cap = Part.Face(wires if len(wires) > 1 else wires[0])
        if cap.normalAt(0, 0) * Vector(*piece.first[end, :3]) * sense < 0:
            cap.reverse()
        caps.append(cap)
    return caps


def _ring(shell, parameter):
    """The edges of the side faces that run across the cable at ``parameter``."""
    ring = []
    for face in shell.Faces:
        for edge in face.Edges:
            curve, first, last = face.curveOnSurface(edge)
            if curve.value(first).y == curve.value(last).y == parameter:
                ring.append(edge)
    return ring
