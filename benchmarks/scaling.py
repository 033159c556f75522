# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the time of a solve grows with the elements, and what a drag costs step by step."""

import time
from dataclasses import dataclass, replace
from statistics import median

import numpy as np

from benchmarks.cases import DRAG, Case, seed_paper
from benchmarks.measure import unknowns
from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.options import SolveOptions

ELEMENTS = (100, 200, 400, 800, 1600, 3200)
REPEATS = 3
PATIENCE = 600.0
"""[s] of time limit: building a solver of 3200 elements counts against it"""
STEPS = 40


@dataclass(frozen=True)
class Scaling:
    """Table 1, 0.73 m, cold, on a uniform mesh; times [s]."""

    scheme: str
    elements: int
    unknowns: int
    status: str
    build: float
    cold: float
    """the least of some, solver built"""
    in_solver: float
    iterations: int | None


def scaling(scheme: str, elements: int) -> Scaling:
    options = SolveOptions(scheme=scheme, solver="fatrop", elements=elements, time_limit=PATIENCE)
    scene = replace(seed_paper(0.73), options=options)
    build, cold, in_solver = 0.0, np.inf, np.inf
    for _ in range(REPEATS + 1):
        begin = time.perf_counter()
        solution = find_equilibrium(scene)
        spent = time.perf_counter() - begin
        said = solution.solver
        build = max(build, said.get("build_time", 0.0))
        cold = min(cold, spent - said.get("build_time", 0.0))
        in_solver = min(in_solver, said.get("solve_time", np.inf))
    return Scaling(
        scheme,
        elements,
        unknowns(scene),
        solution.status.name,
        build,
        cold,
        in_solver,
        said.get("iterations"),
    )


@dataclass(frozen=True)
class Drag:
    """The end of a cable led along a circle, each step from the solution before; times [s], solvers built."""

    case: str
    steps: int
    kept: int
    """steps that converged"""
    cold: float
    """median of the cold solves of the same scenes"""
    warm: float
    """median of the steps"""
    slowest: float
    iterations: float
    """median of the steps"""
    most_iterations: int


def drag(case: Case) -> Drag:
    """Steps of ``DRAG`` of the length, along a circle across the chord."""
    scene, warm, cold, iterations, kept = case.scene, [], [], [], 0
    place, length = scene.end.position, scene.rod.length
    chord = place - scene.start.position
    aside = np.cross(chord, scene.gravity)
    aside /= np.linalg.norm(aside)
    up = np.cross(aside, chord) / np.linalg.norm(chord)
    radius = DRAG * length * STEPS / (2 * np.pi)
    before = find_equilibrium(scene)
    for k in range(1, STEPS + 1):
        angle = 2 * np.pi * k / STEPS
        there = place + radius * (np.sin(angle) * aside + (1 - np.cos(angle)) * up)
        here = replace(scene, end=replace(scene.end, position=there))
        find_equilibrium(here, start=before)  # builds, if anything is to be built
        (found, seconds), (_, other) = _timed(here, before), _timed(here, None)
        warm.append(seconds)
        cold.append(other)
        iterations.append(found.solver["iterations"])
        kept += found.status.success
        before = found
    return Drag(
        case.name,
        STEPS,
        kept,
        median(cold),
        median(warm),
        max(warm),
        median(iterations),
        max(iterations),
    )


def _timed(scene, start):
    begin = time.perf_counter()
    solution = find_equilibrium(scene, start=start)
    return solution, time.perf_counter() - begin - solution.solver["build_time"]
