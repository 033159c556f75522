# SPDX-License-Identifier: LGPL-2.1-or-later
"""Studies as the benchmarks run them, here with few cases."""

import numpy as np

from benchmarks import report_studies, studies


def test_every_way_solves_the_same_cases():
    said = []
    rows = list(studies.tolerance(studies.documented(), 40, 18, said.append))
    assert [row.way for row in rows] == [studies.HERE, studies.PROCESSES, studies.DASK]
    assert [(row.values, row.solved) for row in rows] == [(18, 18), (40, 40), (40, 40)]
    assert [row.different for row in rows] == [None, 0, 0]
    assert min(min(row.seconds, row.cold) for row in rows) > 0
    assert len(said) == 3


def test_a_path_is_cheaper_than_its_values_solved_cold():
    row = studies.path(np.linspace(0.6, 0.7, 12))
    assert (row.values, row.solved) == (12, 12)
    assert 0 < row.seconds < row.values * row.cold


def test_the_report_compares_throughputs():
    given = {"workers": 2, "solved": 9, "cold": 0.5, "load": 0.1}
    rows = [
        studies.Study(studies.TOLERANCE, studies.HERE, values=100, seconds=10.0, **given),
        studies.Study(studies.TOLERANCE, studies.DASK, values=900, seconds=45.0, **given),
        studies.Study(studies.PATH, studies.HERE, values=100, seconds=10.0, **given),
    ]
    text = "\n".join(report_studies.section(rows))
    assert "| 20.0 | 2.00 |" in text
    assert "20.0 cold solves of 500 ms" in text
