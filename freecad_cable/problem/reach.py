# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether the cable is long enough: for its ends, for its supports, and between those at known arc lengths."""

from dataclasses import dataclass

import numpy as np

from ..errors import ProblemError
from .ends import Pinned
from .supports import Ring


@dataclass(frozen=True)
class Station:
    """A place where the cable is held within ``play`` [m] of ``position``; ``arc_length`` None if it slides."""

    place: str
    position: np.ndarray
    play: float
    arc_length: float | None


def stations(scene) -> list[Station]:
    """Where a scene holds the cable, in order along it. Errors: ``ProblemError`` for a ring that is too small and for
    supports out of order."""
    rod = scene.rod
    found = []
    if isinstance(scene.start, Pinned):
        found.append(Station("start", scene.start.position, 0.0, 0.0))
    before = 0.0, "the start of the cable"
    for support in scene.supports:
        if support.arc_length is not None:
            _check_order(support, before, rod.length)
            before = support.arc_length, support.place
        found.append(
            Station(support.place, support.position, play(support, rod), support.arc_length)
        )
    if isinstance(scene.end, Pinned):
        found.append(Station("end", scene.end.position, 0.0, rod.length))
    return found


def sections(held) -> list[list[Station]]:
    """The stations from each with an arc length to the next such, both included."""
    fixed = [i for i, station in enumerate(held) if station.arc_length is not None]
    return [held[a : b + 1] for a, b in zip(fixed, fixed[1:], strict=False)]


def play(support, rod) -> float:
    """How far the centreline may be from a support's position [m]."""
    if not isinstance(support, Ring):
        return 0.0
    if support.radius < rod.radius:
        raise ProblemError(
            f"{support.place}.radius",
            f"is {support.radius:.6g} m, but the cable's radius is {rod.radius:.6g} m, so it does not pass; "
            "take a wider ring or a thinner cable",
        )
    return support.radius - rod.radius


def _check_order(support, before, length):
    here, (last, other) = support.arc_length, before
    if here <= last:
        raise ProblemError(
            f"{support.place}.arc_length",
            f"is {here:.6g} m, but {other} before it is at {last:.6g} m; "
            "supports must be in order along the cable",
        )
    if here >= length:
        raise ProblemError(
            f"{support.place}.arc_length",
            f"is {here:.6g} m, which is not on the cable; its length is {length:.6g} m",
        )


def check_reach(scene):
    """Errors: ``ProblemError`` where an inextensible cable is too short."""
    held = stations(scene)
    if scene.rod.axial_stiffness is not None or not held:
        return
    fixed = [i for i, station in enumerate(held) if station.arc_length is not None]
    if not fixed:
        return
    for section in sections(held):
        _check_between(section, scene)
    _check_tail(held[: fixed[0] + 1], held[fixed[0]].arc_length)
    _check_tail(held[fixed[-1] :][::-1], scene.rod.length - held[fixed[-1]].arc_length)


def chord_through(positions) -> float:
    """Length [m] of the polyline through positions (k, 3): the base of slack."""
    return float(np.linalg.norm(np.diff(np.array(positions), axis=0), axis=1).sum())


def shortest_way(held) -> float:
    """Lower bound [m] of the length of any curve through the stations in order."""
    points = np.array([station.position for station in held])
    if not any(station.play for station in held):
        return chord_through(points)
    # Every leg may be shorter by the play at both its ends, and no way is shorter than one that skips stations.
    best = np.full(len(held), -np.inf)
    best[0] = 0.0
    for j in range(1, len(held)):
        legs = np.linalg.norm(points[:j] - points[j], axis=1)
        for i in range(j):
            leg = max(legs[i] - held[i].play - held[j].play, 0.0)
            best[j] = max(best[j], best[i] + leg)
    return float(best[-1])


def _check_between(held, scene):
    first, last = held[0], held[-1]
    there, needed = last.arc_length - first.arc_length, shortest_way(held)
    if there >= needed:
        return
    if (first.place, last.place) == ("start", "end") and len(held) == 2:
        message = f"the ends are {needed:.6g} m apart"
    elif (first.place, last.place) == ("start", "end"):
        message = f"the way through its supports is {needed:.6g} m"
    else:
        apart = f"they are {needed:.6g} m apart"
        if len(held) > 2:
            apart = f"the way through the supports between them is {needed:.6g} m"
        raise ProblemError(
            f"{last.place}.arc_length" if last.place != "end" else f"{first.place}.arc_length",
            f"leaves {there:.6g} m of cable between {first.place} and {last.place}, but {apart}; "
            f"the shortest possible is {needed:.6g} m",
        )
    raise ProblemError(
        "cable.length",
        f"is {there:.6g} m, but {message}; the shortest possible length is {needed:.6g} m",
    )


def _check_tail(held, there):
    """Sliding supports between the last station (the first from here with an arc length) and a free end of the cable,
    ``there`` [m] of cable away from it."""
    if len(held) < 2:
        return
    needed = shortest_way(held)
    if there < needed:
        raise ProblemError(
            held[0].place,
            f"is {needed:.6g} m away from {held[-1].place}, but the cable has only {there:.6g} m on this side of it, "
            "so it does not reach; the cable must be longer or the support nearer",
        )
