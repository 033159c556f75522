# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the nodes go: many where the rod bends sharply, few where it does not."""

import numpy as np
from scipy.integrate import trapezoid

COARSE = 32
"""Elements of a first mesh: Table 1 of the seed paper is then within 1e-5 L with the scheme of order 4. 24 take 0.93 of
the time, but the balance of moments then misses 0.4 % in place of 0.1 %; with 16 the iteration takes up to five times
as many steps."""
SIZES = (32, 48, 64, 96, 128, 192, 256, 384, 512, 768)
"""Element counts that refinement chooses from, so that built solvers find reuse."""


FEWEST = 8
"""Elements of a stretch between supports; the others are multiples, so that built solvers find reuse."""


def uniform(elements, breaks=()) -> np.ndarray:
    """(n+1,) arc lengths, those of ``breaks`` (supports) among them."""
    s = np.linspace(0, 1, 2)
    return _by_stretches(s, np.ones(2), elements, breaks)


def graded(elements, layers, breaks=()) -> np.ndarray:
    """(n+1,) arc lengths, twice as many elements for each of the ``layers`` as for all the rest: (place, width) of
    where bending is gathered, relative to the length."""
    narrowest = min((width for _, width in layers), default=1.0)
    near = np.concatenate([[0.0], np.geomspace(narrowest / 100, 1, 400)])
    s = [np.linspace(0, 1, 101), *(place + sign * near for place, _ in layers for sign in (1, -1))]
    s = np.unique(np.concatenate(s))
    s = s[(s >= 0) & (s <= 1)]
    density = np.ones_like(s)
    for place, width in layers:
        away = np.abs(s - place)
        # Elements that grow by a factor from one to the next: a spline through nodes that jump would ring.
        for layer in (np.exp(-away / (2 * width)), 1 / (away + 2 * width)):
            density += layer / trapezoid(layer, s)
    return _by_stretches(s, density, elements, breaks)


def refined(shape, elements) -> np.ndarray:
    """(n+1,) arc lengths that suit a shape: a linear strain misses h² κ''/8 in an element, and to spread the
    integral of that evenly wants a density of |κ''|^(1/3)."""
    return _by_stretches(*_densities(shape), elements, _breaks(shape))


def asked(shape, elements) -> np.ndarray:
    """(n+1,) arc lengths for a shape: of so many ``elements``, or, if None are asked for, its own."""
    return shape.arc_length if elements is None else uniform(elements, _breaks(shape))


def _breaks(shape):
    """Arc lengths of the supports."""
    return [shape.arc_length[joint.node] for joint in shape.joints]


def _densities(shape):
    """Arc lengths and densities (m,) there; at a support, both before and beyond it."""
    parts = shape.parts()
    s = np.concatenate([part.arc_length for part in parts])
    return s, np.concatenate([_density(part) for part in parts])


def _density(shape):
    if len(shape.steps) < 3:
        return np.ones(len(shape.arc_length))
    middle = (shape.arc_length[1:] + shape.arc_length[:-1]) / 2
    slope = np.diff(shape.strain[:, :3], axis=0) / shape.steps[:, None]
    bend = np.linalg.norm(np.diff(slope, axis=0) / np.diff(middle)[:, None], axis=1)
    bend = np.pad(bend, 1, mode="edge")
    # Neighbours share the sharpest, so that a sharp place stays inside its fine elements.
    wide = np.pad(bend, 1, mode="edge")
    bend = np.max([wide[:-2], bend, wide[2:]], axis=0)
    return (bend + 1e-6 * bend.max() + 1e-9) ** (1 / 3)


def gathered(shape, elements, places, width) -> np.ndarray:
    """(n+1,) arc lengths that suit a shape, half of them gathered about some ``places``, to a distance ``width`` from
    each: where a force acts at a point, the nearest node decides how well."""
    s, density = _densities(shape)
    fine = np.unique(
        np.concatenate(
            [s, *(c + np.array([-1, 1])[:, None] * _decades(width) for c in places)], axis=None
        )
    )
    fine = fine[(fine >= 0) & (fine <= 1)]
    near = sum(1 / (np.abs(fine - c) + width) for c in places)
    density = np.interp(fine, s, density)
    density = density / trapezoid(density, fine) + near / trapezoid(near, fine)
    return _by_stretches(fine, density, elements, _breaks(shape), floor=0.1)


def _decades(width):
    """Distances from ``width``/4 to 1 and 0, by equal factors."""
    return np.concatenate([[0.0], np.geomspace(width / 4, 1, 120)])


def size(elements) -> int:
    """The next count that refinement may choose; the finest if there is none."""
    return next((n for n in SIZES if n >= elements), SIZES[-1])


def _by_stretches(s, density, elements, breaks, floor=1 / 3):
    """Nodes for a density (m,) at s (m,), which may jump where s repeats; each stretch gets whole elements."""
    if not len(breaks):
        return _equidistributed(s, density, elements, floor)
    cumulative = _cumulative(s, density)
    places = np.array([0.0, *breaks, 1.0])
    share = np.diff(np.interp(places, s, cumulative)) / cumulative[-1]
    nodes = [np.zeros(1)]
    for a, b, part in zip(places, places[1:], share, strict=False):
        count = FEWEST * max(1, round(part * elements / FEWEST))
        inside = (s > a) & (s < b)
        own = np.concatenate([[a], s[inside], [b]])
        values = (
            np.interp(own, s, density)
            if inside.sum() < 2
            else np.concatenate([density[inside][:1], density[inside], density[inside][-1:]])
        )
        nodes.append(a + (b - a) * _equidistributed((own - a) / (b - a), values, count, floor)[1:])
    return np.concatenate(nodes)


def _cumulative(s, density):
    return np.concatenate([[0.0], np.cumsum((density[1:] + density[:-1]) / 2 * np.diff(s))])


def _equidistributed(s, density, elements, floor):
    """``floor``, a share of the average density: with 1/3 the largest element is at most four times the average."""
    cumulative = _cumulative(s, density)
    cumulative = cumulative / cumulative[-1] + floor * s
    nodes = np.interp(np.linspace(0, cumulative[-1], elements + 1), cumulative, s)
    nodes[0], nodes[-1] = 0.0, 1.0
    return nodes
