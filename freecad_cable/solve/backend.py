# SPDX-License-Identifier: LGPL-2.1-or-later
"""CasADi's interior-point solvers: fatrop (structured, Riccati) and ipopt (general, MUMPS).

The only file that spells a solver's options or return strings.
"""

import time
from dataclasses import dataclass
from functools import lru_cache

import casadi as ca
import numpy as np

from ..transcription.nlp import Nlp, build
from ..transcription.structure import Structure

TOLERANCE = 1e-9
"""On the scaled optimality conditions. Far below the discretisation error of any mesh used here (1e-8 at
best), far above rounding in the multipliers of a taut cable (1e-16 × 1e5)."""
ITERATIONS = 80
"""Those that converge from a usable start were seen to need at most 45."""

NEAR = {"mu_init": 1e-7, "bound_push": 1e-8}
"""fatrop's options for a start that is nearly the solution: with its usual ones it first pushes the start away from the
bounds that act (measured: two sliding supports dragged take 4 iterations instead of 14)."""

NEARBY = {"mu_init": 1e-6, "bound_push": 1e-4}
"""Where obstacles are near: first barrier parameter, and how far from a bound the start is moved. The defaults of 0.1
and 0.01 push a cable away from all obstacles as hard as it resists bending, and lose the start."""

WITHOUT_HANGING = {
    "linsol_lu_fact_tol": 1e-4,
    "linsol_increased_accuracy": False,
    "watchdog_shortened_iter_trigger": 0,
}
"""fatrop 1.1.8 corrects a matrix that is not positive definite without a limit. Its defaults brought it there in two
ways, and no time limit ends that: a condition of a support eliminated by one strain, on which it hardly depends (the
pivot is about h²; below 1e-4 it is left to the element before), and trial steps of the watchdog to nodes at 1e40."""

RUNAWAY = 1e6
"""Positions in lengths, or strains per length, that no cable has."""


@dataclass(frozen=True)
class RawSolution:
    """What a back end says: decision vector, multipliers of the rows, success, iterations, time [s]."""

    x: np.ndarray
    multipliers: np.ndarray
    success: bool
    iterations: int
    time: float
    solver: str


@lru_cache
def available(name: str) -> bool:
    """Whether this CasADi has the plug-in."""
    return ca.has_nlpsol(name)


@lru_cache(maxsize=128)
def built(structure: Structure, name: str, near: bool = False):
    """Solver of a structure; the same one for every scene that shares it. ``near``: for starts from a solution."""
    nlp = build(structure)
    options = {
        "print_time": False,
        "record_time": True,
        "error_on_fail": False,
        "show_eval_warnings": False,
    }
    if name == "fatrop":
        nx, nu, ng = (list(column) for column in zip(*nlp.stage_sizes, strict=True))
        options |= {
            "structure_detection": "manual",
            "N": structure.elements,
            "nx": nx,
            "nu": nu,
            "ng": ng,
            "equality": nlp.equality.tolist(),
            "fatrop": {
                "print_level": 0,
                "tol": TOLERANCE,
                "max_iter": ITERATIONS,
                **WITHOUT_HANGING,
                **(NEARBY if structure.contacts else {}),
                **(NEAR if near else {}),
            },
        }
    else:
        options["ipopt"] = {
            "print_level": 0,
            "sb": "yes",
            "tol": TOLERANCE,
            "max_iter": ITERATIONS,
            **({"mu_init": NEARBY["mu_init"]} if structure.links else {}),
        }
    options["cache"] = _derivatives(nlp, name)
    program = {"x": nlp.x, "g": nlp.g, "f": nlp.f, "p": nlp.p}
    return ca.nlpsol(f"rod_{name}", name, program, options)


def _derivatives(nlp: Nlp, name: str) -> dict:
    """Our derivatives in place of those that CasADi would make, under the names and in the form that the
    plug-ins ask for."""
    inputs, names = [nlp.x, nlp.p, *nlp.multipliers], ["x", "p", "lam_f", "lam_g"]
    slope = {"grad_f_x": nlp.gradient}
    if name == "ipopt":
        bent = {"triu_hess_gamma_x_x": ca.triu(nlp.hessian)}
        slope = {"f": nlp.f} | slope
    else:
        # The plug-in's form has a gradient, which it never reads.
        bent = {"grad_gamma_x": ca.MX(nlp.x.numel(), 1), "hess_gamma_x_x": nlp.hessian}
    rows = {"g": nlp.g, "jac_g_x": nlp.jacobian}

    def function(title, count, outputs):
        return ca.Function(
            title, inputs[:count], list(outputs.values()), names[:count], list(outputs)
        )

    return {
        "nlp_grad_f": function("nlp_grad_f", 2, slope),
        "nlp_jac_g": function("nlp_jac_g", 2, rows),
        "nlp_hess_l": function("nlp_hess_l", 4, bent),
    }


def first_use(structure: Structure, name: str, near: bool) -> float:
    """Make the solver if it is not there yet; the time this took [s]."""
    begin = time.perf_counter()
    built(structure, name, near)
    return time.perf_counter() - begin


def minimise(nlp: Nlp, name: str, near: bool, x0, parameters, multipliers) -> RawSolution:
    """Solve from ``x0`` and multipliers (both warm or both cold)."""
    solver = built(nlp.structure, name, near)
    upper = np.where(nlp.equality, 0.0, np.inf)
    begin = time.perf_counter()
    answer = solver(x0=x0, lam_g0=multipliers, p=parameters, lbg=0.0, ubg=upper)
    elapsed = time.perf_counter() - begin
    stats = solver.stats()
    x = answer["x"].full().ravel()
    return RawSolution(
        x=x,
        multipliers=answer["lam_g"].full().ravel(),
        success=bool(stats["success"]) and bool(np.abs(x).max() < RUNAWAY),
        iterations=int(stats["iter_count"]),
        time=elapsed,
        solver=name,
    )
