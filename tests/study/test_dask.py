# SPDX-License-Identifier: LGPL-2.1-or-later
"""Dask's executor on a local cluster: the rows are those of one process, and nothing of it stays behind."""

import os
import signal

import pytest
from distributed import Client, LocalCluster
from scenes import table_1

from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.study import Parameter, Variation, cases, random_cases, run
from freecad_cable.study.variation import held_within, longer

WORKERS = 2
PATIENCE = 180
"""[s] for a test of some seconds, on a machine that is busy"""


@pytest.fixture(autouse=True)
def _patience():
    """A cluster that stands still fails its test instead of holding up all others."""

    def give_up(*_):
        raise TimeoutError(f"no end after {PATIENCE} s")

    before = signal.signal(signal.SIGALRM, give_up)
    signal.alarm(PATIENCE)
    yield
    signal.alarm(0)
    signal.signal(signal.SIGALRM, before)


def lives(process):
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    return True


def test_rows_of_a_cluster_are_those_of_one_process(tmp_path):
    """Bit by bit: a case starts from the same solution and with the same numbers everywhere."""
    scene = table_1(min_bend_radius=0.0475)
    stiffness = Parameter(field="cable.stiffness", how="scale")
    varied = [
        longer(scene),
        *held_within(scene, "end", 0.002, 0.03),
        Variation(stiffness, 0.5, 2.0, "log"),
    ]
    drawn = random_cases(varied, 2 * cases.CHUNK + 5, 11)
    start = find_equilibrium(scene)
    here = list(run(scene, drawn, start=start))
    assert sum(row.solved for row in here) == len(here) == drawn.count
    cluster = LocalCluster(
        n_workers=WORKERS,
        threads_per_worker=1,
        processes=True,
        dashboard_address=None,
        local_directory=str(tmp_path),
    )
    with cluster, Client(cluster) as client:
        workers = client.run(os.getpid).values()
        assert len({os.getpid(), *workers}) == 1 + WORKERS
        assert list(run(scene, drawn, start=start, executor=client.get_executor())) == here
    assert not any(map(lives, workers))
