# SPDX-License-Identifier: LGPL-2.1-or-later
"""The nonlinear program of a structure: written once (see ``writer``) and kept."""

from dataclasses import dataclass
from functools import cached_property, lru_cache

import casadi as ca
import numpy as np

from . import supports
from .structure import Structure
from .writer import PARAMETERS, SCHEMES, Writer

__all__ = ["SCHEMES", "Nlp", "build", "pack"]


@dataclass(frozen=True)
class Nlp:
    """A program without numbers. ``x``, ``g``, ``f``, ``p`` are SX columns; ``energies`` is (bending,
    torsion, stretch, gravity), ``means`` (3, stretches) the mean position over the first element of each
    stretch, from its first node.

    ``gaps[k]`` is the first row of gap k, ``held[j]`` the rows of support j.
    """

    structure: Structure
    x: ca.SX
    g: ca.SX
    f: ca.SX
    p: ca.SX
    energies: ca.SX
    means: ca.SX
    multipliers: tuple[ca.SX, ca.SX]
    """λ_f and λ, in which the next two are written"""
    hessian: ca.SX
    """of the Lagrangian λ_f f + λ·g, in x"""
    jacobian: ca.SX
    """of g, in x"""
    equality: tuple[bool, ...]
    gaps: tuple[int, ...]
    contact_rows: np.ndarray
    """(n+1, contacts) rows; −1 at nodes that are held"""
    held: tuple[range, ...]
    stage_sizes: tuple[tuple[int, int, int], ...]
    """(nx, nu, ng) of each stage"""
    strain_of: np.ndarray
    """(len x,) which of the kept strains a variable is; −1 for others"""

    @cached_property
    def energy_function(self):
        return ca.Function("energies", [self.x, self.p], [self.energies])

    @cached_property
    def mean_function(self):
        return ca.Function("means", [self.x, self.p], [self.means])

    @cached_property
    def rows_function(self):
        return ca.Function("rows", [self.x, self.p], [self.g])

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

    @cached_property
    def states(self) -> np.ndarray:
        """(n+1, nx) indices into x"""
        sizes = np.array(self.stage_sizes)
        begin = np.concatenate([[0], np.cumsum(sizes[:-1, 0] + sizes[:-1, 1])])
        return begin[:, None] + np.arange(sizes[0, 0])


def pack(structure, values, steps):
    """Named parameters and element lengths (n,) → parameter vector of the program."""
    if structure.slides:
        starts = np.concatenate([[0], np.cumsum(structure.stretches)[:-1]])
        steps = steps / np.repeat(np.add.reduceat(steps, starts), structure.stretches)
    named = [np.ravel(values[name]) for name in PARAMETERS]
    held = [np.ravel(each[name]) for each in values["supports"] for name in supports.PARAMETERS]
    features = [np.ravel(values["features"])] if structure.contacts else []
    return np.concatenate([*named, *held, steps, *features])


@lru_cache(maxsize=64)
def build(structure: Structure) -> Nlp:
    """Write the program of a structure. Costs some 0.1 s and is kept."""
    writer = Writer(structure)
    writer.write()
    return Nlp(
        structure=structure,
        x=ca.vertcat(*writer.x),
        g=ca.vertcat(*writer.g),
        f=ca.sum1(writer.energies),
        p=writer.parameters,
        energies=writer.energies,
        means=ca.horzcat(*writer.means),
        multipliers=(writer.factor, ca.vertcat(*writer.multipliers)),
        hessian=ca.diagcat(*writer.hessian),
        jacobian=ca.vertcat(*writer.jacobian),
        equality=tuple(writer.equality),
        gaps=tuple(writer.gaps),
        contact_rows=np.array(
            [
                np.full(structure.contacts, -1) if rows is None else rows
                for rows in writer.contact_rows
            ]
        ),
        held=tuple(writer.held_rows),
        stage_sizes=tuple(writer.sizes),
        strain_of=writer.strain_of(),
    )
