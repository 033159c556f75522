# SPDX-License-Identifier: LGPL-2.1-or-later
"""The linear problem of a rod that may move as a whole: the shortest of its corrections."""

import numpy as np
import pytest

from freecad_cable.solve.linear import LinearProblem, solved


def test_what_is_free_stays():
    """Changes go unchanged from node to node, and both ends ask for the first six of them, so the others are free.
    Shortest is what has no mean along the rod."""
    elements = 5
    random = np.random.default_rng(0)
    defects = random.normal(size=(elements, 12))
    defects[:, :6] = 0.0
    same = np.tile(np.eye(12), (elements, 1, 1))
    problem = LinearProblem([elements])
    problem.elements((same, same), defects)
    held = np.eye(12)[:6], np.full(6, 0.3)
    problem.ends(held, held)
    (found,) = problem.solve()
    expected = np.vstack([np.zeros(12), -np.cumsum(defects, axis=0)])
    expected -= expected.mean(axis=0)
    expected[:, :6] = 0.3
    # Rounding over the singular value 1e-7 below which a direction is taken to be free.
    assert found == pytest.approx(expected, abs=1e-8)


def test_a_band_with_a_border():
    """Two stretches of random elements that share what is unknown of their lengths, and a joint with one multiplier."""
    random = np.random.default_rng(1)
    problem = LinearProblem([3, 4])
    transfer = random.normal(size=(2, 7, 12, 12))
    problem.elements(transfer, random.normal(size=(7, 12)))
    problem.ends(*((random.normal(size=(6, 12)), random.normal(size=6)) for _ in range(2)))
    lengths = problem.unknowns(2)
    for k in range(2):
        nodes = [(random.normal(size=(1, 12)), problem.node(k, i)) for i in (0, 1, -1)]
        problem.add([*nodes, (random.normal(size=(1, 2)), lengths)], random.normal(), border=True)
    for column in lengths:
        for row in problem.element_rows:
            problem.add_to(row + np.arange(12), column, random.normal(size=12))
    a, b = problem.node(0, -1), problem.node(1, 0)
    multiplier = problem.unknowns(1, a)
    for columns in (a, b):
        given = random.normal(size=(6, 12)), columns
        problem.add([given, (random.normal(size=(6, 1)), multiplier)], random.normal(size=6))
    problem.add([(random.normal(size=(1, 12)), a)], random.normal())
    matrix = np.zeros((problem.size, problem.size))
    matrix[np.concatenate(problem.rows), np.concatenate(problem.cols)] = np.concatenate(
        problem.data
    )
    expected = np.linalg.solve(matrix, np.concatenate(problem.right))
    found = np.vstack(problem.solve()).ravel()
    # Rounding over what such a matrix has of condition, some 1e4.
    assert found == pytest.approx(expected[: len(found)], abs=1e-9 * np.abs(expected).max())


def test_without_joints_at_once():
    """As the problem that is collected piece by piece has it; None where that has no unique answer."""
    random = np.random.default_rng(2)
    transfer, defects = random.normal(size=(2, 4, 12, 12)), random.normal(size=(4, 12))
    ends = [(random.normal(size=(6, 12)), random.normal(size=6)) for _ in range(2)]
    problem = LinearProblem([4])
    problem.elements(transfer, defects)
    problem.ends(*ends)
    (expected,) = problem.solve()
    found = solved(transfer, defects, *ends)
    # The same equations in the same order.
    assert found == pytest.approx(expected, abs=1e-12 * np.abs(expected).max())
    same = np.tile(np.eye(12), (4, 1, 1))
    held = np.eye(12)[:6], np.zeros(6)
    assert solved((same, same), defects, held, held) is None
