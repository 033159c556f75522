# SPDX-License-Identifier: LGPL-2.1-or-later
"""Studies as the benchmarks run them, here with few cases."""

import numpy as np

from benchmarks import report_studies, studies


def test_every_way_solves_the_same_cases(monkeypatch):
    said = []
    monkeypatch.setattr(studies, "WARM", 1)
    rows = list(studies.tolerance(studies.documented(), 2, 20, 9, said.append))
    assert [row.way for row in rows] == [studies.HERE, studies.PROCESSES, studies.DASK]
    assert [(row.values, row.solved) for row in rows] == [(18, 18), (40, 40), (40, 40)]
    assert [row.different for row in rows] == [None, 0, 0]
    assert min(min(row.seconds, row.cold) for row in rows) > 0
    assert len(said) == 2


def test_rows_that_differ_are_counted_round_by_round():
    assert studies._different([[1, 2], [3]], [[1, 5, 6], [4, 7]]) == 2


def test_a_path_is_cheaper_than_its_values_solved_cold():
    row = studies.path(np.linspace(0.6, 0.7, 12))
    assert (row.values, row.solved) == (12, 12)
    assert 0 < row.seconds < row.values * row.cold


def test_the_report_compares_throughputs():
    given = {"workers": 2, "solved": 9, "cold": 0.5}
    rows = [
        studies.Study(studies.TOLERANCE, studies.HERE, values=100, seconds=10.0, **given),
        studies.Study(studies.TOLERANCE, studies.DASK, values=900, seconds=45.0, **given),
        studies.Study(studies.PATH, studies.HERE, values=100, seconds=10.0, **given),
    ]
    text = "\n".join(report_studies.section(rows))
    assert "| 20.0 | 2.00 |" in text
    assert "20.0 cold solves of 500 ms" in text
