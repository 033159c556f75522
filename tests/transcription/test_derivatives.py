# SPDX-License-Identifier: LGPL-2.1-or-later
"""The derivatives that are written block by block against those that CasADi makes of the whole program."""

import casadi as ca
import numpy as np
import pytest

from freecad_cable.transcription.nlp import build
from freecad_cable.transcription.structure import Structure

STRUCTURES = [
    Structure("magnus", (4,), "clamped", "clamped", (0, 1, 2)),
    Structure("magnus", (3,), "free", "clamped", (0, 1, 2, 3, 4, 5)),
    Structure("magnus", (3,), "pinned", "pinned", (0, 1, 5)),
    Structure("helix", (4,), "pinned", "swivel", (0, 1)),
    Structure("helix", (3,), "swivel", "pinned", (0, 1, 2, 5)),
    Structure("magnus", (2, 2), "clamped", "swivel", (0, 1), ("sleeve",), (False,)),
    Structure("magnus", (2, 1, 2), "pinned", "free", (0, 1, 2), ("ring", "sleeve"), (True, False)),
    Structure("magnus", (2, 2), "clamped", "clamped", (0, 1, 2, 5), ("clamp",), (True,)),
    Structure("helix", (1, 2), "clamped", "clamped", (0, 1, 2), ("eyelet",), (True,)),
    Structure("magnus", (1, 2), "free", "clamped", (0, 1), ("ring",), (True,), 2, True),
    Structure("helix", (3,), "pinned", "free", (0, 1), contacts=1, bend_limit=True),
    Structure("magnus", (5,), "clamped", "free", (0, 1), links=((0, 3), (1, 3), (1, 4))),
    Structure(
        "magnus",
        (2, 3),
        "clamped",
        "pinned",
        (0, 1, 2),
        ("ring",),
        (True,),
        1,
        False,
        ((0, 2), (1, 2)),
    ),
]


@pytest.mark.parametrize("structure", STRUCTURES, ids=str)
def test_derivatives(structure):
    nlp = build(structure)
    factor, multipliers = nlp.multipliers
    lagrangian = factor * nlp.f + ca.dot(multipliers, nlp.g)
    hessian = ca.hessian(lagrangian, nlp.x)[0]
    inputs = [nlp.x, nlp.p, factor, multipliers]
    outputs = [
        nlp.hessian - hessian,
        nlp.jacobian - ca.jacobian(nlp.g, nlp.x),
    ]
    difference = ca.Function("difference", inputs, [*outputs, hessian, nlp.jacobian])
    random = np.random.default_rng(1)
    values = [random.normal(size=symbol.shape) for symbol in inputs]
    found = [np.abs(part.full()).max() for part in difference(*values)]
    # Rounding of some thousand operations.
    for error, size in zip(found[:2], found[2:], strict=True):
        assert error < 1e-13 * size


def test_the_quaternion_keeps_its_norm():
    nlp = build(STRUCTURES[0])
    random = np.random.default_rng(2)
    x = random.normal(size=nlp.x.numel()) * 0.5
    q = x[nlp.states[0, 3:7]]
    x[3:7] = q / np.linalg.norm(q)
    p = np.abs(random.normal(size=nlp.p.numel()))
    gaps = ca.Function("g", [nlp.x, nlp.p], [nlp.g])(x, p).full().ravel()
    reached = x[nlp.states[1, 3:7]] - gaps[nlp.gaps[0] + 3 : nlp.gaps[0] + 7]
    # The power series of the turn are cut at 1e-12 for one radian.
    assert np.linalg.norm(reached) == pytest.approx(1, abs=1e-9)
