# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random scenes in contact are the same in every run and solved, and their report counts what became of them."""

from dataclasses import astuple, replace

import numpy as np
import pytest

from benchmarks import among, report_contact, stored
from freecad_cable.problem import Mesh

FEW = 4
SOLVED = {"plates": (2, 3, 6), "obstacles": (1, 2, 3, 5)}
"""Seeds of scenes that are solved to the tolerance; of the first plates number 1 is told to be less accurate."""


LAST = ("obstacles", 5)


@pytest.fixture(scope="module")
def drawn():
    return {(each.family, each.seed): each for each in among.scenes(7)}


def _numbers(scene):
    """All that a scene is made of."""
    parts = (scene.rod, scene.start, scene.end, *scene.supports, *scene.obstacles)
    return [value for part in parts for value in astuple(part)]


def test_they_are_the_same_in_every_run(drawn):
    again = list(among.scenes(FEW))
    assert [each.family for each in again] == ["plates"] * FEW + ["obstacles"] * FEW
    for each in again:
        before = drawn[each.family, each.seed]
        np.testing.assert_equal(_numbers(each.scene), _numbers(before.scene))


def test_a_plate_is_a_solid_with_a_hole(drawn):
    scene = drawn["plates", 0].scene
    for ring, solid in zip(scene.supports, scene.obstacles, strict=True):
        assert isinstance(solid, Mesh) and solid.closed
        inside = solid.nearest(ring.position[None]).distance
        assert 0.98 * ring.radius < inside <= ring.radius


@pytest.mark.parametrize("one", [(family, seed) for family in SOLVED for seed in SOLVED[family]])
def test_one_is_solved_and_keeps_out_of_the_obstacles(drawn, one):
    row = among.outcome(drawn[one])
    assert (row.status, row.rims) == ("CONVERGED", False)
    assert row.contacts and 0 < row.estimate <= 1e-4
    assert row.depth < among.LEFT_OUT
    assert row.finer == "" and row.error is None


def test_one_whose_balance_takes_a_finer_mesh_than_its_error():
    """On the 128 elements that are exact enough, a spline through the nodes has its moments out of balance by a
    quarter."""
    scene = among.plates(np.random.default_rng((among.SEED, 44)))
    row = among.outcome(among.Drawn("plates", 44, scene))
    assert (row.status, row.rims) == ("CONVERGED", False)
    assert row.depth < among.LEFT_OUT


def test_the_true_error_is_known_to_within_the_finer_estimate(drawn):
    row = among.outcome(drawn[LAST], truth=among.true_error)
    assert row.finer == "CONVERGED"
    assert row.error <= row.estimate + row.finer_estimate


def test_a_cable_through_an_obstacle_is_in_it(drawn):
    """Where nothing keeps it out, the depth is what the obstacle's own distance says."""
    scene = drawn[LAST].scene
    solution = among.find_equilibrium(replace(scene, obstacles=()))
    through = replace(solution, scene=scene)
    nodes = [solid.nearest(solution.position).distance.min() for solid in scene.obstacles]
    assert among.depth(through) >= 1 - min(nodes) / scene.rod.radius > 0


def test_an_exception_is_a_row(drawn):
    def broken(_):
        raise ArithmeticError("on purpose")

    row = among.outcome(drawn[LAST], broken)
    assert (row.status, row.message) == ("ArithmeticError", "on purpose")
    row = among.outcome(drawn[LAST], truth=broken)
    assert (row.status, row.finer, row.error) == ("CONVERGED", "ArithmeticError", None)


def test_the_report_counts_what_became_of_them(tmp_path, monkeypatch):
    done = among.Among("plates", 0, "CONVERGED", "", 1.0, 8, 2, False, 0.004, 4e-5)
    known = {"finer": "CONVERGED", "finer_estimate": 1e-6}
    rows = [
        replace(done, **known, error=2e-5),
        replace(done, **known, error=9e-5, depth=0.02),
        replace(done, finer="CONVERGED"),
        replace(done, finer="INACCURATE"),
        replace(done, seed=4, status="INACCURATE", message="told", rims=True, depth=0.9),
        among.Among("plates", 5, "TIME_LIMIT", "late", 20.0),
    ]
    monkeypatch.setattr(stored, "FOLDER", tmp_path)
    stored.write(rows)
    assert stored.read(among.Among) == rows
    text = "\n".join(report_contact.section(rows))
    assert "| plates | 6 | 4 | 1 | 1 | 5 | 1e+03 | 20.0 | 0.020 |" in text
    assert "| plates | 4 | inaccurate, in a rim | 1.0 | told |" in text
    assert "| plates | 5 | time limit | 20.0 | late |" in text
    assert "deeper than that: plates 0." in text
    assert "| plates | 4 | 2 | 50.0% | 1.22 | 1 | 1 |" in text
