# SPDX-License-Identifier: LGPL-2.1-or-later
"""The curvature along a cable and its spline route, as SVG."""

import math

import FreeCAD
import numpy as np

translate = FreeCAD.Qt.translate

WIDTH, HEIGHT = 460, 190
LEFT, RIGHT, TOP, BOTTOM = 44, 8, 12, 34
"""Margins for the numbers at the axes."""

HIGHEST = 3.0
"""A spline may bend as sharply as it likes; this many times what counts is enough to show."""


def curvature(entry, tint):
    """Curvature [1/m] over the distance from the start [mm]; the line of what is allowed; supports as ticks."""
    lines = [entry.line] + ([entry.spline] if entry.spline else [])
    limit = 1e3 / entry.allowed if entry.allowed else 0.0
    own = 1e3 * max(entry.line.curvature)
    peak = max(1e3 * max(line.curvature) for line in lines)
    counts = 1.15 * max(own, limit) or 1.0
    top = max(counts, min(1.05 * peak, HIGHEST * counts))
    length = max(line.arc_length[-1] for line in lines)
    x = lambda s: LEFT + s / length * (WIDTH - LEFT - RIGHT)  # noqa: E731
    y = lambda k: HEIGHT - BOTTOM - min(k / top, 1.0) * (HEIGHT - TOP - BOTTOM)  # noqa: E731
    parts = [_axes(x, y, length, top)]
    if limit:
        parts.append(f'<path class="limit" d="M{LEFT} {y(limit):.1f}H{WIDTH - RIGHT}"/>')
        allowed = translate("CableReport", "allowed")
        parts.append(f'<text class="limit" x="{LEFT + 4}" y="{y(limit) - 4:.1f}">{allowed}</text>')
    if entry.spline:
        parts.append(f'<path class="spline" d="{_way(entry.spline, x, y)}"/>')
    parts.append(f'<path class="curve" stroke="{tint}" d="{_way(entry.line, x, y)}"/>')
    for place in np.cumsum([stretch for _, stretch in entry.stretches])[:-1]:
        parts.append(f'<path class="tick" d="M{x(place):.1f} {HEIGHT - BOTTOM}v-8"/>')
    caption = translate(
        "CableReport",
        "Curvature [1/m] over the distance from the start [mm]; dashed: the spline route",
    )
    return (
        f'<figure><svg viewBox="0 0 {WIDTH} {HEIGHT}" role="img">{"".join(parts)}</svg>'
        f"<figcaption>{caption}</figcaption></figure>"
    )


def _axes(x, y, length, top):
    parts = [f'<path class="axis" d="M{LEFT} {TOP}V{HEIGHT - BOTTOM}H{WIDTH - RIGHT}"/>']
    for value in _ticks(length):
        parts.append(
            f'<text text-anchor="middle" x="{x(value):.1f}" y="{HEIGHT - BOTTOM + 16}">{value:g}</text>'
        )
    for value in _ticks(top):
        parts.append(f'<path class="grid" d="M{LEFT} {y(value):.1f}H{WIDTH - RIGHT}"/>')
        parts.append(
            f'<text text-anchor="end" x="{LEFT - 5}" y="{y(value) + 4:.1f}">{value:g}</text>'
        )
    return "".join(parts)


def _ticks(end):
    """About five round numbers from 0 up to ``end``."""
    rough = end / 5
    power = 10.0 ** math.floor(math.log10(rough))
    step = next(m * power for m in (1, 2, 5, 10) if m * power >= rough)
    return [step * i for i in range(int(end / step * (1 + 1e-9)) + 1)]


def _way(line, x, y):
    places = zip(line.arc_length, line.curvature, strict=True)
    return "M" + "L".join(f"{x(s):.1f} {y(1e3 * k):.1f}" for s, k in places)
