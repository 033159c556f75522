# SPDX-License-Identifier: LGPL-2.1-or-later
"""The exact equilibria that errors are measured against, from the independent solver of the strong form."""

import numpy as np
from scipy.interpolate import BPoly

from freecad_cable.geometry import rotation
from freecad_cable.problem import Scene
from freecad_cable.reference.state import RodState
from freecad_cable.reference.strong_form import equilibrium
from freecad_cable.result import Solution

UNCERTAIN = 1e-10
"""How well, relative to the length, an exact shape must be known: a hundredth of the errors measured against it
that matter."""
ANOTHER = 0.01
"""Distance, relative to the length, from which a shape is another equilibrium and not an error."""


class Exact:
    """The exact equilibria of each case, solved in strong form as they are met."""

    def __init__(self):
        self.branches: dict[str, list[Branch]] = {}

    def near(self, name: str, solution: Solution) -> tuple[int, "Branch"]:
        """The equilibrium that a solution of this case is near to, and its place in the list.
        Errors: ``NoSolutionError``."""
        branches = self.branches.setdefault(name, [])
        for place, branch in enumerate(branches):
            if branch.distance(solution) < ANOTHER * solution.scene.rod.length:
                return place, branch
        branches.append(Branch.near(solution))
        return len(branches) - 1, branches[-1]

    @property
    def uncertainty(self) -> float:
        """How well the worst of them is known, relative to the length."""
        known = [branch.uncertainty for branches in self.branches.values() for branch in branches]
        return max(known, default=0.0)


class Branch:
    """One exact equilibrium of a rod, read at any arc length: quintic polynomials through position and its first two
    derivatives at its nodes."""

    def __init__(self, scene: Scene, state: RodState):
        self.state = state
        given = np.stack([state.position, *_derivatives(scene, state)], axis=1)
        self.position = BPoly.from_derivatives(state.arc_length, given)
        rough = BPoly.from_derivatives(state.arc_length[::2], given[::2])
        between = rough(state.arc_length) - state.position
        # Twice the nodes, 2⁶ times the accuracy.
        interpolation = np.linalg.norm(between, axis=1).max() / 2**6
        self.uncertainty = (state.error + interpolation) / scene.rod.length
        """how well it is known, relative to the length"""

    @classmethod
    def near(cls, solution: Solution, uncertain=UNCERTAIN) -> "Branch":
        """Errors: ``NoSolutionError``."""
        scene = solution.scene
        branch = cls(scene, equilibrium(scene, solution, tolerance=uncertain))
        while branch.uncertainty > uncertain:
            # From its own nodes the solver comes back with twice as many.
            branch = cls(scene, equilibrium(scene, branch.state, tolerance=uncertain))
        return branch

    def distance(self, solution) -> float:
        """Largest distance of a node of the solution (arc lengths and positions) from its exact place [m]."""
        apart = solution.position - self.position(solution.arc_length)
        return float(np.linalg.norm(apart, axis=1).max())


def _derivatives(scene, state):
    """r' = R v and r'' = R (κ × v + v') with v = e₃ + C Rᵀn and v' = −C (Rᵀw + κ × Rᵀn), each (m, 3)."""
    rod, frames = scene.rod, rotation.matrix(state.quaternion)
    loads = (state.moment, state.force, np.broadcast_to(scene.weight, state.force.shape))
    moment, force, weight = (np.einsum("kij,ki->kj", frames, load) for load in loads)
    curvature = rod.natural_curvature + moment / rod.stiffness
    soft = np.array(
        [
            0.0 if s is None else 1 / s
            for s in (rod.shear_stiffness, rod.shear_stiffness, rod.axial_stiffness)
        ]
    )
    inside = soft * force + [0.0, 0.0, 1.0]
    change = -soft * (weight + np.cross(curvature, force))
    return (
        np.einsum("kij,kj->ki", frames, inside),
        np.einsum("kij,kj->ki", frames, np.cross(curvature, inside) + change),
    )
