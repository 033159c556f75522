# SPDX-License-Identifier: LGPL-2.1-or-later
"""The near side of the peers: what each is asked, and a row for each answer, a failure as well."""

import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import scipy

from benchmarks.cases import TABLE_1, seed_paper
from benchmarks.exact import Exact
from benchmarks.machine import CHECKOUT
from benchmarks.peers.asked import YOUNG, Asked, asked
from benchmarks.peers.task import Nodes, Task, read_found, write
from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.options import SolveOptions
from freecad_cable.problem import Clamped, Free, Scene
from freecad_cable.problem.reduce import reduce
from freecad_cable.solve.problem import Problem
from freecad_cable.transcription.guess import guess

PATIENCE = 100.0
"""[s] for a task, importing and repeating included"""
OURS = "freecad_cable"
REPEATS = 40
BESIDE = 25
"""Solves of which the quickest tells the machine's pace"""
FINER = 4
"""Elements of a start for one of the peer's"""


@dataclass(frozen=True)
class Peer:
    """One answer of one peer; time in seconds, error relative to the length."""

    problem: str
    peer: str
    version: str
    start: str
    """cold: from a smooth curve of the right length; ours: from where we start ourselves; answer: from our answer"""
    variant: str
    steps: int
    elements: int
    tolerance: float
    status: str
    message: str = ""
    unknowns: int | None = None
    seconds: float | None = None
    """of the solve alone: importing, building of programs and compiling do not count"""
    error: float | None = None
    """true: largest distance of a node from its exact place, of a rod with the stretch and shear that the peer has"""
    pace: float | None = None
    """[s] of our solve of a cable, always the same, just before and after: a machine that others use, too, was seen to
    take twice as long for some minutes"""

    @property
    def relative(self) -> float:
        """Its time over that solve's, to be compared with times of other minutes."""
        return self.seconds / self.pace


def pace() -> float:
    """[s] of a solve, now."""
    scene = TABLE_1[0].scene
    return min(_clocked(scene)[1] for _ in range(BESIDE))


def _clocked(scene):
    """An answer of ours, and the time that it took [s]."""
    begin = time.perf_counter()
    found = find_equilibrium(scene)
    return found, time.perf_counter() - begin - found.solver.get("build_time", 0.0)


def problems() -> dict[str, Scene]:
    """Table 1, and its cable clamped at one end only, 0.3 m long: w L³/EI = 10."""
    long = seed_paper(0.73)
    short = replace(long, rod=replace(long.rod, length=0.3), end=Free())
    return {case.name: case.scene for case in TABLE_1} | {"cantilever": short}


def rows(say) -> Iterator[Peer]:
    """``say`` is told what comes."""
    scenes, exact = problems(), Exact()
    say("peers: ourselves")
    for name, scene in scenes.items():
        for scheme in ("magnus", "helix"):
            for tolerance in (1e-2, 1e-3, 1e-4, 1e-5, 1e-6):
                yield _ours(name, scene, scheme, tolerance, exact)
    for one in asked():
        say(f"peers: {one.peer}, {one.problem}, {one.variant} {one.elements}, {one.start}")
        yield ask(one, scenes[one.problem], exact)


def _ours(name, scene, scheme, tolerance, exact):
    scene = replace(scene, options=SolveOptions(scheme=scheme, tolerance=tolerance))
    before, best = pace(), np.inf
    for _ in range(REPEATS):
        found, seconds = _clocked(scene)
        best = min(best, seconds)
    count = found.solver.get("elements") or 0
    row = Peer(
        name, OURS, "", "cold", scheme, 0, count, tolerance, found.status.name, found.message
    )
    if found.position is None:
        return row
    error = exact.near(name, found)[1].distance(found) / scene.rod.length
    return replace(row, seconds=best, error=error, pace=(before + pace()) / 2)


def ask(one: Asked, scene: Scene, exact: Exact, patience=PATIENCE) -> Peer:
    """One task of one peer, in a process of its own with a Python path of its own."""
    row = Peer(
        one.problem,
        one.peer,
        "",
        one.start,
        one.variant,
        one.steps,
        one.elements,
        one.tolerance,
        "",
    )
    folder, version = installed(one.package)
    if folder is None:
        return replace(row, status="not installed")
    row = replace(row, version=f"CasADi {version}" if one.package == "casadi" else version)
    with tempfile.TemporaryDirectory() as place:
        task, found = Path(place) / "task.json", Path(place) / "found.json"
        write(task, _task(one, scene))
        command = [sys.executable, "-m", "benchmarks.peers.child", one.module, task, found]
        path, before = os.pathsep.join([str(CHECKOUT), str(folder)]), pace()
        try:
            end = subprocess.run(
                command,
                cwd=place,
                env=os.environ | {"PYTHONPATH": path},
                capture_output=True,
                text=True,
                timeout=patience,
                check=False,
            )
        except subprocess.TimeoutExpired:
            return replace(row, status="TimeoutError", message=f"not done after {patience:g} s")
        if not found.exists():
            return replace(row, status="failed", message=_last_words(end))
        answer, after = read_found(found), pace()
    scene = one.physics(scene)
    solution = find_equilibrium(replace(scene, options=SolveOptions(tolerance=1e-6)))
    _, branch = exact.near(
        f"{one.problem}, {scene.rod.axial_stiffness}, {scene.rod.shear_stiffness}", solution
    )
    return replace(
        row,
        status="CONVERGED",
        message=answer.remark,
        unknowns=answer.unknowns,
        seconds=answer.seconds,
        error=branch.distance(answer) / scene.rod.length,
        pace=(before + after) / 2,
    )


def installed(package: str):
    """(folder, version) of a peer, or (None, "") if it is not there. SciPy is the one that we use ourselves."""
    if package == "scipy":
        return CHECKOUT, scipy.__version__
    for folder in sorted((CHECKOUT / ".packages").glob(f"{package}==*")):
        if not folder.name.endswith(".part"):
            return folder, folder.name.split("==")[1]
    return None, ""


def _last_words(end):
    lines = [line for line in (end.stderr + end.stdout).splitlines() if "Error" in line]
    return lines[-1][:200] if lines else f"its process ended with {end.returncode}"


def _task(one, scene) -> Task:
    rod, area = scene.rod, np.pi * scene.rod.radius**2
    clamped = isinstance(scene.end, Clamped)
    return Task(
        length=rod.length,
        radius=rod.radius,
        bending=float(rod.bending_stiffness[0]),
        torsion=rod.torsional_stiffness,
        axial=YOUNG * area,
        shear=2 * YOUNG * area,
        mass=rod.mass_per_length,
        gravity=scene.gravity,
        start_position=scene.start.position,
        start_quaternion=scene.start.quaternion,
        end_position=scene.end.position if clamped else None,
        end_quaternion=scene.end.quaternion if clamped else None,
        start=_start(one, scene),
        near=one.start == "answer",
        elements=one.elements,
        tolerance=one.tolerance,
        variant=one.variant,
        steps=one.steps,
    )


def _start(one, scene):
    elements = FINER * one.elements
    if one.start == "answer":
        options = SolveOptions(elements=elements, solver="fatrop")
        found = find_equilibrium(replace(scene, options=options)).raise_for_status()
        return Nodes(found.arc_length, found.position, found.quaternion, found.force, found.moment)
    s, problem = np.linspace(0, 1, elements + 1), Problem.of(scene, reduce(scene))
    # By default not the chain that we start a heavy cable from: it has kinks at the clamps, which most peers dislike.
    shape = guess(scene, problem.scaling, s, chain=None if one.start == "ours" else False)
    scaling = problem.scaling
    position = scaling.origin + shape.position * scaling.length
    return Nodes(s * scaling.length, position, shape.quaternion)
