# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rows of the stages that ends and supports hold, as functions with their derivatives."""

from dataclasses import dataclass
from functools import lru_cache

import casadi as ca
import numpy as np

from . import ends, supports
from .element import upper
from .numbering import Numbering
from .structure import Structure

SHORTEST = 1e-3
"""Length of a stretch, relative to the cable, below which no support slides: there the cable slips out of it."""


@dataclass(frozen=True)
class Held:
    """Rows of one stage: functions of its variables (indices into x) and of parameters, equations before bounds."""

    functions: tuple[ca.Function, ca.Function, ca.Function]
    """see ``_derived``"""
    variables: np.ndarray
    parameters: ca.MX
    equations: int
    bounds: int


@lru_cache(maxsize=16)
def bounds(gap, variables: int, parameters: int):
    """``_derived`` of a bound gap(v, p) ≥ 0."""
    v, p = ca.SX.sym("v", variables), ca.SX.sym("p", parameters)
    return _derived(gap(v, p), v, p, ca.SX.sym("lam"))


def _derived(rows, v, p, lam):
    """Functions (v, p) → rows, (v, p) → their Jacobian, (v, p, λ) → upper triangle of the Hessian of λ·rows; the
    last two dense columns."""
    slope, bent = ca.jacobian(rows, v), ca.hessian(ca.dot(lam, rows), v)[0]
    return (
        ca.Function("rows", [v, p], [rows]),
        ca.Function("slope", [v, p], [ca.densify(ca.vec(slope))]),
        ca.Function("bent", [v, p, lam], [upper(bent)]),
    )


def holders(structure: Structure, numbers: Numbering, start, end, held) -> dict[int, Held]:
    """What holds each held stage. ``start``, ``end`` and each of ``held`` (the supports) are their parameters."""
    nx, last = numbers.nx, structure.elements
    found = {
        0: _held(numbers.states[0], start, lambda v, p: _start(structure, nx, v, p)),
        last: _held(numbers.states[last], end, lambda v, p: _end(structure, nx, v, p)),
    }
    for j, node in enumerate(structure.joints):
        beyond = [numbers.stretch[node]] if structure.slides else []
        variables = np.concatenate([numbers.states[node], beyond]).astype(int)
        found[node] = _held(variables, held[j], lambda v, p, j=j: _support(structure, j, nx, v, p))
    return {stage: each for stage, each in found.items() if each.equations + each.bounds}


def bend_left(kappa, limit):
    """About the curvature that is left to the limit."""
    return (limit - ca.sumsqr(kappa) / limit) / 2


def _held(variables, parameters, write) -> Held:
    v, p = ca.SX.sym("v", len(variables)), ca.SX.sym("p", parameters.numel())
    equations, bounds = (ca.SX(ca.vertcat(*rows)) for rows in write(v, p))
    rows = ca.vertcat(equations, bounds)
    functions = _derived(rows, v, p, ca.SX.sym("lam", rows.numel()))
    return Held(functions, variables, parameters, equations.numel(), bounds.numel())


def _start(structure, nx, v, p):
    values = {"start_position": p[:3], "start_quaternion": p[3:]}
    rows = [ends.start_rows(structure, v[:3], v[3:7], values)]
    if not structure.slides:
        return rows, []
    return [*rows, v[nx - 1]], [v[nx - 2] - SHORTEST] if structure.sliding[0] else []


def _end(structure, nx, v, p):
    values = {"end_position": p[:3], "end_quaternion": p[3:]}
    rows = [ends.end_rows(structure, v[:3], v[3:7], values)]
    return rows + ([v[nx - 1] + v[nx - 2] - 1] if structure.slides else []), []


def _support(structure, j, nx, v, p):
    offsets = np.concatenate([[0], np.cumsum([*supports.PARAMETERS.values()])])
    values = dict(zip(supports.PARAMETERS, ca.vertsplit(p, offsets.tolist()), strict=True))
    kind = structure.supports[j]
    rows = [supports.equations(kind, v[:3], v[3:7], values)]
    bounds = [supports.play_left(kind, v[:3], values)]
    if structure.slides:
        if any(structure.sliding[j : j + 2]):
            bounds.append(v[nx] - SHORTEST)
        if not structure.sliding[j]:
            rows.append(v[nx - 1] + v[nx - 2] - values["arc_length"])
    return rows, bounds
