# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every case of the benchmarks is solved, and one that is not becomes a row."""

import signal
import time
from dataclasses import replace

import numpy as np
import pytest

from benchmarks import measure, outcomes
from benchmarks.cases import CASES, Case, tilted
from benchmarks.exact import Exact
from benchmarks.extreme import families
from benchmarks.guarded import Guarded
from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.options import SolveOptions
from freecad_cable.reference.strong_form import equilibrium

ROUGH = SolveOptions(tolerance=1e-3)


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_a_case_is_solved(case):
    row = measure.work(case, ROUGH, Exact())
    assert (row.status, row.message) == ("CONVERGED", "The cable is in equilibrium.")
    assert 0 < row.error <= ROUGH.tolerance
    assert row.cold > 0 and row.warm > 0


def test_of_repeats_the_least_time_counts(monkeypatch):
    """Also of what followed a failure in between, and what happened first stays as it was."""
    rows = [
        measure.Work("a", "", "", 0, "CONVERGED", first=9.0, cold=cold, warm=warm)
        for cold, warm in ((3.0, 2.0), (2.0, 4.0))
    ]
    rows.insert(1, measure.Work("a", "", "", 0, "TIME_LIMIT", first=1.0))
    rows.append(measure.Work("a", "", "", 0, "CONVERGED", first=1.0, cold=5.0))
    given = iter(rows)
    monkeypatch.setattr(measure, "work", lambda *_: next(given))
    [row] = measure.works(CASES[0], [ROUGH], Exact())
    assert (row.first, row.cold, row.warm) == (9.0, 2.0, 2.0)


def test_what_is_read_between_exact_nodes_is_exact():
    """Against the exact solver at the solution's own nodes, within the uncertainty stated."""
    case = CASES[0]
    exact = Exact()
    measure.work(case, ROUGH, exact)
    scene = case.solved_with(SolveOptions(tolerance=1e-5))
    solution = find_equilibrium(scene)
    apart = exact.near(case.name, solution)[1].distance(solution)
    state = equilibrium(scene, solution).at(solution.arc_length)
    own = np.linalg.norm(solution.position - state.position, axis=1).max()
    assert apart == pytest.approx(own, abs=exact.uncertainty * scene.rod.length)


def test_a_cable_without_slack_is_a_row():
    row = measure.work(Case("straight", "no slack", tilted(1.0, 0.0)), ROUGH, Exact())
    assert row.status == "INFEASIBLE"
    assert "no slack" in row.message
    assert row.first > 0 and row.cold is None and row.error is None


def test_a_solve_out_of_time_is_a_row():
    options = replace(ROUGH, time_limit=1e-6)
    assert measure.work(CASES[0], options, Exact()).status == "TIME_LIMIT"
    extreme = next(families())
    limited = replace(extreme, scene=replace(extreme.scene, options=options))
    row = outcomes.outcome(limited)
    assert row.status == "TIME_LIMIT" and outcomes.failed(row)


def test_an_exception_is_a_row(monkeypatch):
    def broken(scene, start=None):
        raise ArithmeticError("on purpose")

    monkeypatch.setattr(measure, "find_equilibrium", broken)
    row = measure.work(CASES[0], ROUGH, Exact())
    assert (row.status, row.message) == ("ArithmeticError", "on purpose")
    assert outcomes.outcome(next(families()), broken).status == "ArithmeticError"


@pytest.mark.parametrize(
    ("in_its_place", "argument", "status"),
    [
        (time.sleep, 60, "TimeoutError"),
        (signal.raise_signal, signal.SIGTERM, "ChildProcessError"),
        (abs, "x", "TypeError"),
    ],
)
def test_a_guarded_solve_that_hangs_crashes_or_raises_is_a_row(in_its_place, argument, status):
    """Functions of one argument for which 0 is harmless stand in place of a solver."""
    extreme = replace(next(families()), scene=argument)
    with Guarded(in_its_place, patience=1, rehearsal=(0,)) as solve:
        assert outcomes.outcome(extreme, solve).status == status


def test_a_guarded_call_returns_what_the_function_does():
    with Guarded(abs, patience=30, rehearsal=(0,)) as size:
        assert [size(-2), size(3)] == [2, 3]


def test_an_extreme_scene_is_solved_and_its_error_known():
    extreme = next(e for e in families() if (e.family, e.row, e.column) == ("weight", "1.1", "100"))
    row = outcomes.outcome(extreme, truth=outcomes.true_error)
    assert row.status == "CONVERGED" and not outcomes.failed(row)
    assert 0 < row.error <= row.estimate <= 1e-4
    assert row.balance_moment < 0.1


def test_the_exact_shape_of_a_rod_that_stretches_and_shears_is_read_between_its_nodes():
    """Quintics through position, tangent and curvature of every other node meet those in between within 2⁶ times the
    uncertainty stated, which a wrong derivative would not."""
    scene = CASES[0].scene
    soft = replace(scene.rod, axial_stiffness=50.0, shear_stiffness=20.0)
    scene = replace(scene, rod=soft, options=ROUGH)
    exact = Exact()
    _, branch = exact.near("soft", find_equilibrium(scene))
    assert branch.uncertainty == exact.uncertainty <= 1e-10
    slope = branch.position.derivative()(branch.state.arc_length)
    assert np.ptp(np.linalg.norm(slope, axis=1)) > 1e-4  # it does stretch


def test_extreme_scenes_side_by_side_keep_their_order(monkeypatch):
    monkeypatch.setattr(outcomes, "TRUTH_PATIENCE", 60.0)  # this machine may be busy
    wanted = [e for e in families() if (e.family, e.row) == ("metres", "0")][:3]
    rows = list(outcomes.outcomes(wanted, every=2))
    assert [row.column for row in rows] == [extreme.column for extreme in wanted]
    assert [row.status for row in rows] == ["CONVERGED"] * 3
    assert [row.error is None for row in rows] == [False, True, False]
