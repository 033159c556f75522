# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tolerance: what is drawn, that the rows do not depend on who solves them, and the verdict."""

import multiprocessing
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from dataclasses import replace

import numpy as np
import pytest
from scenes import table_1

from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.errors import ProblemError
from freecad_cable.problem import Free, Pinned, Sphere, Swivel
from freecad_cable.result import Contact
from freecad_cable.study import (
    Parameter,
    Row,
    Variation,
    cases,
    corners,
    length_tolerance,
    random_cases,
    run,
)
from freecad_cable.study.variation import held_within, longer

EI = Parameter(field="cable.bending_stiffness", how="scale")
GJ = Parameter(field="cable.torsional_stiffness", how="scale")


def nominal():
    return table_1(min_bend_radius=0.0475)


def varied(scene):
    return [
        longer(scene),
        *held_within(scene, "end", 0.002, 0.03),
        Variation(EI, 0.8, 1.25, "log"),
        Variation(GJ, 0.8, 1.25, "normal"),
    ]


@pytest.mark.parametrize(
    ("length", "more"),
    [(0.3, 0.025), (0.31, 0.05), (1.5, 0.05), (3.0, 0.1), (7.0, 0.15), (10, 0.5)],
)
def test_the_tolerance_of_a_length(length, more):
    """IPC/WHMA-A-620, Table 11-1."""
    assert length_tolerance(length) == pytest.approx(more)


def test_what_is_drawn_follows_from_seed_and_number_alone():
    scene = nominal()
    one, other = (random_cases(varied(scene), count, 7) for count in (100, 5))
    assert [one.values(i) for i in (4, 0)] == [other.values(4), other.values(0)]
    assert one.values(4) != random_cases(varied(scene), 100, 8).values(4)
    assert one.values(4) != one.values(3)


def test_what_is_drawn_fills_its_band():
    variations = [Variation(EI, 0.5, 2, spread) for spread in ("uniform", "log", "normal")]
    drawn = random_cases(variations, 2000, 1)
    uniform, log, normal = np.array([drawn.values(i) for i in range(2000)]).T
    for values in (uniform, log, normal):
        assert values.min() >= 0.5 and values.max() <= 2
    # Means of 2000 are known to a standard error of σ/√2000; five of them.
    assert uniform.mean() == pytest.approx(1.25, abs=5 * 0.433 / 2000**0.5)
    assert np.log(log).mean() == pytest.approx(0, abs=5 * 0.8 / 2000**0.5)
    assert normal.mean() == pytest.approx(1.25, abs=5 * 0.25 / 2000**0.5)
    assert normal.std() == pytest.approx(0.25, rel=0.1)


def test_corners_are_all_combinations():
    found = corners([Variation(EI, 1, 2), Variation(GJ, 3, 4)])
    assert {found.values(i) for i in range(found.count)} == {(1, 3), (1, 4), (2, 3), (2, 4)}
    with pytest.raises(ProblemError, match="at most 16"):
        corners([Variation(EI, 1, 2)] * 17)


def test_what_an_end_holds_is_what_varies():
    def axes(end):
        found = held_within(replace(nominal(), end=end), "end", 0.001, 0.01)
        return [v.parameter.axis for v in found if v.parameter.how == "turn"]

    there = [0.16, -0.235, 0.33]
    assert axes(nominal().end) == ["d1", "d2", "d3"]
    assert axes(Swivel(there, [1, 0, 0])) == ["d1", "d2"]
    assert axes(Pinned(there)) == []
    with pytest.raises(ProblemError, match="holds nothing"):
        axes(Free())


def test_the_rows_are_those_of_single_solves():
    scene = nominal()
    drawn = random_cases(varied(scene), 6, 3)
    start = find_equilibrium(scene)
    rows = list(run(scene, drawn, start=start))
    for i, row in enumerate(rows):
        alone = find_equilibrium(drawn.scene(scene, i)).raise_for_status()
        assert row.smallest_bend_radius == pytest.approx(alone.min_bend_radius[0], rel=2e-3)
        assert row.energy == pytest.approx(alone.energy.total, rel=1e-4)
        margin = alone.min_bend_radius[0] - 0.0475
        assert row.holds == (margin >= 0)
    again = cases.solution(scene, drawn, 4, start)
    assert again.energy.total == rows[4].energy


def test_rows_are_equal_whoever_solves_them():
    """Bit by bit: a case starts from the same solution and with the same numbers everywhere."""
    scene = nominal()
    drawn = random_cases(varied(scene), 2 * cases.CHUNK + 5, 11)
    start = find_equilibrium(scene)
    here = list(run(scene, drawn, start=start))
    assert len(here) == drawn.count
    spawn = multiprocessing.get_context("spawn")
    for executor in (ThreadPoolExecutor(3), ProcessPoolExecutor(2, mp_context=spawn)):
        with executor:
            assert list(run(scene, drawn, start=start, executor=executor)) == here


def test_who_wants_no_more_rows_stops_the_rest():
    scene = nominal()
    with ThreadPoolExecutor(1) as executor:
        rows = run(scene, random_cases(varied(scene), 100_000, 1), executor=executor)
        next(rows)
        rows.close()
    # The pool has come to its end long before 100,000 cases.


def test_few_cases_wait_for_workers_and_their_rows_keep_their_order(monkeypatch):
    monkeypatch.setattr(cases, "CHUNK", 2)
    monkeypatch.setattr(cases, "AHEAD", 2)
    scene = nominal()
    drawn = random_cases(varied(scene), 9, 5)
    waiting = []

    class Counting(ThreadPoolExecutor):
        def submit(self, *task):
            future = super().submit(*task)
            waiting.append(future)
            return future

    with Counting(1) as executor:
        rows = run(scene, drawn, executor=executor)
        first = next(rows)
        assert len(waiting) == 2
        found = [first, *rows]
    assert [row.values for row in found] == [drawn.values(i) for i in range(9)]
    assert len(waiting) == 5


def test_a_case_that_is_no_scene_is_a_row():
    scene = nominal()
    short = Variation(Parameter(field="cable.length"), 0.1, 0.2)
    (row, _) = run(scene, random_cases([short], 2, 1))
    assert not row.solved and "apart" in row.error
    assert cases.Verdict.of([row]).share == 0


def row(**given):
    return Row(values=(), **({"solved": True, "holds": True, "length": 1.0} | given))


def test_the_verdict():
    rows = [
        row(bend_radius_margin=0.01),
        row(bend_radius_margin=0.002),
        row(bend_radius_margin=-0.001, holds=False),
        row(bend_radius_margin=0.02),
    ]
    verdict = cases.Verdict.of(rows)
    assert (verdict.count, verdict.holding, verdict.worst, verdict.share) == (4, 3, 2, 0.75)
    # Wilson, with z = 1.96: (p + z²/2n ± z √(p(1−p)/n + z²/4n²)) / (1 + z²/n).
    assert verdict.between == pytest.approx((0.3006, 0.9544), abs=1e-4)
    unsolved = Row(values=(), error="No.")
    assert cases.Verdict.of([*rows, unsolved]).worst == 4
    assert cases.Verdict.of(rows[:2]).worst == 1


@pytest.mark.parametrize(
    ("make", "sentence"),
    [
        (lambda: random_cases([Variation(EI, 1, 2)], 0, 1), "tolerance.count: is 0"),
        (lambda: random_cases([Variation(EI, 1, 2)], 10, -1), "tolerance.seed: is -1"),
        (lambda: random_cases([Variation(EI, 1, 2)], 10, 1.5), "tolerance.seed: is 1.5"),
        (lambda: random_cases([], 10, 1), "are empty"),
        (lambda: Variation(EI, 2, 1), "must be at least low"),
        (lambda: Variation(EI, 0, 1, "log"), "must be greater than 0"),
        (lambda: Variation(EI, 1, 2, "flat"), "must be one of uniform"),
        (lambda: Variation(EI, 1, "2"), "must be a number"),
    ],
)
def test_what_is_no_tolerance(make, sentence):
    with pytest.raises(ProblemError, match=sentence):
        make()


def test_what_pushes_a_cable_clear_of_it_makes_a_case_not_hold():
    """A cable that touches itself need not be clear of that."""
    ball = Sphere([0.0, 0.0, -1.0], 0.1, place="obstacles[0]")
    scene = replace(table_1(), obstacles=(ball,), clearance=0.01)
    alone = find_equilibrium(scene)
    itself, by_ball = (Contact(0.3, index, np.array([0, 0, 1.0])) for index in (None, 0))
    for contacts, holds in (((), True), ((itself,), True), ((itself, by_ball), False)):
        row = Row.of((), replace(alone, contacts=contacts))
        assert row.holds == holds
    assert "pushed from obstacles[0] at 0.3 m" in row.error
    assert Row.of(
        (), replace(alone, scene=replace(scene, clearance=0.0), contacts=(by_ball,))
    ).holds
