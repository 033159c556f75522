# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a scene holds its cable, with an arc length for each place: given, or a first guess where the cable slides."""

from dataclasses import dataclass

import numpy as np

from ..problem import End, Pinned, Ring, Scene, Support
from ..problem.reduce import orientation
from .scaling import Scaling

BEYOND = 1.05
"""Length to chord of a first guess where a free end leaves it open."""


CLOSEST = 2e-3
"""Share of the way that a first guess leaves at least between neighbours: from one without length none starts."""


@dataclass(frozen=True)
class Waypoint:
    """A held place without units, the end or support that holds it, and of a ring the way through it (3,)."""

    arc_length: float
    position: np.ndarray
    holder: End | Support
    way: np.ndarray | None

    @property
    def tangent(self) -> np.ndarray | None:
        """(3,); None where the scene gives none."""
        return orientation(self.holder) if self.way is None else self.way


def waypoints(scene: Scene, scaling: Scaling) -> list[Waypoint]:
    """All places that hold the cable, in order."""
    places = [s.arc_length / scaling.length if not s.slides else np.nan for s in scene.supports]
    holders = list(scene.supports)
    if isinstance(scene.start, Pinned):
        places, holders = [0.0, *places], [scene.start, *holders]
    if isinstance(scene.end, Pinned):
        places, holders = [*places, 1.0], [*holders, scene.end]
    positions = scaling.point([holder.position for holder in holders])
    ways = [
        _through(positions, i, holder.axis) if isinstance(holder, Ring) else None
        for i, holder in enumerate(holders)
    ]
    places = _spread(np.array(places), positions)
    return [Waypoint(*each) for each in zip(places, positions, holders, ways, strict=True)]


def breaks(scene: Scene, scaling: Scaling) -> tuple[float, ...]:
    """Arc lengths of the supports."""
    first = isinstance(scene.start, Pinned)
    found = waypoints(scene, scaling)[first : first + len(scene.supports)]
    return tuple(float(each.arc_length) for each in found)


def _spread(places, positions):
    """Arc lengths for those that slide (NaN), in proportion to the distances between them."""
    if np.isfinite(places).all():
        return places
    chords = np.linalg.norm(np.diff(positions, axis=0), axis=1)
    chords = np.maximum(chords, CLOSEST * chords.sum() + 1e-9)
    way = np.concatenate([[0.0], np.cumsum(chords)])
    known = np.flatnonzero(np.isfinite(places))
    first, last = known[0], known[-1]
    spread = places.copy()
    for a, b in zip(known, known[1:], strict=False):
        # A long stretch takes slack at less force than a short one.
        there, own = places[b] - places[a], chords[a:b]
        slack = max(there - own.sum(), 0.0)
        own = own * (there - slack) / own.sum() + slack * own**2 / (own**2).sum()
        spread[a:b] = places[a] + np.concatenate([[0.0], np.cumsum(own)[:-1]])
    before, after = slice(0, first), slice(last + 1, None)
    for beyond, origin, there, sign in (
        (before, first, places[first], -1),
        (after, last, 1 - places[last], 1),
    ):
        away = np.abs(way[beyond] - way[origin])
        if away.size:
            factor = min(BEYOND, (1 + there / away.max()) / 2)
            spread[beyond] = places[origin] + sign * factor * away
    return spread


def _through(positions, i, axis):
    """Direction in which a cable passes a ring: from its neighbour before to the one after."""
    before, after = positions[max(i - 1, 0)], positions[min(i + 1, len(positions) - 1)]
    way = after - before
    length = np.linalg.norm(way)
    return way / length if length > 1e-9 else axis
