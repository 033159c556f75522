# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is solved: named problems. Extreme ones are in ``benchmarks/extreme.py``.

All but the seed paper's have EI = L = 1, so that their weight per length w is the ratio w L³/EI.
"""

from dataclasses import dataclass, replace

import numpy as np

from freecad_cable.geometry import rotation
from freecad_cable.options import SolveOptions
from freecad_cable.problem import Clamped, Free, Pinned, Rod, Scene, Swivel, round_section

GRAVITY = 9.81
TILTED = ([0.95, 0.1, 0.29], [0.98, -0.05, 0.15])
"""Tangents at the ends, nearly along the chord and in no plane."""
DRAG = 0.005
"""Length of one drag step, relative to the length of the cable."""


@dataclass(frozen=True)
class Case:
    name: str
    about: str
    scene: Scene

    def solved_with(self, options: SolveOptions) -> Scene:
        return replace(self.scene, options=options)


def moved(scene: Scene) -> Scene:
    """The next scene of a drag: the far end moved by ``DRAG`` of the length, across the chord so that no
    slack is lost. Where it is free the near tangent is turned by as much, which moves it as far."""
    if isinstance(scene.end, Pinned):
        across = _across(scene.end.position - scene.start.position, scene.gravity)
        position = scene.end.position + DRAG * scene.rod.length * across
        return replace(scene, end=replace(scene.end, position=position))
    tangent = scene.start.tangent
    across = _across(tangent, scene.gravity)
    return replace(scene, start=replace(scene.start, tangent=tangent + DRAG * across))


def _across(vector, other):
    normal = np.cross(vector, other)
    return normal / np.linalg.norm(normal)


def seed_paper(length) -> Scene:
    """Table 1 of Du, Jiang, Xiong (Sci Rep 12, 2022): diameter 7 mm, 1160 kg/m³ (the paper's 1.16 kg/cm³
    read as g/cm³), E = 10 MPa, G = 20 MPa; length [m]."""
    return Scene(
        rod=Rod(length=length, **round_section(0.007, 10e6, 20e6, 1160.0)),
        start=Clamped([0, 0, 0], [0.7071, 0.7071, 0, 0], place="start"),
        end=Clamped([0.16, -0.235, 0.33], [0.5, 0.5, 0.5, 0.5]),
    )


def tilted(length_ratio, weight_ratio, **section) -> Scene:
    """Clamped at both ends of a chord of 1/``length_ratio``; GJ = 0.8."""
    first, last = (rotation.from_tangent(tangent) for tangent in TILTED)
    return Scene(
        rod=_rod(weight_ratio, **section),
        start=Clamped([0, 0, 0], first, place="start"),
        end=Clamped([1 / length_ratio, 0, 0], last),
    )


def cantilever(weight_ratio) -> Scene:
    """Leaves a swivel at 45° upwards and hangs down from it."""
    start = Swivel([0, 0, 0], [1.0, 0.0, 1.0], place="start")
    return Scene(rod=_rod(weight_ratio), start=start, end=Free())


def _rod(weight_ratio, **section):
    usual = {"bending_stiffness": 1.0, "torsional_stiffness": 0.8}
    mass = weight_ratio / GRAVITY
    return Rod(length=1.0, radius=0.001, mass_per_length=mass, **(usual | section))


TABLE_1 = tuple(
    Case(f"table 1, {length} m", f"seed paper, Table 1, length {length} m", seed_paper(length))
    for length in (0.55, 0.64, 0.73, 0.82)
)

CASES = (
    *TABLE_1,
    Case("light", "w L³/EI = 1, length 1.1 times the chord", tilted(1.1, 1.0)),
    Case("heavy", "w L³/EI = 10³, length 1.1 times the chord", tilted(1.1, 1e3)),
    Case("very heavy", "w L³/EI = 10⁵, length 1.1 times the chord", tilted(1.1, 1e5)),
    Case("taut", "w L³/EI = 1, length 1.001 times the chord", tilted(1.001, 1.0)),
    Case(
        "anisotropic",
        "EI₁ : EI₂ : GJ = 1 : 3 : 0.8, natural curvature (1, 2)/L and twist 0.5/L, w L³/EI₁ = 30",
        tilted(1.25, 30.0, bending_stiffness=(1.0, 3.0), natural_curvature=(1.0, 2.0, 0.5)),
    ),
    Case(
        "swivel and free", "a swivel at 45° upwards and a free end, w L³/EI = 30", cantilever(30.0)
    ),
)
