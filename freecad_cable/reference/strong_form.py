# SPDX-License-Identifier: LGPL-2.1-or-later
"""The general static rod, solved in strong form until its own error is negligible.

Independent of how cables are solved: no energy, no discrete rod, no CasADi. It finds the
equilibrium near a start and does not ask whether it is stable.
"""

from dataclasses import replace

import numpy as np

from ..errors import NotYetError
from ..geometry.rotation import continuous
from ..problem import Pinned, Scene
from ..result import Energy
from . import held
from .collocation import Collocated, Gauss, NoSolutionError, solve
from .rod_equations import M, N, Q, R, RodEquations, cross, rotation
from .state import RodState

ZERO = np.zeros(3)
LARGEST_MESH = 5000
ROUGH = 1e-3
"""Last Legendre coefficient of an element's y' times its length from which it is split: it grades
the mesh, so that layers at the ends do not ask for a fine mesh everywhere."""


def equilibrium(
    scene: Scene,
    start,
    *,
    end_force=ZERO,
    end_moment=ZERO,
    tolerance=1e-10,
    stages=5,
) -> RodState:
    """The equilibrium of the scene near ``start``, its nodes within ``tolerance`` · length of the
    exact ones.

    ``start`` has arrays ``arc_length`` (n+1,), ``position`` and ``quaternion``, and ``force`` and
    ``moment`` or None for both: a ``Solution`` or a ``RodState``. Its arc lengths are among those
    of the result. ``end_force`` and ``end_moment`` (3,) are dead loads on a free end (at the end of
    the rod). The mesh is refined where the highest Legendre coefficient of y' is large, and then
    halved until the nodes stay where they are; the last change is the error stated, and bounds that
    of the finer mesh returned.

    Errors: ``NotYetError`` for supports and obstacles, ``NoSolutionError`` if Newton's method does
    not converge.
    """
    for name in ("supports", "obstacles"):
        if getattr(scene, name):
            raise NotYetError(
                name, "the strong form knows a rod between its ends only; leave them out"
            )
    end_force, end_moment = np.asarray(end_force, float), np.asarray(end_moment, float)
    units = _Units(scene)
    rod = units.equations(scene)
    first = held.conditions(units.end(scene.start), ZERO, ZERO)
    last = held.conditions(units.end(scene.end), end_force / units.force, end_moment / units.moment)
    nodes = units.nodes(start, rod)
    scale = np.repeat((1.0, 1.0, _peak(nodes[:, N]), _peak(nodes[:, M])), (3, 4, 3, 3))
    gauss = Gauss.of(stages)
    symmetries = held.symmetries(scene, (end_force, end_moment))

    def solved(guess):
        if len(guess.mesh) > LARGEST_MESH:
            raise NoSolutionError(f"{LARGEST_MESH} elements are not fine enough")
        start_conditions = held.with_unit_quaternion(first)
        return solve(rod.rate, start_conditions, last, guess, gauss, scale, symmetries)

    found = solved(_first_guess(start.arc_length / units.length, nodes, gauss))
    while True:
        rough = np.max(gauss.tail(rod.rate(found.stages)[0]) / scale, axis=1) * np.diff(found.mesh)
        if not (marked := rough > ROUGH).any():
            break
        found = solved(_split(found, marked, gauss, rod))
    while True:
        finer = solved(_split(found, np.ones(len(found.stages), bool), gauss, rod))
        error = np.abs(finer.nodes[::2, R] - found.nodes[:, R]).max()
        found = finer
        if error < tolerance:
            return units.state(found, rod, gauss, error)


def _peak(values):
    return max(1.0, float(np.abs(values).max()))


def _first_guess(mesh, nodes, gauss):
    stages = nodes[:-1, None] + gauss.places[:, None] * np.diff(nodes, axis=0)[:, None]
    return Collocated(mesh, nodes, stages)


def _split(found, marked, gauss, rod):
    """The solution on the mesh with the marked elements halved, read off its polynomials."""
    step = np.diff(found.mesh)
    slopes = rod.rate(found.stages)[0] * step[:, None, None]

    def read(place):
        return found.nodes[:-1] + gauss.at(place, slopes)

    mesh, nodes, stages = [], [], []
    halves = [
        np.stack([read(half / 2 + place / 2) for place in gauss.places], axis=1) for half in (0, 1)
    ]
    middle = read(0.5)
    for i, halve in enumerate(marked):
        mesh.append(found.mesh[i])
        nodes.append(found.nodes[i])
        if halve:
            mesh.append(found.mesh[i] + step[i] / 2)
            nodes.append(middle[i])
            stages += [halves[0][i], halves[1][i]]
        else:
            stages.append(found.stages[i])
    return Collocated(
        np.append(mesh, found.mesh[-1]), np.vstack((*nodes, found.nodes[-1])), np.array(stages)
    )


class _Units:
    """Lengths in L, forces in EI/L² and moments in EI/L, EI the mean of both."""

    def __init__(self, scene):
        self.length = scene.rod.length
        stiffness = float(np.mean(scene.rod.bending_stiffness))
        self.moment = stiffness / self.length
        self.force = self.moment / self.length

    def equations(self, scene):
        rod = scene.rod
        soft = [
            0.0 if value is None else self.force / value
            for value in (rod.shear_stiffness, rod.shear_stiffness, rod.axial_stiffness)
        ]
        return RodEquations(
            rod.stiffness / (self.moment * self.length),
            np.array(soft),
            rod.natural_curvature * self.length,
            scene.weight * self.length / self.force,
        )

    def end(self, end):
        return replace(end, position=end.position / self.length) if isinstance(end, Pinned) else end

    def nodes(self, start, rod):
        position, quaternion = start.position / self.length, continuous(start.quaternion)
        if start.force is None:
            mesh = start.arc_length / self.length
            force, moment = _wrench_of_shape(rod, mesh, position, quaternion)
        else:
            force, moment = start.force / self.force, start.moment / self.moment
        return np.hstack((position, quaternion, force, moment))

    def state(self, found, rod, gauss, error):
        step = np.diff(found.mesh)
        curvature, stretch = rod.strains(found.stages)
        soft = np.where(rod.compliance > 0, rod.compliance, np.inf)
        densities = np.stack(
            (
                (rod.stiffness * (curvature - rod.natural_curvature) ** 2)[..., :2].sum(-1) / 2,
                (rod.stiffness * (curvature - rod.natural_curvature) ** 2)[..., 2] / 2,
                (stretch**2 / soft).sum(-1) / 2,
                -(found.stages[..., R] - found.nodes[0, R]) @ rod.weight,
            )
        )
        energy = np.einsum("n,j,enj->e", step, gauss.weights, densities) * self.moment
        return RodState(
            arc_length=found.mesh * self.length,
            position=found.nodes[:, R] * self.length,
            quaternion=found.nodes[:, Q],
            force=found.nodes[:, N] * self.force,
            moment=found.nodes[:, M] * self.moment,
            energy=Energy(*energy.tolist()),
            error=error * self.length,
        )


def _wrench_of_shape(rod, mesh, position, quaternion):
    """Force and moment (n+1, 3) that come nearest to holding a given shape.

    Of all in balance with the weight, those whose moment in the middles of the elements is nearest
    to R K (κ − κ0), κ from the turn between the nodes.
    """
    step = np.diff(mesh)
    mean = quaternion[1:] + quaternion[:-1]
    mean /= np.linalg.norm(mean, axis=1, keepdims=True)
    turn = rotation(mean)
    w, v = mean[:, :1], mean[:, 1:]
    change = np.diff(quaternion, axis=0)
    # The vector part of conj(mean) ∘ change is half the turn, to second order.
    half = w * change[:, 1:] - v * change[:, :1] - np.cross(v, change[:, 1:])
    curvature = 2 * half / step[:, None]
    wanted = (turn @ (rod.stiffness * (curvature - rod.natural_curvature))[..., None])[..., 0]
    # m(s) = m0 − (r − r0) × n0 + ∫ σ r' dσ × w
    travel = np.diff(position, axis=0)
    middles = (mesh[1:] + mesh[:-1]) / 2
    carried = np.vstack((np.zeros(3), np.cumsum(middles[:, None] * travel, axis=0)))
    known = np.cross((carried[1:] + carried[:-1]) / 2, rod.weight)
    arm = (position[1:] + position[:-1]) / 2 - position[0]
    matrix = np.concatenate((np.broadcast_to(np.eye(3), (len(step), 3, 3)), -cross(arm)), axis=2)
    even = np.sqrt(step)[:, None]
    unknown = np.linalg.lstsq(
        (even[:, None] * matrix).reshape(-1, 6), (even * (wanted - known)).ravel(), rcond=None
    )[0]
    force = unknown[3:] - mesh[:, None] * rod.weight
    moment = unknown[:3] - np.cross(position - position[0], unknown[3:])
    return force, moment + np.cross(carried, rod.weight)
