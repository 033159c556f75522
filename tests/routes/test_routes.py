# SPDX-License-Identifier: LGPL-2.1-or-later
"""Routes: what they pass, how long they are, how tight, and how their length is compared."""

import math

import numpy as np
import pytest

from freecad_cable.errors import ProblemError
from freecad_cable.problem import Clamped, Free, Pinned, Rod, Scene, Swivel
from freecad_cable.problem.supports import Support
from freecad_cable.routes import (
    METHODS,
    catenary_route,
    chord_route,
    compare,
    inputs,
    spline_route,
)

ROD = {
    "radius": 0.003,
    "mass_per_length": 0.04,
    "bending_stiffness": 1e-3,
    "torsional_stiffness": 1e-3,
}


def scene(start, end, length=2.0, supports=(), gravity=(0, 0, -9.81)):
    return Scene(
        rod=Rod(length=length, **ROD), start=start, end=end, supports=supports, gravity=gravity
    )


def support(x, y, z):
    return Support((x, y, z))


START = Pinned((0, 0, 0), place="start")
END = Pinned((1, 0, 0))


def test_spline_leaves_and_arrives_along_the_terminals_and_passes_the_supports():
    turn = (math.sqrt(0.5), 0, math.sqrt(0.5), 0)
    route = spline_route(
        scene(
            Swivel((0, 0, 0), (0, 0, 2), place="start"),
            Clamped((1, 0, 0), turn),
            supports=(support(0.3, 0.2, 0.1), support(0.6, -0.2, 0.1)),
        )
    )
    assert np.abs(route.tangent[0] - (0, 0, 1)).max() < 1e-12
    assert np.abs(route.tangent[-1] - (1, 0, 0)).max() < 1e-12  # R(turn) e3
    for point in ((0, 0, 0), (0.3, 0.2, 0.1), (0.6, -0.2, 0.1), (1, 0, 0)):
        assert np.linalg.norm(route.position - point, axis=1).min() < 1e-12
    assert route.length > 1
    assert 0 < route.smallest_bend_radius < route.length / (2 * math.pi)


def test_spline_between_pinned_ends_is_straight():
    route = spline_route(scene(START, END))
    assert route.length == pytest.approx(1, rel=1e-12)
    assert route.smallest_bend_radius == math.inf


def test_catenary_has_the_length_of_the_cable_and_hangs():
    route = catenary_route(scene(START, END, length=1.5))
    assert route.length == pytest.approx(1.5, rel=1e-12)
    # Sag of the catenary with X = 1, L = 1.5: c (cosh(1/2c) − 1), c = .308236469736; its lowest
    # sample is within half a spacing of 1.5/300 of the lowest point, where the curve has radius c.
    assert route.position[:, 2].min() == pytest.approx(-0.502633261648, abs=0.0025**2 / (2 * 0.308))
    with pytest.raises(ProblemError, match="gravity"):
        catenary_route(scene(START, END, gravity=(0, 0, 0)))


def test_chord_is_straight_or_has_corners():
    straight = chord_route(scene(START, END, supports=(support(0.3, 0, 0), support(0.3, 0, 0))))
    assert straight.length == pytest.approx(1, rel=1e-15)
    assert straight.smallest_bend_radius == math.inf
    corner = chord_route(
        scene(START, END, length=3.0, supports=(support(0.25, 0, 0), support(0.25, 1, 0)))
    )
    assert corner.length == pytest.approx(1.25 + math.hypot(0.75, 1), rel=1e-15)
    assert (corner.smallest_bend_radius, corner.smallest_bend_radius_at) == (0, 0.25)
    assert corner.position.tolist() == [[0, 0, 0], [0.25, 0, 0], [0.25, 1, 0], [1, 0, 0]]
    assert len(corner.tangent) == len(corner.arc_length) == 4


def test_difference_says_its_base():
    difference = compare(chord_route(scene(START, END)).length, 1.25)
    assert difference.absolute == pytest.approx(-0.25, rel=1e-15)
    assert difference.relative == pytest.approx(-0.2, rel=1e-15)
    assert difference.base == 1.25


@pytest.mark.parametrize("method", METHODS)
def test_a_free_end_has_no_route(method):
    with pytest.raises(ProblemError, match="end: is free"):
        METHODS[method](scene(Clamped((0, 0, 0), (1, 0, 0, 0), place="start"), Free()))


@pytest.mark.parametrize("method", METHODS)
def test_routes_know_their_method(method):
    assert METHODS[method](scene(START, END)).method == method


@pytest.mark.parametrize("method", METHODS)
def test_whatever_changes_a_route_is_among_its_inputs(method):
    tilted = Swivel((0, 0, 0), (0, 1, 2), place="start")
    turned = Clamped((1, 0, 0), (math.sqrt(0.5), 0, math.sqrt(0.5), 0))
    plain = {"start": Swivel((0, 0, 0), (0, 0, 1), place="start"), "end": END}
    changes = [
        {"start": tilted},
        {"end": turned},
        {"end": Pinned((1, 0, 0.1))},
        {"length": 2.1},
        {"gravity": (0, -9.81, 0)},
        {"supports": (support(0.3, 0.2, 0.1),)},
    ]
    before = scene(**plain)
    drawn = METHODS[method](before).position
    moved = []
    for change in changes:
        after = scene(**plain | change)
        if not np.array_equal(METHODS[method](after).position, drawn):
            moved += change
            assert repr(inputs(method, after)) != repr(inputs(method, before)), change
    assert "end" in moved
    same = repr(inputs(method, scene(**plain, length=2.1))) == repr(inputs(method, before))
    assert same == ("length" not in moved)


def test_chord_of_coinciding_ends_is_refused():
    with pytest.raises(ProblemError, match="end.position"):
        chord_route(scene(START, Pinned((0, 0, 0))))
