# SPDX-License-Identifier: LGPL-2.1-or-later
"""What peers are asked and how their answers become rows; here only those that need no package of their own."""

from dataclasses import replace

import pytest

from benchmarks.exact import Exact
from benchmarks.peers import parent
from benchmarks.peers.asked import EXUDYN, MODULES, PAPER, SEED, SOLVE_BVP, Asked, asked
from benchmarks.peers.half_elements import Chain

SCENES = parent.problems()


def test_every_peer_is_asked_both_problems_cold_and_none_twice():
    tasks = list(asked())
    assert len(set(tasks)) == len(tasks)
    for peer in MODULES:
        cold = {one.problem for one in tasks if one.peer == peer and one.start == "cold"}
        assert {PAPER, "cantilever"} <= cold


@pytest.mark.parametrize("problem", [PAPER, "cantilever"])
@pytest.mark.parametrize(
    ("peer", "variant", "elements", "tolerance", "error"),
    [
        (SOLVE_BVP, "derivatives given", 16, 1e-3, 1e-4),
        # Order 2: 2e-3 L with 25 elements, so a quarter of it four times with 100.
        (SEED, "two points", 100, 0.0, 2e-4),
    ],
)
def test_a_peer_answers_in_its_own_process(problem, peer, variant, elements, tolerance, error):
    one = Asked(peer, problem, elements, variant, tolerance=tolerance)
    row = parent.ask(one, SCENES[problem], Exact())
    assert (row.status, row.problem, row.peer) == ("CONVERGED", problem, peer)
    assert 0 < row.error < error
    assert row.seconds > 0 and row.unknowns > elements


def test_curvature_over_three_points_lets_two_curves_part():
    """Why the literal reading of the paper is not the baseline: its energy lies below the least that a rod can have."""
    one = Asked(SEED, PAPER, 100, "three points")
    row = parent.ask(one, SCENES[PAPER], Exact())
    assert row.error > 0.01
    energy = float(row.message.split("energy ")[1].split(" ")[0])
    # Of the strong form, `freecad_cable/reference`: 0.0502536 J.
    assert energy < 0.045


def test_a_peer_that_is_missing_crashes_or_hangs_is_a_row(monkeypatch):
    one = Asked(EXUDYN, PAPER, 10, "over an arc")
    monkeypatch.setattr(parent, "installed", lambda package: (None, ""))
    assert parent.ask(one, SCENES[PAPER], Exact()).status == "not installed"
    monkeypatch.setattr(parent, "installed", lambda package: (parent.CHECKOUT, "1"))
    row = parent.ask(one, SCENES[PAPER], Exact())
    assert row.status == "failed" and "exudyn" in row.message
    row = parent.ask(replace(one, peer=SOLVE_BVP), SCENES[PAPER], Exact(), patience=0.01)
    assert row.status == "TimeoutError"


def test_centred_elements_stick_out_by_halves():
    long, short = (
        parent._task(Asked(EXUDYN, name, 10, "centred"), SCENES[name])
        for name in (PAPER, "cantilever")
    )
    chain = Chain.of(long)
    assert chain.centres[[0, -1]] == pytest.approx([0, long.length])
    assert chain.inside.sum() == 9
    chain = Chain.of(short)
    assert (chain.centres[0], chain.nodes[-1]) == pytest.approx((0, short.length))
    chain = Chain.of(replace(long, variant="as documented"))
    assert chain.nodes == pytest.approx(long.arc_length) and chain.inside.all()
