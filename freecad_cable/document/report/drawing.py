# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of cables among the parts, as SVG: seen along an axis, to scale, the parts as glass."""

import math
from html import escape

import FreeCAD
import numpy as np
from FreeCAD import Vector

from ..interference import roots
from ..obstacles import Piece, pieces

translate = FreeCAD.Qt.translate

HALF = 0.5**0.5

VIEWS = {
    "above": ((1, 0, 0), (0, 1, 0)),
    "front": ((1, 0, 0), (0, 0, 1)),
    "right": ((0, 1, 0), (0, 0, 1)),
    "corner": ((HALF, HALF, 0), (-0.5 * HALF, 0.5 * HALF, 0.75**0.5)),
}
"""Name of a view: what points to the right and up in it."""

COLOURS = ("#1f6fb4", "#d9541e", "#2a9d4a", "#8e44ad", "#c49a00", "#c2185b", "#00939c", "#7a5230")
"""Of the cables in turn; dark enough for text."""

SMALL = 0.01
"""Of the size of the document: shorter edges would only darken the picture."""

MOST = 4000
"""Edges drawn; of more, the longest."""

MARGIN = 0.12
"""Around what is shown, of its size."""

SCALE_BARS = [m * 10.0**k for k in range(-1, 5) for m in (1, 2, 5)]
"""[mm]"""


def outlines(doc):
    """The edges of all that is visible, as arrays (n, 3) [mm] in the coordinates of the document."""
    shapes = [
        each.shape for root in roots(doc) for each in pieces(root, "") if isinstance(each, Piece)
    ]
    edges = [edge for shape in shapes for edge in shape.Edges if not edge.Degenerated]
    size = max((shape.BoundBox.DiagonalLength for shape in shapes), default=0.0)
    longest = sorted(((edge.Length, i) for i, edge in enumerate(edges)), reverse=True)[:MOST]
    drawn = [edges[i] for length, i in longest if length > SMALL * size]
    return [_array(edge.discretize(QuasiDeflection=size / 500)) for edge in drawn]


def colour(rank):
    return COLOURS[rank % len(COLOURS)]


def all_cables(entries, edges, view, width=460, height=340):
    """Every solved cable with its name; ``edges`` as ``outlines`` gives them."""
    picture = _Picture(VIEWS[view], [_array(e.line.points) for e in entries], width, height, 0.3)
    parts = [picture.edges(edges)]
    for rank, entry in enumerate(entries):
        parts += [picture.cable(entry, colour(rank)), picture.name(entry, colour(rank))]
    return picture.svg(parts, _seen(translate("CableReport", "All cables"), view))


def one_cable(entry, edges, tint, width=460, height=300):
    """A cable, its spline route dashed, what holds it, and its tightest place, from where it looks largest."""
    points = _array(entry.line.points)
    view = max(VIEWS, key=lambda name: _area(points, VIEWS[name]))
    shown = [points] + ([_array(entry.spline.points)] if entry.spline else [])
    picture = _Picture(VIEWS[view], shown, width, height, MARGIN)
    parts = [picture.edges(edges), picture.cable(entry, tint)]
    if entry.spline:
        parts.append(picture.path(_array(entry.spline.points), 'class="spline"'))
    parts += [picture.dot(place, "held", label) for label, place in entry.supports]
    if math.isfinite(entry.cable.SmallestBendRadius.Value):
        at = np.searchsorted(entry.line.arc_length, entry.cable.SmallestBendRadiusAt.Value)
        parts.append(picture.dot(entry.line.points[min(at, len(points) - 1)], "tightest", ""))
    return picture.svg(parts, _seen(entry.label, view))


def _seen(what, view):
    return {
        "above": translate("CableReport", "{what}, from above"),
        "front": translate("CableReport", "{what}, from the front"),
        "right": translate("CableReport", "{what}, from the right"),
        "corner": translate("CableReport", "{what}, from a corner"),
    }[view].format(what=what)


class _Picture:
    """A parallel projection onto a page of ``width`` and ``height`` that shows the ``lines`` [mm]."""

    def __init__(self, axes, lines, width, height, margin):
        self.axes = np.array(axes)
        self.size = width, height
        flat = np.vstack([line @ self.axes.T for line in lines] or [np.zeros((1, 2))])
        low, high = flat.min(axis=0), flat.max(axis=0)
        reach = max(high - low) or 1.0
        span = high - low + 2 * margin * reach
        self.scale = min(width / span[0], height / span[1])
        self.middle = (low + high) / 2

    def on_page(self, points):
        """(n, 2) of points (n, 3) [mm]."""
        flat = (points @ self.axes.T - self.middle) * self.scale * (1, -1)
        return flat + np.array(self.size) / 2

    def edges(self, edges):
        width, height = self.size
        drawn = []
        for edge in edges:
            flat = self.on_page(edge)
            low, high = flat.min(axis=0), flat.max(axis=0)
            inside = high[0] > 0 and high[1] > 0 and low[0] < width and low[1] < height
            if inside and max(high - low) > 1:
                drawn.append(_way(flat))
        return f'<path class="edge" d="{"".join(drawn)}"/>' if drawn else ""

    def cable(self, entry, tint):
        thick = max(1.5, entry.cable.CableType.OuterDiameter.Value * self.scale)
        style = f'class="cable" stroke="{tint}" stroke-width="{thick:.1f}"'
        return self.path(_array(entry.line.points), style)

    def path(self, points, attributes):
        return f'<path {attributes} d="{_way(self.on_page(points))}"/>'

    def name(self, entry, tint):
        ((x, y),) = self.on_page(_array([entry.line.points[len(entry.line.points) // 2]]))
        return f'<text class="name" x="{x:.1f}" y="{y:.1f}" style="fill:{tint}">{escape(entry.label)}</text>'

    def dot(self, place, kind, label):
        ((x, y),) = self.on_page(_array([place]))
        text = f'<text x="{x + 6:.1f}" y="{y - 4:.1f}">{escape(label)}</text>' if label else ""
        return f'<circle class="{kind}" cx="{x:.1f}" cy="{y:.1f}" r="3.5"/>{text}'

    def svg(self, parts, caption):
        width, height = self.size
        bar = max((b for b in SCALE_BARS if b * self.scale < width / 4), default=SCALE_BARS[0])
        y = height - 10
        scale = f'<path class="bar" d="M10 {y}h{bar * self.scale:.1f}"/><text x="10" y="{y - 5}">{bar:g} mm</text>'
        return (
            f'<figure><svg viewBox="0 0 {width} {height}" role="img">{"".join(parts)}{scale}</svg>'
            f"<figcaption>{escape(caption)}</figcaption></figure>"
        )


def _way(flat):
    return "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in flat.tolist())


def _array(points):
    return np.array([[*point] if isinstance(point, Vector) else point for point in points], float)


def _area(points, axes):
    """Of the box around the projection, and of a line its length."""
    across = np.ptp(points @ np.array(axes).T, axis=0)
    return across[0] * across[1] + 1e-3 * float(across @ across)
