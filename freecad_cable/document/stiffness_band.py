# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a cable hangs if its strands slip on each other, and if they stick: between the two lies the real one."""

from dataclasses import dataclass, replace

import numpy as np

from ..equilibrium import find_equilibrium
from ..errors import DocumentError
from ..shape.units import from_si, to_si
from .read_scene import read_scene
from .stored_solution import kept


@dataclass(frozen=True)
class Bound:
    """The cable at one end of its band."""

    name: str
    """Slip or Stick"""
    radius: float
    """smallest bend radius [mm]"""
    shift: float
    """largest distance from the shape that the cable shows, at the same share of the length [mm]"""


def band(cable) -> list[Bound]:
    """The solved cable with each bound of bending stiffness that its type states, at the length that it has.

    Errors: ``CableError`` if it cannot be solved there.
    """
    kind, scene = cable.CableType, read_scene(cable)
    # The length is no longer asked for: the cable that is cut has this one.
    rod = replace(scene.rod, length=to_si("length", cable.SolvedLength))
    scene = replace(scene, rod=rod, asks_length=False)
    shown, found = kept(cable, scene), []
    for name in ("Slip", "Stick"):
        bound = getattr(kind, f"{name}BendingStiffness").Value
        if not bound:
            continue
        share = bound / kind.BendingStiffness.Value
        stiffness = rod.bending_stiffness * share
        solution = find_equilibrium(
            replace(scene, rod=replace(rod, bending_stiffness=stiffness)), start=shown
        )
        if not solution.status.success:
            raise DocumentError(f"{cable.Label}, with {name}BendingStiffness: {solution.message}")
        found.append(
            Bound(name, from_si("length", solution.min_bend_radius[0]), _shift(shown, solution))
        )
    return found


def _shift(one, other):
    """[mm]"""
    shares = np.linspace(0, 1, 101)
    places = [
        np.column_stack(
            [np.interp(shares, s.arc_length / s.arc_length[-1], x) for x in s.position.T]
        )
        for s in (one, other)
    ]
    return from_si("length", float(np.linalg.norm(places[0] - places[1], axis=1).max()))
