# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a scene does not need, decided before it is solved, and said in words."""

from dataclasses import dataclass

import numpy as np

from ..geometry import rotation
from .ends import Clamped, Swivel
from .reach import sections, shortest_way, stations
from .scene import Scene
from .supports import Clamp, Sleeve

SHEAR, STRETCH = (3, 4), (5,)


SLACK = 0.01
"""Slack, relative to the length, from which a cable may be taken as inextensible to begin with: a tauter one may need
its stretch to reach at all."""


@dataclass(frozen=True)
class Model:
    """What of the rod is computed. ``strains`` indexes (κ1, κ2, τ, γ1, γ2, ε)."""

    strains: tuple[int, ...]
    left_out: tuple[str, ...]
    kept: tuple[str, ...]
    tried: tuple[str, ...] = ()
    """effects with a given stiffness that are left out to begin with: whether they matter is seen from the loads"""

    @property
    def twist(self) -> bool:
        return 2 in self.strains


def reduce(scene: Scene, *, rigid: bool = True) -> Model:
    """Decide what the model keeps. Each sentence says what was left out and why that is exact.

    With ``rigid`` shear and stretch are left out of slack cables to begin with."""
    rod, keep = scene.rod, scene.options.keep
    strains, left_out, kept, tried = [0, 1], [], ["bending in two directions"], []

    holders = [h for h in (scene.start, *scene.supports, scene.end) if _holds_twist(h)]
    if len(holders) > 1 or not rod.isotropic or "torsion" in keep:
        strains.append(2)
        kept.append("torsion")
    else:
        left_out.append(f"torsion: {_why_no_torque(scene)}")
    if scene.weight.any():
        kept.append("gravity")
    else:
        left_out.append("gravity: there is none, or the cable has no mass (exact)")
    for stiffness, indices, name in (
        (rod.shear_stiffness, SHEAR, "shear"),
        (rod.axial_stiffness, STRETCH, "stretch"),
    ):
        if stiffness is None:
            left_out.append(
                f"{name}: no stiffness is given, so the cable is taken as rigid in {name}"
            )
        elif rigid and name not in keep and tautness(scene) < 1 - SLACK:
            tried.append(name)
        else:
            strains.extend(indices)
            kept.append(name)
    return Model(tuple(strains), tuple(left_out), tuple(kept), tuple(tried))


def tautness(scene: Scene) -> float:
    """Distance over length of the held places between which the cable is most taut; 0 if there are not two."""
    ratios = [
        shortest_way(section) / (section[-1].arc_length - section[0].arc_length)
        for section in sections(stations(scene))
    ]
    return max(ratios, default=0.0)


def _holds_twist(holder) -> bool:
    return isinstance(holder, (Clamped, Clamp))


def _why_no_torque(scene) -> str:
    if scene.supports:
        loose = "all that holds the cable, but for one clamp at most, lets it twist"
    elif _holds_twist(scene.start):
        loose = "the end is free to twist"
    else:
        loose = "the start is free to twist"
    return f"{loose} and the cable bends alike in all directions, so it carries no torque (exact)"


def orientation(end) -> np.ndarray | None:
    """Unit tangent (3,) that an end or a support prescribes, or None."""
    if _holds_twist(end):
        return rotation.tangent(end.quaternion)
    return end.tangent if isinstance(end, (Swivel, Sleeve)) else None
