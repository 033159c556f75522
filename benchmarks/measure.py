# SPDX-License-Identifier: LGPL-2.1-or-later
"""One problem, one row. A failure is a row as well.

Times are wall-clock seconds of ``find_equilibrium`` as a whole unless named otherwise. Of repeats the least
counts: other work on the machine only ever adds time.
"""

import math
import time
from dataclasses import dataclass, replace

from benchmarks.cases import Case, moved
from benchmarks.exact import Exact
from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.options import SolveOptions
from freecad_cable.problem import Scene
from freecad_cable.problem.reduce import reduce
from freecad_cable.result import Solution
from freecad_cable.solve.problem import Problem
from freecad_cable.transcription.nlp import build

REPEATS = 4


@dataclass(frozen=True)
class Work:
    """What one answer cost and how good it is; lengths relative to the cable's, times in seconds."""

    case: str
    scheme: str
    solver: str
    tolerance: float
    status: str = ""
    message: str = ""
    first: float | None = None
    """the first run, with the building of solvers that no earlier row has built"""
    build: float | None = None
    """the building in it"""
    cold: float | None = None
    """without building"""
    warm: float | None = None
    """without building, after a drag step, from the solution before it"""
    iterations: int | None = None
    warm_iterations: int | None = None
    elements: int | None = None
    error: float | None = None
    """true: largest distance of a node from its exact place"""
    estimate: float | None = None
    energy_error: float | None = None
    """against the exact energy, relative to its parts without their signs"""
    energy: float | None = None
    """[J]"""
    equilibrium: int | None = None
    """which one of the case, in the order in which they were met, from 0"""


def works(case: Case, wanted: list[SolveOptions], known: Exact) -> list[Work]:
    """A row for each of the options. Repeats go round all of them, so that what else the machine does
    for some seconds falls on no row alone."""
    rows = [work(case, options, known) for options in wanted]
    for _ in range(REPEATS - 1):
        again = [work(case, options, known) for options in wanted]
        rows = [_quicker(*pair) for pair in zip(rows, again, strict=True)]
    return rows


def _quicker(row, other):
    if row.status != other.status:
        return row
    times = {name: (getattr(row, name), getattr(other, name)) for name in ("cold", "warm")}
    return replace(row, **{name: min(pair) for name, pair in times.items() if None not in pair})


def work(case: Case, options: SolveOptions, known: Exact) -> Work:
    """One row, nothing repeated."""
    row = Work(case.name, options.scheme, options.solver, options.tolerance)
    try:
        return _work(row, case.solved_with(options), known)
    except Exception as error:  # noqa: BLE001  Whatever goes wrong with a problem is its row.
        return replace(row, status=type(error).__name__, message=str(error))


def _work(row, scene, known):
    solution, first = _timed(scene)
    row = replace(row, status=solution.status.name, message=solution.message, first=first)
    if solution.position is None:
        return row
    length = scene.rod.length
    row = replace(
        row,
        build=solution.solver["build_time"],
        cold=first - solution.solver["build_time"],
        iterations=solution.solver["iterations"],
        elements=solution.solver["elements"],
        estimate=solution.position_error / length,
        energy=solution.energy.total,
    )
    warm, seconds = _timed(moved(scene), solution)
    if warm.status.success or not solution.status.success:
        seconds -= warm.solver["build_time"]
        row = replace(row, warm=seconds, warm_iterations=warm.solver["iterations"])
    else:
        row = replace(row, message=f"{row.message} The drag step: {warm.message}")
    place, exact = known.near(row.case, solution)
    parts = exact.state.energy
    size = abs(parts.bending) + abs(parts.torsion) + abs(parts.gravity)
    return replace(
        row,
        error=exact.distance(solution) / length,
        energy_error=abs(solution.energy.total - parts.total) / size,
        equilibrium=place,
    )


def _timed(scene, start=None) -> tuple[Solution, float]:
    begin = time.perf_counter()
    solution = find_equilibrium(scene, start=start)
    return solution, time.perf_counter() - begin


@dataclass(frozen=True)
class Race:
    """The least times [s] of many solves on one uniform mesh."""

    case: str
    scheme: str
    solver: str
    elements: int
    status: str
    in_solver: float
    """in the solver alone"""
    whole: float


def race(cases: tuple[Case, ...], scheme: str, elements: int, rounds: int) -> list[Race]:
    """fatrop and ipopt in turns, so that both see the same machine."""
    rows = {}
    for _ in range(rounds):
        for case in cases:
            for solver in ("fatrop", "ipopt"):
                options = SolveOptions(scheme=scheme, solver=solver, elements=elements)
                solution, whole = _timed(case.solved_with(options))
                status, spent = solution.status.name, solution.solver.get("solve_time", math.nan)
                row = Race(case.name, scheme, solver, elements, status, spent, whole)
                old = rows.get((case.name, solver), row)
                rows[case.name, solver] = replace(
                    row,
                    in_solver=min(row.in_solver, old.in_solver),
                    whole=min(row.whole, old.whole),
                )
    return list(rows.values())


@dataclass(frozen=True)
class Mesh:
    """One uniform mesh of a case, solved by fatrop; errors relative to the length, times [s]."""

    case: str
    scheme: str
    elements: int
    status: str
    unknowns: int | None = None
    """variables of the program"""
    build: float | None = None
    cold: float | None = None
    error: float | None = None
    estimate: float | None = None


def mesh(case: Case, scheme: str, elements: int, known: Exact) -> Mesh:
    scene = case.solved_with(SolveOptions(scheme=scheme, solver="fatrop", elements=elements))
    first, _ = _timed(scene)
    row = Mesh(case.name, scheme, elements, first.status.name)
    if first.position is None:
        return row
    _, exact = known.near(case.name, first)
    return replace(
        row,
        unknowns=unknowns(scene),
        build=first.solver["build_time"],
        cold=min(_timed(scene)[1] for _ in range(REPEATS)),
        error=exact.distance(first) / scene.rod.length,
        estimate=first.position_error / scene.rod.length,
    )


def unknowns(scene: Scene) -> int:
    """Variables of the program of a scene with a given number of elements and no supports."""
    problem = Problem.of(scene, reduce(scene))
    return build(problem.structure((scene.options.elements,))).x.numel()
