# SPDX-License-Identifier: LGPL-2.1-or-later
"""What studies cost: random cases in one process, through processes and through Dask, and a path of many values."""

import json
import multiprocessing
import os
import tempfile
import time
from collections.abc import Iterator
from concurrent.futures import Executor, ProcessPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass, field
from statistics import median

import numpy as np
from distributed import Client, LocalCluster

from benchmarks.cases import seed_paper
from benchmarks.machine import CHECKOUT
from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.study import Parameter, follow, random_cases, run
from freecad_cable.study.cases import CHUNK
from freecad_cable.study.study_file import ToleranceStudy, read_study

ROUNDS, CASES, ALONE = 10, 1_000, 100
"""Rounds, random cases in each, and how many of these, the first, one process is given: its time grows in
proportion."""
WARM = 4 * CHUNK
"""Cases for each worker before its time counts."""
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
    """with workers that have started and built their solvers"""
    cold: float
    """median of cold solves of the same scenes, solvers built"""
    different: int | None = None
    """rows unlike those of the way before, as far as both have them"""

    @property
    def each(self) -> float:
        """[s] for a case or a value"""
        return self.seconds / self.values


def rows(say) -> Iterator[Study]:
    """``say`` is told what comes."""
    yield from tolerance(documented(), ROUNDS, CASES, ALONE, say)
    say(f"studies: a path of {len(LENGTHS)} values")
    yield path(LENGTHS)


def documented() -> ToleranceStudy:
    """That of ``docs/tolerance.json``."""

    def load(name):
        return json.loads((CHECKOUT / "docs" / name).read_text(encoding="utf-8"))

    return read_study(load("tolerance.json"), load)


def tolerance(study: ToleranceStudy, rounds: int, count: int, alone: int, say) -> Iterator[Study]:
    """A row for each way to solve ``count`` cases in each of some rounds; one process solves the first ``alone`` of
    them. In rounds, because other work on the machine comes and goes, and it is the ratios that count."""
    start, seed = find_equilibrium(study.scene), study.cases.seed
    some = random_cases(study.cases.variations, COLD, seed)
    cold = _cold([some.scene(study.scene, index) for index in range(COLD)])
    workers = os.cpu_count()
    with _processes(workers) as pool, _cluster(workers) as cluster:
        ways = (
            _Way(HERE, 1, alone, None),
            _Way(PROCESSES, workers, count, pool),
            _Way(DASK, workers, count, cluster),
        )
        for way in ways:
            # Workers start, and build what is to be built.
            way.solve(study, start, seed, WARM * way.workers)
        for k in range(rounds):
            say(f"studies: {count} cases, round {k + 1} of {rounds}")
            for way in ways:
                found, seconds = way.solve(study, start, seed + k, way.count)
                way.rounds.append(found)
                way.seconds += seconds
    before = None
    for way in ways:
        rows = [row for found in way.rounds for row in found]
        solved = sum(row.solved for row in rows)
        different = None if before is None else _different(before.rounds, way.rounds)
        yield Study(
            TOLERANCE, way.name, way.workers, len(rows), solved, way.seconds, cold, different
        )
        before = way


@dataclass
class _Way:
    """A way to solve cases, and what it has solved."""

    name: str
    workers: int
    count: int
    """of cases in a round"""
    executor: Executor | None
    rounds: list = field(default_factory=list)
    seconds: float = 0.0

    def solve(self, study, start, seed, count):
        cases = random_cases(study.cases.variations, count, seed)
        begin = time.perf_counter()
        found = list(run(study.scene, cases, start=start, executor=self.executor))
        return found, time.perf_counter() - begin


def _different(rounds, others):
    """Of rows that both have."""
    pairs = (pair for both in zip(rounds, others, strict=True) for pair in zip(*both, strict=False))
    return sum(one != other for one, other in pairs)


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
    begin = time.perf_counter()
    steps = list(follow(scene_at, lengths))
    seconds = time.perf_counter() - begin
    solved = sum(step.solved for step in steps)
    return Study(PATH, HERE, 1, len(steps), solved, seconds, cold)


def _cold(scenes):
    """[s] median; each is solved once before, which builds what is to be built."""
    times = []
    for scene in scenes:
        find_equilibrium(scene)
        begin = time.perf_counter()
        find_equilibrium(scene)
        times.append(time.perf_counter() - begin)
    return median(times)
