# SPDX-License-Identifier: LGPL-2.1-or-later
"""The equations of a rod and the conditions at its ends have the Jacobians they claim."""

import numpy as np
import pytest

from freecad_cable.problem import Clamped, Free, Pinned, Swivel
from freecad_cable.reference.held import conditions, with_unit_quaternion
from freecad_cable.reference.rod_equations import SIZE, RodEquations

STEP = 1e-5
# Central differences miss third derivatives, of order 10 for unit states, times STEP²/6.
LIMIT = 1e-8


def differences(function, y):
    steps = STEP * np.eye(SIZE)
    return np.stack([(function(y + e) - function(y - e)) / (2 * STEP) for e in steps], axis=-1)


def test_rates():
    rod = RodEquations(*np.array([[1, 2, 0.7], [0.1, 0.1, 0.05], [0.3, -0.2, 0.5], [1, 2, -3]]))
    y = np.random.default_rng(2).normal(size=(5, SIZE))
    assert np.abs(rod.rate(y)[1] - differences(lambda y: rod.rate(y)[0], y)).max() < LIMIT


@pytest.mark.parametrize(
    "end",
    [
        Clamped((1, 2, 3), (1, 2, -1, 0.5)),
        Swivel((1, 2, 3), (0.1, 0.2, 1)),
        Pinned((1, 2, 3)),
        Free(),
    ],
    ids=lambda end: end.kind,
)
def test_ends(end):
    held = with_unit_quaternion(conditions(end, np.array([1, 2, 3]), np.array([4, 5, 6])))
    y = np.concatenate(([1, 1, 1], [0.9, 0.1, -0.3, 0.3], [1, -2, 3], [2, 1, -1.0]))
    assert np.abs(held(y)[1] - differences(lambda y: held(y)[0], y)).max() < LIMIT
    assert len(held(y)[0]) == 7
    assert np.linalg.matrix_rank(held(y)[1]) == 7
