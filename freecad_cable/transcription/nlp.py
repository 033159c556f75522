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
from .hessian import element_block
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
    """A program without numbers. ``x``, ``g``, ``f``, ``p`` are SX columns; ``energies`` is (bending,
    torsion, stretch, gravity), ``mean`` the mean position over the first element, from its first node.

    ``gaps[k]`` is the first row of gap k.
    """

    structure: Structure
    x: ca.SX
    g: ca.SX
    f: ca.SX
    p: ca.SX
    energies: ca.SX
    mean: ca.SX
    multipliers: tuple[ca.SX, ca.SX]
    """λ_f and λ, in which the next two are written"""
    hessian: ca.SX
    """of the Lagrangian λ_f f + λ·g, in x"""
    jacobian: ca.SX
    """of g, in x"""
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
        """(x, p, λ_f, λ) → nonzeros of the Hessian of λ_f f + λ·g, and of the Jacobian of the rows."""
        inputs = [self.x, self.p, *self.multipliers]
        return ca.Function("second_variation", inputs, [self.hessian.nz[:], self.jacobian.nz[:]])

    @cached_property
    def places(self):
        """(rows, columns) of the nonzeros of Hessian and Jacobian."""
        return tuple(
            tuple(np.array(index) for index in part.sparsity().get_triplet())
            for part in (self.hessian, self.jacobian)
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
    kept = list(structure.strains)
    stiffness = parameters["stiffness"][kept]
    natural = ca.vertcat(parameters["natural"], 0, 0, 0)[kept]

    def full(strain, unloaded):
        """(κ, v) from the strains that the model keeps."""
        e = ca.SX(ca.vertcat(unloaded, 0, 0, 0))
        for i, index in enumerate(kept):
            e[index] = strain[i]
        return e[:3], ca.vertcat(e[3], e[4], 1 + e[5])

    block = element_block(scheme, structure, full)
    factor = ca.SX.sym("lam_f")
    state_size = 7 + (size if scheme.STRAIN_IS_STATE else 0)
    x, g, lam, equality, gaps, sizes, blocks, jacobian = ([] for _ in range(8))
    energies = ca.SX.zeros(4)

    def add(rows):
        g.append(rows)
        lam.append(ca.SX.sym(f"lam{len(lam)}", rows.numel()))
        equality.extend([True] * rows.numel())
        return rows.numel()

    def add_held(rows):
        """Rows on a state alone, and their part of the Hessian."""
        return add(rows), ca.hessian(ca.dot(lam[-1], rows), state)[0]

    width = structure.elements * (state_size + size) + state_size

    def place(part, stage):
        """Rows over the whole x, from columns that begin at a stage."""
        before = stage * (state_size + size)
        zeros = ca.SX(part.rows(), before), ca.SX(part.rows(), width - before - part.columns())
        return ca.horzcat(zeros[0], part, zeros[1])

    state = ca.SX.sym("x0", state_size)
    for k in range(structure.elements):
        control, following = ca.SX.sym(f"u{k}", size), ca.SX.sym(f"x{k + 1}", state_size)
        x += [state, control]
        r, q = state[:3], state[3:7]
        first, last = (state[7:], control) if scheme.STRAIN_IS_STATE else (control, control)
        h = steps[k]
        screw = scheme.screw(h, *(full(e, parameters["natural"]) for e in (first, last)))
        displacement, q_next, mean = step(q, *screw)
        if k == 0:
            first_mean = mean
        parts = scheme.elastic_energy(h, stiffness, first - natural, last - natural)
        for i, index in enumerate(kept):
            energies[0 if index < 2 else 1 if index == 2 else 2] += parts[i]
        weight, origin = parameters["weight"], parameters["start_position"]
        energies[3] -= h * ca.dot(weight, r - origin + mean)
        reached = ca.vertcat(r + displacement, q_next)
        if scheme.STRAIN_IS_STATE:
            reached = ca.vertcat(reached, control)
        gaps.append(len(equality))
        add(following - reached)
        own = ca.vertcat(state, control)
        load = [parameters["stiffness"], parameters["natural"], weight, factor, lam[-1][:7]]
        hessian, reach = block(own[3:], h, *load)
        hessian, rows = ca.diagcat(ca.SX(3, 3), hessian), 0
        if k == 0:
            rows, held = add_held(ends.start_rows(structure, r, q, parameters))
            hessian += ca.diagcat(held, ca.SX(size, size))
        blocks.append(hessian)
        lead = ca.SX(state_size, own.numel())
        lead[:3, :3] = ca.SX.eye(3)
        lead[:7, 3:] = reach
        if scheme.STRAIN_IS_STATE:
            lead[7:, state_size:] = ca.SX.eye(size)
        jacobian.append(place(ca.horzcat(-lead, ca.SX.eye(state_size)), k))
        if k == 0:
            jacobian.append(place(ca.jacobian(g[-1], state), k))
        sizes.append((state_size, size, rows))
        state = following
    x.append(state)
    rows, held = add_held(ends.end_rows(structure, state[:3], state[3:7], parameters))
    blocks.append(held)
    jacobian.append(place(ca.jacobian(g[-1], state), structure.elements))
    sizes.append((state_size, 0, rows))
    return Nlp(
        structure=structure,
        x=ca.vertcat(*x),
        g=ca.vertcat(*g),
        f=ca.sum1(energies),
        p=p,
        energies=energies,
        mean=first_mean,
        multipliers=(factor, ca.vertcat(*lam)),
        hessian=ca.diagcat(*blocks),
        jacobian=ca.vertcat(*jacobian),
        equality=tuple(equality),
        gaps=tuple(gaps),
        stage_sizes=tuple(sizes),
    )
