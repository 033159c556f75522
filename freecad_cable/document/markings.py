# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is to be seen on a solved cable, as plain places in its container [mm]: how near each piece of it is to its bend
radius, the tightest place, where forces act, and where obstacles push."""

import math
from dataclasses import dataclass

import numpy as np

from ..geometry import rotation
from ..geometry.curves import Curve
from ..shape.skin import skin
from ..shape.units import from_si, to_si
from . import verdict
from .read_held import read_held
from .stored_solution import nodes

NOTHING = 1e-3
"""Force, as a share of the greatest, that is not shown: a ring that is hardly touched."""


@dataclass(frozen=True)
class Coloured:
    """A grid of ``rows`` times ``columns`` points, row by row, and for each row the share by which the bend radius
    exceeds the limit: negative where it is violated, infinite where the cable is straight; None without a limit."""

    rows: int
    columns: int
    points: list
    margins: list | None


@dataclass(frozen=True)
class Mark:
    """A place of the cable, and what is said about it."""

    place: tuple
    text: str
    force: tuple = (0.0, 0.0, 0.0)
    """[N] on the cable"""


def coloured(cable) -> Coloured:
    """Errors: ``DocumentError`` where the cable has no surface."""
    drawn = cable.Profile.Shape if cable.Profile else None
    found = skin(nodes(cable), read_held(cable).rod.radius, drawn)
    limit = verdict.of_cable(cable).limit
    margins = (found.bend_radius / limit - 1).tolist() if limit else None
    rows, columns, _ = found.points.shape
    return Coloured(rows, columns, found.points.reshape(-1, 3).tolist(), margins)


def tightest(cable) -> Mark | None:
    """The place with the smallest bend radius; None if the cable is straight."""
    radius = cable.SmallestBendRadius.Value
    if not math.isfinite(radius):
        return None
    (place,) = _at(cable, [cable.SmallestBendRadiusAt.Value])
    return Mark(place, f"R {radius:.4g} mm")


def forces(cable) -> list[Mark]:
    """What terminals and supports exert on the cable; none that is nothing beside the others."""
    held = [cable.NodePosition[node] for node in (0, *cable.NodeOfSupport, -1)]
    exerted = [cable.StartForce, *cable.SupportForces, cable.EndForce]
    return [
        Mark(
            tuple(from_si("length", np.array(place)).tolist()),
            f"{force.Length:.3g} N",
            tuple(force),
        )
        for place, force in zip(held, exerted, strict=True)
        if force.Length > NOTHING * max(each.Length for each in exerted)
    ]


def contacts(cable) -> list[Mark]:
    """Where obstacles push."""
    places = _at(cable, cable.ContactPlaces)
    found = zip(places, cable.ContactObstacles, cable.ContactForces, strict=True)
    return [Mark(place, name, tuple(force)) for place, name, force in found]


def _at(cable, lengths):
    """Places at ``lengths`` [mm] from the start."""
    if not len(lengths):
        return []
    stored = nodes(cable)
    curve = Curve(stored.arc_length, stored.position, rotation.tangent(stored.quaternion))
    found = curve.at(to_si("length", np.array(lengths, float)))[0]
    return [tuple(place) for place in from_si("length", found).tolist()]
