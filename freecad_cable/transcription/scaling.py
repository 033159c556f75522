# SPDX-License-Identifier: LGPL-2.1-or-later
"""The door between SI units and the numbers of the program.

Lengths are measured in cable lengths from the point that holds the cable, forces in EI/L² + w L: then
positions, curvatures and forces of light and of heavy cables are all of order one, and one absolute
tolerance of the solver means the same for a wire of a millimetre and a sea cable.
"""

from dataclasses import dataclass, replace

import numpy as np

from ..geometry import rotation
from ..problem import Clamp, Clamped, Free, Ring, Scene
from ..problem.reach import play
from ..problem.reduce import orientation
from .shape import Shape

MUCH = 30.0
"""Force, in units of force, from which it becomes the unit: with contact on a taut cable, from some hundreds on fatrop
needs ten times the iterations, or fails."""


@dataclass(frozen=True)
class Scaling:
    """``length`` [m], ``force`` [N], ``origin`` (3,) [m], ``weight_ratio`` w L³/EI, ``tightness`` force L²/EI."""

    length: float
    force: float
    origin: np.ndarray
    weight_ratio: float
    tightness: float

    @classmethod
    def of(cls, scene: Scene) -> "Scaling":
        rod = scene.rod
        stiffness = float(np.sqrt(np.prod(rod.bending_stiffness)))
        ratio = float(np.linalg.norm(scene.weight)) * rod.length**3 / stiffness
        force = stiffness / rod.length**2 * (1 + ratio)
        held = [h for h in (scene.start, scene.end, *scene.supports) if not isinstance(h, Free)]
        return cls(rod.length, force, held[0].position, ratio, 1 + ratio)

    def loaded(self, load: float) -> "Scaling":
        """That of the same rod under ``load`` times its weight."""
        ratio = load * self.weight_ratio
        factor = (1 + ratio) / (1 + self.weight_ratio)
        return replace(
            self,
            force=self.force * factor,
            weight_ratio=ratio,
            tightness=self.tightness * factor,
        )

    def pulled(self, pull: float) -> "Scaling":
        """That of a rod under a tension of at least ``pull``, in EI/L²."""
        factor = max(1.0, pull / self.tightness)
        return replace(self, force=self.force * factor, tightness=self.tightness * factor)

    def fit_for(self, force) -> "Scaling":
        """The same unless a ``force`` [N] is so many units that solvers cannot balance it to their tolerance."""
        much = force > MUCH * self.force
        return self.pulled(force * self.tightness / self.force) if much else self

    @property
    def energy(self) -> float:
        """[J]; also the unit of moments [N m]"""
        return self.force * self.length

    def point(self, position) -> np.ndarray:
        """World position [m] → without units."""
        return (np.asarray(position) - self.origin) / self.length

    def stiffness(self, rod) -> np.ndarray:
        """(6,) of κ1, κ2, τ, γ1, γ2, ε without units; 0 where the rod is rigid."""
        shear, axial = rod.shear_stiffness or 0.0, rod.axial_stiffness or 0.0
        return np.concatenate(
            [
                rod.stiffness / (self.force * self.length**2),
                np.array([shear, shear, axial]) / self.force,
            ]
        )

    def parameters(self, scene: Scene, start: Shape, load=1.0, reach=1.0) -> dict:
        """Values of ``nlp.PARAMETERS`` and a dict for each support. The frames of ``start`` stand in where the scene
        prescribes none; ``load`` scales gravity and ``reach`` the distances of what holds the cable (for
        continuation)."""
        frames = start.quaternion
        return {
            "stiffness": self.stiffness(scene.rod),
            "natural": scene.rod.natural_curvature * self.length,
            "weight": load * scene.weight * self.length / self.force,
            "start_position": reach * self._position(scene.start),
            "start_quaternion": frame(scene.start, frames[0]),
            "end_position": reach * self._position(scene.end),
            "end_quaternion": frame(scene.end, frames[-1]),
            "curvature_limit": self.length / (scene.rod.min_bend_radius or self.length),
            "supports": [
                {
                    "position": reach * self._position(support),
                    "quaternion": frame(support, frames[joint.node]),
                    "play": reach * self.play(support, scene.rod),
                    "arc_length": start.arc_length[joint.node],
                }
                for support, joint in zip(scene.supports, start.joints, strict=True)
            ],
        }

    def play(self, support, rod) -> float:
        """Play of a support without units."""
        return play(support, rod) / self.length

    def _position(self, end):
        return np.zeros(3) if isinstance(end, Free) else self.point(end.position)


def frame(end, otherwise):
    """Quaternion (4,) of an end or a support: its own, one along its tangent or axis, or the one given."""
    if isinstance(end, (Clamped, Clamp)):
        return end.quaternion
    if isinstance(end, Ring):
        return rotation.from_tangent(end.axis)
    tangent = orientation(end)
    if tangent is None:
        return otherwise
    # Nearest to the given frame: so the roll, which is free, starts where the guess has it.
    turn = rotation.shortest_arc(rotation.tangent(otherwise), tangent)
    return rotation.multiply(turn, otherwise)
