# SPDX-License-Identifier: LGPL-2.1-or-later
"""What studies cost: random cases in one process, through processes and through Dask, and a path of many values."""

import json
import multiprocessing
import os
import tempfile
import time
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager, nullcontext
from dataclasses import dataclass
from statistics import median

import numpy as np
from distributed import Client, LocalCluster

from benchmarks.cases import seed_paper
from benchmarks.machine import CHECKOUT
from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.study import Parameter, follow, random_cases, run
from freecad_cable.study.study_file import ToleranceStudy, read_study

CASES, ALONE = 10_000, 1_000
"""Random cases, and how many of them, the first, one process is given: its time grows in proportion."""
LENGTHS = np.linspace(0.5, 0.9, 100)
"""[m] The path: lengths of the cable of Table 1."""
COLD = 20
"""Scenes whose median is the time of a cold solve."""

TOLERANCE, PATH = "tolerance", "path"
HERE, PROCESSES, DASK = "one process", "ProcessPoolExecutor", "Dask, local cluster"


@dataclass(frozen=True)
class Study:
    """One study solved in one way; times in seconds."""

    what: str
    way: str
    workers: int
    values: int
    """cases, or values of a path"""
    solved: int
    seconds: float
    """until the last row is there, the start of the workers included"""
    cold: float
    """median of cold solves of the same scenes, solvers built"""
    load: float
    """[processes] on this machine at the start, a mean of a minute"""
    different: int | None = None
    """rows unlike those of the way before, as far as both have them"""

    @property
    def each(self) -> float:
        """[s] for a case or a value"""
        return self.seconds / self.values


def rows(say) -> Iterator[Study]:
    """``say`` is told what comes."""
    yield from tolerance(documented(), CASES, ALONE, say)
    say(f"studies: a path of {len(LENGTHS)} values")
    yield path(LENGTHS)


def documented() -> ToleranceStudy:
    """That of ``docs/tolerance.json``."""

    def load(name):
        return json.loads((CHECKOUT / "docs" / name).read_text(encoding="utf-8"))

    return read_study(load("tolerance.json"), load)


def tolerance(study: ToleranceStudy, count: int, alone: int, say) -> Iterator[Study]:
    """A row for each way to solve ``count`` cases; one process solves the first ``alone`` of them."""
    scene, variations, seed = study.scene, study.cases.variations, study.cases.seed
    start, before = find_equilibrium(scene), None
    nearby = random_cases(variations, COLD, seed)
    cold = _cold([nearby.scene(scene, index) for index in range(COLD)])
    workers = os.cpu_count()
    ways = (
        (HERE, 1, alone, nullcontext()),
        (PROCESSES, workers, count, _processes(workers)),
        (DASK, workers, count, _cluster(workers)),
    )
    for way, workers, number, executor in ways:
        say(f"studies: {number} cases, {way}")
        cases = random_cases(variations, number, seed)
        load, begin = os.getloadavg()[0], time.perf_counter()
        with executor as given:
            found = list(run(scene, cases, start=start, executor=given))
            seconds = time.perf_counter() - begin
        solved = sum(row.solved for row in found)
        different = before and sum(a != b for a, b in zip(before, found, strict=False))
        yield Study(TOLERANCE, way, workers, number, solved, seconds, cold, load, different)
        before = found


def _processes(workers):
    # A fresh interpreter each, as Dask's are.
    return ProcessPoolExecutor(workers, mp_context=multiprocessing.get_context("spawn"))


@contextmanager
def _cluster(workers):
    with tempfile.TemporaryDirectory() as folder:
        cluster = LocalCluster(
            n_workers=workers,
            threads_per_worker=1,
            processes=True,
            dashboard_address=None,
            local_directory=folder,
        )
        with cluster, Client(cluster) as client:
            yield client.get_executor()


def path(lengths) -> Study:
    """The row of the cable of Table 1 over its length [m]."""
    scene = seed_paper(float(lengths[0]))
    length = Parameter(field="cable.length")

    def scene_at(value):
        return length.of(scene, value)

    every = max(1, len(lengths) // COLD)
    cold = _cold([scene_at(value) for value in lengths[::every]])
    load, begin = os.getloadavg()[0], time.perf_counter()
    steps = list(follow(scene_at, lengths))
    seconds = time.perf_counter() - begin
    solved = sum(step.solved for step in steps)
    return Study(PATH, HERE, 1, len(steps), solved, seconds, cold, load)


def _cold(scenes):
    """[s] median; each is solved once before, which builds what is to be built."""
    times = []
    for scene in scenes:
        find_equilibrium(scene)
        begin = time.perf_counter()
        find_equilibrium(scene)
        times.append(time.perf_counter() - begin)
    return median(times)
