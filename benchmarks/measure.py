# SPDX-License-Identifier: LGPL-2.1-or-later
"""One problem, one row. A failure is a row as well.

Times are wall-clock seconds of ``find_equilibrium`` as a whole unless named otherwise. Of repeats the least
counts: other work on the machine only ever adds time.
"""

import math
import time
from dataclasses import dataclass, replace

import numpy as np
from scipy.interpolate import BPoly

from benchmarks.cases import Case, moved
from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.geometry import rotation
from freecad_cable.options import SolveOptions
from freecad_cable.problem import Scene
from freecad_cable.reference.state import RodState
from freecad_cable.reference.strong_form import equilibrium
from freecad_cable.result import Solution

REPEATS = 4
UNCERTAIN = 1e-10
"""How well, relative to the length, an exact shape must be known: a hundredth of the errors measured against it
that matter."""
ANOTHER = 0.01
"""Distance, relative to the length, from which a shape is another equilibrium and not an error."""


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


def works(case: Case, wanted: list[SolveOptions], known: "Exact") -> list[Work]:
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


def work(case: Case, options: SolveOptions, known: "Exact") -> Work:
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


class Exact:
    """The exact equilibria of each case, solved in strong form as they are met."""

    def __init__(self):
        self.branches: dict[str, list[Branch]] = {}

    def near(self, name: str, solution: Solution) -> tuple[int, "Branch"]:
        """The equilibrium that a solution of this case is near to, and its place in the list.
        Errors: ``NoSolutionError``."""
        branches = self.branches.setdefault(name, [])
        for place, branch in enumerate(branches):
            if branch.distance(solution) < ANOTHER * solution.scene.rod.length:
                return place, branch
        branch = Branch(solution.scene, equilibrium(solution.scene, solution))
        while branch.uncertainty > UNCERTAIN:
            # From its own nodes the solver comes back with twice as many.
            branch = Branch(solution.scene, equilibrium(solution.scene, branch.state))
        branches.append(branch)
        return len(branches) - 1, branch

    @property
    def uncertainty(self) -> float:
        """How well the worst of them is known, relative to the length."""
        return max(branch.uncertainty for branches in self.branches.values() for branch in branches)


class Branch:
    """One exact equilibrium of a rod that neither stretches nor shears, read at any arc length: quintic
    polynomials through position, tangent and curvature of its nodes."""

    def __init__(self, scene: Scene, state: RodState):
        self.state = state
        frames = rotation.matrix(state.quaternion)
        moment = np.einsum("kij,ki->kj", frames, state.moment)
        curvature = scene.rod.natural_curvature + moment / scene.rod.stiffness
        bend = np.einsum("kij,kj->ki", frames, np.cross(curvature, [0.0, 0.0, 1.0]))
        given = np.stack([state.position, frames[:, :, 2], bend], axis=1)
        self.position = BPoly.from_derivatives(state.arc_length, given)
        rough = BPoly.from_derivatives(state.arc_length[::2], given[::2])
        between = rough(state.arc_length) - state.position
        # Twice the nodes, 2⁶ times the accuracy.
        interpolation = np.linalg.norm(between, axis=1).max() / 2**6
        self.uncertainty = (state.error + interpolation) / scene.rod.length
        """how well it is known, relative to the length"""

    def distance(self, solution: Solution) -> float:
        """Largest distance of a node of the solution from its exact place [m]."""
        apart = solution.position - self.position(solution.arc_length)
        return float(np.linalg.norm(apart, axis=1).max())


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
        build=first.solver["build_time"],
        cold=min(_timed(scene)[1] for _ in range(REPEATS)),
        error=exact.distance(first) / scene.rod.length,
        estimate=first.position_error / scene.rod.length,
    )


@dataclass(frozen=True)
class Cell:
    """One run of one problem of the extreme grid; times in seconds, estimate relative to the length."""

    weight_ratio: float
    length_ratio: float
    status: str
    message: str = ""
    seconds: float | None = None
    """without the building of solvers, as far as it is known: not where a time limit struck"""
    build: float | None = None
    iterations: int | None = None
    elements: int | None = None
    estimate: float | None = None
    balance_moment: float | None = None
    """residual of the independent check, relative to the largest moment"""
    balance_force: float | None = None


def cell(weight_ratio: float, length_ratio: float, scene: Scene, solve=find_equilibrium) -> Cell:
    """``solve``: what finds the equilibrium; one that may hang wants to be guarded."""
    begin = time.perf_counter()
    try:
        solution = solve(scene)
    except Exception as error:  # noqa: BLE001  Whatever goes wrong with a problem is its row.
        seconds = time.perf_counter() - begin
        return Cell(weight_ratio, length_ratio, type(error).__name__, str(error), seconds)
    seconds = time.perf_counter() - begin
    build = solution.solver.get("build_time", 0.0)
    row = Cell(
        weight_ratio,
        length_ratio,
        solution.status.name,
        solution.message,
        seconds - build,
        build,
        solution.solver.get("iterations"),
        solution.solver.get("elements"),
    )
    if solution.position is None:
        return row
    row = replace(row, estimate=solution.position_error / scene.rod.length)
    check = solution.balance
    return replace(row, balance_moment=check.moment, balance_force=check.force)
