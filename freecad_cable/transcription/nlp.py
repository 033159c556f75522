# SPDX-License-Identifier: LGPL-2.1-or-later
"""The nonlinear program of a structure, in the stage order that fatrop wants.

Variables x₀ u₀ x₁ u₁ … x_N, rows gap₀ rows₀ gap₁ … rows_N, with gap_k = x_{k+1} − F(x_k, u_k):

    state x    position (3), quaternion (4), and with a scheme whose strain is continuous the strain (m)
    control u  the strain of the element (m), or the strain at its far node (m)

The gap keeps the sign that makes its multipliers the internal force and (through the quaternion) moment.
"""

from dataclasses import dataclass
from functools import cached_property, lru_cache

import casadi as ca
import numpy as np

from . import ends, helix, magnus
from .element import step
from .structure import Structure

SCHEMES = {"helix": helix, "magnus": magnus}

PARAMETERS = {
    "stiffness": 6,
    "natural": 3,
    "weight": 3,
    "start_position": 3,
    "start_quaternion": 4,
    "end_position": 3,
    "end_quaternion": 4,
}
"""Sizes of the parameters beside the element lengths, all without units (see ``scaling``)."""


@dataclass(frozen=True)
class Nlp:
    """A program without numbers. ``x``, ``g``, ``f``, ``p`` are SX columns; ``energies`` is (bending, torsion, stretch, gravity),
    ``mean`` the mean position over the first element, from its first node.

    ``gaps[k]`` is the first row of gap k, ``states[k]`` and ``controls[k]`` the slices of x.
    """

    structure: Structure
    x: ca.SX
    g: ca.SX
    f: ca.SX
    p: ca.SX
    energies: ca.SX
    mean: ca.SX
    equality: tuple[bool, ...]
    gaps: tuple[int, ...]
    stage_sizes: tuple[tuple[int, int, int], ...]
    """(nx, nu, ng) of each stage"""

    @cached_property
    def energy_function(self):
        return ca.Function("energies", [self.x, self.p], [self.energies])

    @cached_property
    def first_mean(self):
        return ca.Function("first_mean", [self.x, self.p], [self.mean])

    @cached_property
    def second_variation(self):
        """(x, p, λ) → (Hessian of the Lagrangian, Jacobian of the rows)."""
        multipliers = ca.SX.sym("lam", self.g.numel())
        hessian, _ = ca.hessian(self.f + ca.dot(multipliers, self.g), self.x)
        return ca.Function(
            "second_variation", [self.x, self.p, multipliers], [hessian, ca.jacobian(self.g, self.x)]
        )

    def split(self, x):
        """Decision vector → states [(nx,)] and controls [(nu,)], lists over stages."""
        states, controls, i = [], [], 0
        for nx, nu, _ in self.stage_sizes:
            states.append(x[i : i + nx])
            controls.append(x[i + nx : i + nx + nu])
            i += nx + nu
        return states, controls


def pack(values, steps):
    """Named parameters and element lengths (n,) → parameter vector of the program."""
    return np.concatenate([np.ravel(values[name]) for name in PARAMETERS] + [steps])


def _named(structure):
    symbols = {name: ca.SX.sym(name, size) for name, size in PARAMETERS.items()}
    steps = ca.SX.sym("h", structure.elements)
    return symbols, steps, ca.vertcat(*symbols.values(), steps)


@lru_cache(maxsize=64)
def build(structure: Structure) -> Nlp:
    """Write the program of a structure. Costs some 0.1 s and is kept."""
    scheme = SCHEMES[structure.scheme]
    size = len(structure.strains)
    parameters, steps, p = _named(structure)
    rest = ca.vertcat(parameters["natural"], 0, 0, 0)
    kept = list(structure.strains)
    stiffness = parameters["stiffness"][kept]

    def full(strain):
        """(κ, v) from the strains that the model keeps."""
        e = ca.SX(rest)
        for i, index in enumerate(kept):
            e[index] = strain[i]
        return e[:3], ca.vertcat(e[3], e[4], 1 + e[5])

    state_size = 7 + (size if scheme.STRAIN_IS_STATE else 0)
    x, g, equality, gaps, sizes = [], [], [], [], []
    energies = ca.SX.zeros(4)

    def add(rows, is_equality=True):
        g.append(rows)
        equality.extend([is_equality] * rows.numel())
        return rows.numel()

    state = ca.SX.sym("x0", state_size)
    for k in range(structure.elements):
        control, following = ca.SX.sym(f"u{k}", size), ca.SX.sym(f"x{k + 1}", state_size)
        x += [state, control]
        r, q = state[:3], state[3:7]
        first, last = (state[7:], control) if scheme.STRAIN_IS_STATE else (control, control)
        h = steps[k]
        displacement, q_next, mean = step(q, *scheme.screw(h, full(first), full(last)))
        if k == 0:
            first_mean = mean
        parts = scheme.elastic_energy(h, stiffness, first - rest[kept], last - rest[kept])
        for i, index in enumerate(kept):
            energies[0 if index < 2 else 1 if index == 2 else 2] += parts[i]
        energies[3] -= h * ca.dot(
            parameters["weight"], r - parameters["start_position"] + mean
        )
        reached = ca.vertcat(r + displacement, q_next)
        if scheme.STRAIN_IS_STATE:
            reached = ca.vertcat(reached, control)
        gaps.append(len(equality))
        add(following - reached)
        rows = add(ends.start_rows(structure, r, q, parameters)) if k == 0 else 0
        sizes.append((state_size, size, rows))
        state = following
    x.append(state)
    sizes.append((state_size, 0, add(ends.end_rows(structure, state[:3], state[3:7], parameters))))
    return Nlp(
        structure=structure,
        x=ca.vertcat(*x),
        g=ca.vertcat(*g),
        f=ca.sum1(energies),
        p=p,
        energies=energies,
        mean=first_mean,
        equality=tuple(equality),
        gaps=tuple(gaps),
        stage_sizes=tuple(sizes),
    )
