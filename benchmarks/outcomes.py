# SPDX-License-Identifier: LGPL-2.1-or-later
"""How extreme scenes end: each solved once, in a process that is ended if it does not come back."""

import time
from collections.abc import Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack
from dataclasses import dataclass, replace
from queue import Queue

from benchmarks.cases import TABLE_1
from benchmarks.exact import ANOTHER, Branch
from benchmarks.extreme import Extreme
from benchmarks.guarded import Guarded
from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.options import SolveOptions
from freecad_cable.result import Solution

TIME_LIMIT = 10.0
"""[s] of one solve, its building included"""
PATIENCE = 1.5 * TIME_LIMIT
"""[s] after which its process is ended"""
SIDE_BY_SIDE = 2
"""Scenes solved at a time: how they end is asked here, and their times are only for orientation"""
TRUTH_PATIENCE = 3.0
"""[s] for the strong form; where it takes longer, layers or many turns, it mostly fails in the end"""


@dataclass(frozen=True)
class Outcome:
    """One run of one scene; times in seconds, errors relative to the length."""

    family: str
    row: str
    column: str
    status: str
    message: str = ""
    seconds: float | None = None
    """without the building of solvers, as far as it is known: not where a time limit struck"""
    build: float | None = None
    iterations: int | None = None
    elements: int | None = None
    estimate: float | None = None
    error: float | None = None
    """true; none where the strong form has no solution near, or is not asked"""
    balance_moment: float | None = None
    """residual of the independent check, relative to the largest moment"""
    balance_force: float | None = None


def outcomes(scenes: Iterable[Extreme], every: int) -> Iterator[Outcome]:
    """A row for each, in order; the true error of one in ``every``."""
    limited = SolveOptions(time_limit=TIME_LIMIT)
    first = (TABLE_1[0].scene,)
    known, idle = (find_equilibrium(*first),), Queue()

    def one(numbered):
        count, extreme = numbered
        extreme = replace(extreme, scene=replace(extreme.scene, options=limited))
        solve, truth = idle.get()
        try:
            solve.ready()
            return outcome(extreme, solve, None if count % every else truth)
        finally:
            idle.put((solve, truth))

    with ExitStack() as stack, ThreadPoolExecutor(SIDE_BY_SIDE) as threads:
        for _ in range(SIDE_BY_SIDE):
            solve = stack.enter_context(Guarded(find_equilibrium, PATIENCE, first))
            truth = stack.enter_context(Guarded(true_error, TRUTH_PATIENCE, known))
            idle.put((solve, truth))
        yield from threads.map(one, enumerate(scenes))


def outcome(extreme: Extreme, solve=find_equilibrium, truth=None) -> Outcome:
    """``solve`` finds the equilibrium, ``truth`` the true error of one; those that may hang want to be guarded."""
    scene = extreme.scene
    row = Outcome(extreme.family, extreme.row, extreme.column, "")
    row, solution = answered(row, scene, solve)
    if solution is None:
        return row
    said = solution.solver
    row = replace(row, build=said.get("build_time", 0.0), iterations=said.get("iterations"))
    if solution.position is None:
        return row
    return replace(
        row,
        estimate=solution.position_error / scene.rod.length,
        error=_known(truth, solution),
        balance_moment=solution.balance.moment,
        balance_force=solution.balance.force,
    )


def answered(row, scene, solve):
    """(row, solution or None): how it ended, with what mesh, and how long it took without building solvers."""
    begin = time.perf_counter()
    try:
        solution = solve(scene)
    except Exception as error:  # noqa: BLE001  Whatever goes wrong with a problem is its row.
        seconds = time.perf_counter() - begin
        failed = {"status": type(error).__name__, "message": str(error), "seconds": seconds}
        return replace(row, **failed), None
    seconds = time.perf_counter() - begin
    row = replace(
        row,
        status=solution.status.name,
        message=solution.message,
        seconds=seconds - solution.solver.get("build_time", 0.0),
        elements=solution.solver.get("elements"),
    )
    return row, solution


def _known(truth, solution):
    if truth is None or not solution.status.success:
        return None
    try:
        return truth(solution)
    except Exception:  # noqa: BLE001  The strong form may not know either.
        return None


def true_error(solution: Solution) -> float | None:
    """Relative to the length; none if the strong form leads to another equilibrium. Errors: ``NoSolutionError``."""
    length = solution.scene.rod.length
    enough = max(1e-10, solution.position_error / length / 100)
    error = Branch.near(solution, enough).distance(solution) / length
    return error if error < ANOTHER else None


def failed(row: Outcome) -> bool:
    """Neither a verified stable equilibrium to the tolerance nor a named infeasibility."""
    return row.status not in ("CONVERGED", "INFEASIBLE")
