# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cables among obstacles that are found longer, and drawn in."""

from dataclasses import replace

import numpy as np
import pytest

from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.options import SolveOptions
from freecad_cable.problem import Box, Clamped, Rod, Scene
from freecad_cable.problem.reduce import reduce
from freecad_cable.solve.drawing_in import LONGER, drawn_in
from freecad_cable.solve.letting_out import as_long
from freecad_cable.solve.problem import Problem
from freecad_cable.solve.search import find as search
from tests.verification.test_laying import assert_rests

WALLS = [
    ([0, 0.01353, 0], [0.1393, 0.02, 0.01977]),
    ([0, -0.01353, 0], [0.1393, 0.02, 0.01977]),
    ([0, 0, -0.01989], [0.1393, 0.04706, 0.02]),
    ([0, 0, 0.01989], [0.1393, 0.04706, 0.02]),
]
DUCT = Scene(
    rod=Rod(
        length=0.2036,
        radius=0.002127,
        mass_per_length=0.02759,
        bending_stiffness=[0.0009288, 0.005379],
        torsional_stiffness=0.0007141,
    ),
    start=Clamped([0, 0, 0], [0.7685, -0.1454, 0.6228, 0.0210]),
    end=Clamped([0.1741, -0.00116, 0], [0.7940, -0.0570, 0.5973, -0.0972]),
    obstacles=tuple(Box(np.add([0.08704, 0, 0], at), [1, 0, 0, 0], size) for at, size in WALLS),
    options=SolveOptions(time_limit=60.0),
)
"""A cable that is pressed into a duct hardly wider than it, between clamps that are turned against each other."""


def test_found():
    assert_rests(find_equilibrium(DUCT).raise_for_status())


def test_from_a_longer_one():
    asked = []

    def find(problem, _):
        asked.append(problem.scene.rod.length)
        return found

    problem = Problem.of(DUCT, reduce(DUCT))
    longer = as_long(problem, LONGER[0])
    found = search(longer)
    trial = drawn_in(problem, find)
    assert asked == [pytest.approx(LONGER[0] * DUCT.rod.length)]
    assert trial.stable and trial.touches
    assert trial.nlp.structure.contacts
    assert not problem.surroundings.deepest(trial.shape)


def test_where_it_is_not_to_be_had():
    problem = Problem.of(DUCT, reduce(DUCT))
    asked = []
    assert drawn_in(problem, lambda problem, _: asked.append(problem.scene.rod.length)) is None
    assert asked == pytest.approx([factor * DUCT.rod.length for factor in LONGER])
    options = replace(DUCT.options, elements=64)
    fixed = Problem.of(replace(DUCT, options=options), reduce(DUCT))
    assert drawn_in(fixed, None) is None
