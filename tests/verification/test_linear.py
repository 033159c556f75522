# SPDX-License-Identifier: LGPL-2.1-or-later
"""The linear problem of a rod that may move as a whole: the shortest of its corrections."""

import numpy as np
import pytest

from freecad_cable.solve.linear import LinearProblem


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
