# SPDX-License-Identifier: LGPL-2.1-or-later
"""The colour scale of a family: dark blue over green to yellow, darker to lighter, so that it reads without colours
too."""

STOPS = (
    (0.19, 0.16, 0.45),
    (0.16, 0.38, 0.55),
    (0.13, 0.57, 0.55),
    (0.37, 0.73, 0.38),
    (0.95, 0.85, 0.15),
)
"""RGB at equal distances."""


def scale(values) -> list[tuple[float, float, float]]:
    """RGB of each value, between the least and the largest."""
    values = list(values)
    low, high = min(values, default=0.0), max(values, default=0.0)
    return [_colour((value - low) / (high - low) if high > low else 0.0) for value in values]


def _colour(share):
    place = share * (len(STOPS) - 1)
    k = min(int(place), len(STOPS) - 2)
    a, b = STOPS[k : k + 2]
    return tuple(x + (place - k) * (y - x) for x, y in zip(a, b, strict=True))
