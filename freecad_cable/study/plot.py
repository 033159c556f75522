# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rows of a path as a drawing: SVG of panels one above the other, over the same values."""

import math
from dataclasses import dataclass
from html import escape

WIDTH, PANEL = 640, 150
"""[px] of the drawing, and height of a panel."""
LEFT, RIGHT, TOP, GAP = 76, 18, 34, 34
INK, LINE, LIMIT, GRID = "#333", "#1f6fb4", "#b00020", "#dde3e8"


@dataclass(frozen=True)
class Panel:
    """One quantity over the values; None where there is none."""

    title: str
    values: list
    limit: float | None = None
    """drawn as a line"""


def svg(title: str, name: str, values: list[float], panels: list[Panel], jumps=()) -> str:
    """Text of a drawing. ``name`` is that of the values (n,), ``jumps`` where vertical lines stand; curves break
    there."""
    height = TOP + len(panels) * (PANEL + GAP) + 16
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{height}" '
        f'viewBox="0 0 {WIDTH} {height}" font-family="sans-serif" font-size="11" fill="{INK}">',
        f'<rect width="{WIDTH}" height="{height}" fill="white"/>',
        f'<text x="{LEFT}" y="18" font-size="13">{escape(title)}</text>',
    ]
    across = _Scale(values, LEFT, WIDTH - RIGHT)
    for k, panel in enumerate(panels):
        top = TOP + k * (PANEL + GAP)
        parts += _panel(panel, values, across, top, jumps)
    parts.append(
        f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{height - 8}" text-anchor="middle">{escape(name)}</text>'
    )
    return "\n".join([*parts, "</svg>", ""])


class _Scale:
    """From numbers to pixels, with round ticks."""

    def __init__(self, numbers, first, last):
        low, high = min(numbers), max(numbers)
        if not high - low > 1e-9 * max(abs(low), abs(high)):
            pad = 0.05 * abs(high) or 1.0
            low, high = low - pad, high + pad
        step = 10 ** math.floor(math.log10((high - low) / 4))
        step *= next(m for m in (1, 2, 5, 10) if (high - low) / (m * step) <= 5)
        self.ticks = [k * step for k in range(math.ceil(low / step), math.floor(high / step) + 1)]
        self.low, self.high, self.first, self.last = low, high, first, last

    def __call__(self, number):
        share = (number - self.low) / (self.high - self.low)
        return self.first + share * (self.last - self.first)


def _panel(panel, values, across, top, jumps):
    bottom = top + PANEL
    known = [v for v in panel.values if v is not None and math.isfinite(v)]
    yield f'<text x="{LEFT}" y="{top - 4}">{escape(panel.title)}</text>'
    if not known:
        yield f'<text x="{LEFT + 8}" y="{top + 20}">none</text>'
        return
    shown = [*known, *([] if panel.limit is None else [panel.limit])]
    up = _Scale(shown, bottom, top)
    for tick in up.ticks:
        y = up(tick)
        yield f'<path d="M{LEFT} {y:.1f}H{WIDTH - RIGHT}" stroke="{GRID}"/>'
        yield f'<text x="{LEFT - 6}" y="{y + 4:.1f}" text-anchor="end">{tick:.6g}</text>'
    for tick in across.ticks:
        x = across(tick)
        yield f'<path d="M{x:.1f} {top}V{bottom}" stroke="{GRID}"/>'
        yield f'<text x="{x:.1f}" y="{bottom + 14}" text-anchor="middle">{tick:.6g}</text>'
    if panel.limit is not None:
        y = up(panel.limit)
        yield f'<path d="M{LEFT} {y:.1f}H{WIDTH - RIGHT}" stroke="{LIMIT}" stroke-dasharray="4 3"/>'
    for jump in jumps:
        x = across(jump)
        yield f'<path d="M{x:.1f} {top}V{bottom}" stroke="{LIMIT}"/>'
    for run in _runs(values, panel.values, jumps):
        points = " ".join(f"{across(x):.1f},{up(y):.1f}" for x, y in run)
        yield f'<polyline points="{points}" fill="none" stroke="{LINE}" stroke-width="2"/>'
        for x, y in run:
            yield f'<circle cx="{across(x):.1f}" cy="{up(y):.1f}" r="2" fill="{LINE}"/>'


def _runs(values, numbers, jumps):
    """Pairs between which nothing is missing and nothing jumps."""
    run = []
    for x, y in zip(values, numbers, strict=True):
        known = y is not None and math.isfinite(y)
        if run and (not known or any(min(run[-1][0], x) <= j <= max(run[-1][0], x) for j in jumps)):
            yield run
            run = []
        if known:
            run.append((x, y))
    if run:
        yield run
