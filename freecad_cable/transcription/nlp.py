# SPDX-License-Identifier: LGPL-2.1-or-later
"""The nonlinear program of a structure: written once (see ``writer``) and kept."""

from dataclasses import dataclass
from functools import cached_property, lru_cache

import casadi as ca
import numpy as np

from . import supports
from .element_functions import SCHEMES
from .numbering import Numbering
from .numeric import Numeric
from .structure import Structure
from .writer import PARAMETERS, Writer

__all__ = ["SCHEMES", "Nlp", "build", "pack"]


@dataclass(frozen=True)
class Nlp:
    """A program without numbers. ``x``, ``g``, ``f``, ``p`` are MX columns; ``energies`` is (bending,
    torsion, stretch, gravity), ``means`` (3, stretches) the mean position over the first element of each
    stretch, from its first node.
    """

    structure: Structure
    numbers: Numbering
    x: ca.MX
    g: ca.MX
    p: ca.MX
    energies: ca.MX
    means: ca.MX
    turns: ca.MX
    """strain times length of each element"""
    multipliers: tuple[ca.MX, ca.MX]
    """λ_f and λ, in which the next is written"""
    hessian: ca.MX
    """of the Lagrangian λ_f f + λ·g, in x"""
    jacobian: ca.MX
    """of g, in x"""
    gradient: ca.MX
    """of f, in x"""
    equality: np.ndarray
    """(rows,) bool"""
    gaps: np.ndarray
    """(n,) first row of each gap"""
    contact_rows: np.ndarray
    """(n, contacts) rows of the elements"""
    link_rows: np.ndarray
    """(links,) rows that keep the rod away from itself"""
    stage_sizes: tuple[tuple[int, int, int], ...]
    """(nx, nu, ng) of each stage"""

    @property
    def f(self):
        return ca.sum1(self.energies)

    @cached_property
    def energy_function(self):
        return Numeric(ca.Function("energies", [self.x, self.p], [self.energies]))

    @cached_property
    def mean_function(self):
        return Numeric(ca.Function("means", [self.x, self.p], [self.means]))

    @cached_property
    def rows_function(self):
        return Numeric(ca.Function("rows", [self.x, self.p], [self.g]))

    @cached_property
    def second_variation(self):
        """(x, p, λ_f, λ) → nonzeros of the Hessian of λ_f f + λ·g, and of the Jacobian of the rows."""
        inputs = [self.x, self.p, *self.multipliers]
        outputs = [self.hessian.nz[:], self.jacobian.nz[:]]
        return Numeric(ca.Function("second_variation", inputs, outputs))

    @cached_property
    def places(self):
        """(rows, columns) of the nonzeros of Hessian and Jacobian."""
        return tuple(
            tuple(np.array(index) for index in part.sparsity().get_triplet())
            for part in (self.hessian, self.jacobian)
        )

    @cached_property
    def row_starts(self) -> np.ndarray:
        """(n+2,) first row of each stage, and the first after them. A stage begins with its gap, which has the size of
        the next state."""
        nx, _, ng = zip(*self.stage_sizes, strict=True)
        return np.concatenate([[0], np.cumsum(np.append(nx[1:], 0) + ng)])

    @cached_property
    def carried(self) -> np.ndarray:
        """(n, 7) rows in which position and quaternion go from a node to the next"""
        return self.gaps[:, None] + np.arange(7)

    @cached_property
    def strains_carried(self) -> np.ndarray:
        """(rows,) which of the kept strains, from 1 on, a row carries to the next state; 0 for other rows"""
        found = np.zeros(len(self.equality), int)
        states = self.states[1:]
        found[self.gaps[:, None] + np.arange(states.shape[1])] = self.numbers.strain_of[states] + 1
        return found

    @property
    def states(self) -> np.ndarray:
        """(n+1, nx) indices into x"""
        return self.numbers.states


def pack(structure, values, steps):
    """Named parameters and element lengths (n,) → parameter vector of the program."""
    if structure.slides:
        starts = np.concatenate([[0], np.cumsum(structure.stretches)[:-1]])
        steps = steps / np.repeat(np.add.reduceat(steps, starts), structure.stretches)
    named = [np.ravel(values[name]) for name in PARAMETERS]
    held = [np.ravel(each[name]) for each in values["supports"] for name in supports.PARAMETERS]
    arms = [np.ravel(values["arms"])] if structure.contacts else []
    links = [np.ravel(values["links"].parameters)] if structure.links else []
    return np.concatenate([*named, *held, steps, *arms, *links])


@lru_cache(maxsize=64)
def build(structure: Structure) -> Nlp:
    """Write the program of a structure; it is kept."""
    writer = Writer(structure)
    return Nlp(
        structure=structure,
        numbers=writer.numbers,
        x=writer.x,
        g=writer.g,
        p=writer.p,
        energies=writer.energies,
        means=writer.means,
        turns=writer.turns,
        multipliers=(writer.factor, writer.multipliers),
        hessian=writer.hessian,
        jacobian=writer.jacobian,
        gradient=writer.gradient,
        equality=np.array(writer.equality),
        gaps=writer.gaps,
        contact_rows=np.array(writer.contact_rows, int),
        link_rows=writer.link_rows,
        stage_sizes=tuple(writer.stage_sizes),
    )
