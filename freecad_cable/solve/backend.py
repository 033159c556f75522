# SPDX-License-Identifier: LGPL-2.1-or-later
"""CasADi's interior-point solvers: fatrop (structured, Riccati) and ipopt (general, MUMPS).

The only file that spells a solver's options or return strings.
"""

import contextlib
import io
import time
from dataclasses import dataclass
from functools import lru_cache

import casadi as ca
import numpy as np

from ..transcription.nlp import Nlp, build
from ..transcription.numeric import Numeric
from ..transcription.structure import Structure
from .yielding import MORE_RIGID, RIGID, RUNAWAY, SHARE, YieldingProgram, derivatives

TOLERANCE = 1e-9
"""On the scaled optimality conditions. Far below the discretisation error of any mesh used here (1e-8 at
best), far above rounding in the multipliers of a taut cable (1e-16 × 1e5). 1e-6 would save one iteration of six, but
where solutions make a circle their neutral direction then reads as a falling one, and a good answer as unstable."""
ITERATIONS = 80
"""Those that converge from a usable start were seen to need at most 45."""

LONGEST = 5.0
"""Time of one run of ipopt [s]: on fine meshes its matrices can fill, and the time limit of a solve is looked at
between runs."""

NEAR = {"mu_init": 1e-7, "bound_push": 1e-8}
"""fatrop's options for a start that is nearly the solution: with its usual ones it first pushes the start away from the
bounds that act (measured: two sliding supports dragged take 4 iterations instead of 14)."""

NEARBY = {"mu_init": 1e-6, "bound_push": 1e-4}
"""Where obstacles are near: first barrier parameter, and how far from a bound the start is moved. The defaults of 0.1
and 0.01 push a cable away from all obstacles as hard as it resists bending, and lose the start."""

STEADY = {
    "linsol_lu_fact_tol": 1e-4,
    "linsol_increased_accuracy": False,
    "watchdog_shortened_iter_trigger": 0,
    "theta_max_fact": 100.0,
}
"""fatrop 1.1.8 corrects a matrix that is not positive definite without a limit, and no time limit ends that. Its
defaults brought it there with sliding supports, whose equations it satisfies by strains on which they hardly depend,
by trial steps of its watchdog to nodes at 1e40, and by a step to gaps of 1e4 lengths, the most that they let pass, of a
cable that was four times as long as its way. For the rest see ``yielding``."""

EXACT = 2e-9
"""Yield of what holds the cable, relative to the length, above which fatrop is asked once more."""
CORRECTIONS = 5
"""Times that it is asked once more; each leaves a small share of the yield."""


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
        form = yielding(structure)
        nx, nu, ng = form.stage_sizes
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
                **STEADY,
                **(NEARBY if structure.contacts else {}),
                **(NEAR if near else {}),
            },
        }
        options["cache"] = form.derivatives
        return Numeric(ca.nlpsol("rod_fatrop", name, form.program, options))
    options["ipopt"] = {
        "print_level": 0,
        "sb": "yes",
        "tol": TOLERANCE,
        "max_iter": ITERATIONS,
        "max_wall_time": LONGEST,
        **({"mu_init": NEARBY["mu_init"]} if structure.links else {}),
    }
    options["cache"] = derivatives(
        [nlp.x, nlp.p, *nlp.multipliers],
        slope={"f": nlp.f, "grad_f_x": nlp.gradient},
        rows={"g": nlp.g, "jac_g_x": nlp.jacobian},
        bent={"triu_hess_gamma_x_x": ca.triu(nlp.hessian)},
    )
    program = {"x": nlp.x, "g": nlp.g, "f": nlp.f, "p": nlp.p}
    return Numeric(ca.nlpsol("rod_ipopt", name, program, options))


@lru_cache(maxsize=128)
def yielding(structure: Structure) -> YieldingProgram:
    """fatrop's form of the program of a structure; it is kept."""
    return YieldingProgram(build(structure))


def first_use(structure: Structure, name: str, near: bool) -> float:
    """Make the solver if it is not there yet; the time this took [s]."""
    begin = time.perf_counter()
    built(structure, name, near)
    return time.perf_counter() - begin


def minimise(
    nlp: Nlp, name: str, near: bool, x0, parameters, multipliers, hasty=False
) -> RawSolution:
    """Solve from ``x0`` and multipliers (both warm or both cold). ``hasty``: what fails is not tried less rigidly."""
    solver = built(nlp.structure, name, near)
    upper = np.where(nlp.equality, 0.0, np.inf)
    iterations, begin = 0, time.perf_counter()

    def asked(start, given, known):
        nonlocal iterations
        # What CasADi has to say of a failure, the status says too.
        with contextlib.redirect_stderr(io.StringIO()):
            x, *_, lam, _ = solver(x0=start, lam_g0=known, p=given, lbg=0.0, ubg=upper)
        stats = solver.stats()
        iterations += int(stats["iter_count"])
        return bool(stats["success"]), x, lam

    if name == "ipopt":
        success, x, multipliers = asked(x0, parameters, multipliers)
    else:
        form = yielding(nlp.structure)
        units = form.units(parameters)
        if multipliers.any():
            multipliers = multipliers.copy()
            multipliers[form.rows] = form.prices(x0, parameters, multipliers)
        begun = form.start(x0, multipliers, units)
        for rigidity in RIGID[:1] if hasty else RIGID:
            success, found, known = _held(form, asked, parameters, units, *begun, rigidity)
            if success:
                break
        x, multipliers = form.read(found, known, units)
    return RawSolution(
        x=x,
        multipliers=multipliers,
        success=success and bool(np.abs(x).max() < RUNAWAY),
        iterations=iterations,
        time=time.perf_counter() - begin,
        solver=name,
    )


def _held(form, asked, parameters, units, found, known, rigidity):
    """(success, decision vector, multipliers) of a yielding program, asked until next to nothing yields."""
    before = np.inf
    for _ in range(1 + CORRECTIONS):
        given = form.parameters(parameters, known, units, rigidity)
        success, found, known = asked(found, given, known)
        left = np.abs(found[form.yields]).max(initial=0.0)
        if not success or left < EXACT:
            break
        if left > SHARE * before:
            rigidity *= MORE_RIGID
        before = left
    return success, found, known
