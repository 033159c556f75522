# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves of a given length between given ends, and the interpolating spline."""

import math

import numpy as np
import pytest
from scipy.integrate import quad

from freecad_cable.errors import ProblemError
from freecad_cable.geometry import rotation
from freecad_cable.geometry.curves import catenary, hermite, spline
from freecad_cable.geometry.guess import perpendicular

X, Y, Z = np.eye(3)
TANGENTS = {
    "along the chord": (X, X),
    "against the chord": (-X, -X),
    "towards each other": (X, -X),
    "away from each other": (-X, X),
    "across, antiparallel": (Z, -Z),
    "across, parallel": (Z, Z),
    "skew": (Y, Z),
    "end free": (X, None),
    "start free": (None, -X),
    "both free": (None, None),
}
CHORDS = [1.0, 1 - 1e-13, 1 - 1e-9, 0.999, 0.9, 0.5, 0.25, 0.05, 1e-3, 1e-9, 0.0]


def polygon_length(curve):
    return np.linalg.norm(np.diff(curve.position, axis=0), axis=1).sum()


def assert_is_a_curve(curve, start, end, length):
    """Ends and length are kept; polygon and unit tangents belong to one curve.

    The polygon of m chords is short by ∫ κ² h² / 24 ds; with 200 samples or more and κ L below 60 that
    is below 1e-3, and tighter bends (short, near the ends of taut curves) weigh less than their
    length.
    """
    assert curve.arc_length[0] == 0 and np.all(np.diff(curve.arc_length) > 0)
    assert curve.length == pytest.approx(length, rel=1e-12)
    assert np.abs(curve.position[0] - start).max() <= 1e-13 * length
    assert np.abs(curve.position[-1] - end).max() <= 1e-13 * length
    assert np.abs(np.linalg.norm(curve.tangent, axis=1) - 1).max() < 1e-12
    assert polygon_length(curve) == pytest.approx(length, rel=1e-3)


@pytest.mark.parametrize("chord", CHORDS)
@pytest.mark.parametrize("name", TANGENTS)
@pytest.mark.parametrize("bulge", [None, -20 * Z, -1e6 * Z, 20 * X])
def test_hermite_exists_for_every_length_from_the_chord_up(name, chord, bulge):
    start = np.array([0.3, -0.2, 0.1])
    end = start + chord * X
    first, last = TANGENTS[name]
    curve = hermite(start, first, end, last, 1.0, bulge)
    assert_is_a_curve(curve, start, end, 1.0)
    if chord < 1 - 1e-12:
        for tangent, found in ((first, curve.tangent[0]), (last, curve.tangent[-1])):
            assert tangent is None or np.abs(found - tangent).max() < 1e-9


@pytest.mark.parametrize("chord", [c for c in CHORDS if c <= 0.5])
@pytest.mark.parametrize("name", TANGENTS)
def test_slack_hermite_has_no_cusp(name, chord):
    """A circle of this length has radius L/2π, a fold none; a tenth tells them apart."""
    curve = hermite(0 * X, TANGENTS[name][0], chord * X, TANGENTS[name][1], 1.0)
    assert curve.smallest_bend_radius()[0] > 0.1 / (2 * math.pi)


def test_hermite_in_any_direction_and_size():
    random = np.random.default_rng(1)
    for _ in range(30):
        start, end, first, last = random.normal(size=(4, 3)) * 10.0 ** random.integers(-3, 4)
        first, last = first / np.linalg.norm(first), last / np.linalg.norm(last)
        length = np.linalg.norm(end - start) * (1 + 10.0 ** random.integers(-6, 2))
        assert_is_a_curve(hermite(start, first, end, last, length), start, end, length)


def test_bulge_says_where_the_slack_goes():
    for side in (Y, -Y, Z, -Z):
        curve = hermite(0 * X, X, 0.7 * X, X, 1.0, 1e-3 * side)
        assert (curve.position @ side).max() > 0.2
        curve = hermite(0 * X, None, 0.7 * X, None, 1.0, 1e-3 * side)
        assert (curve.position @ side).max() > 0.2


def test_bulge_that_leans_along_the_chord_bulges_straight_away_from_it():
    curve = hermite(0 * X, X, 0.7 * X, X, 1.0, 1e-3 * (X + Y + Z))
    assert curve.position[:, 1].max() > 0.2
    assert np.abs(curve.position[:, 1] - curve.position[:, 2]).max() < 1e-12
    assert curve.position[100, 0] == pytest.approx(0.35, abs=1e-9)


@pytest.mark.parametrize("turn", np.linspace(0.1, 3.1, 16))
def test_of_mirror_images_not_rounding_decides(turn):
    """Without weight, tangents along the chord leave four sides alike but for rounding: the first of them is taken."""
    along = rotation.rotate(rotation.exponential(turn * np.array([0.6, -0.64, 0.48])), X)
    curve = hermite(0 * X, along, 0.3 * along, along, 1.0)
    assert curve.position[100] @ perpendicular(along) > 0.1


def test_weight_decides_against_bending():
    """Both ends lead into an arch: a stiff rod makes it, one with w L³/EI = 500 hangs."""
    up, down = (X + 0.5 * Z) / math.sqrt(1.25), (X - 0.5 * Z) / math.sqrt(1.25)
    assert hermite(0 * X, up, 0.7 * X, down, 1.0, -1 * Z).position[100, 2] > 0.2
    assert hermite(0 * X, up, 0.7 * X, down, 1.0, -500 * Z).position[100, 2] < -0.2


def test_free_tangents_give_an_arc():
    """L = 2 r φ and chord = 2 r sin φ with φ = 1 (the curvature is of third order in 1/400)."""
    curve = hermite(0 * X, None, math.sin(1) * X, None, 1.0, -Z)
    radius, _ = curve.smallest_bend_radius()
    assert radius == pytest.approx(0.5, rel=1e-6)
    assert curve.position[:, 2].min() == pytest.approx(-0.5 * (1 - math.cos(1)), rel=1e-12)


def test_at_interpolates_position_and_tangent():
    curve = hermite(0 * X, Y, 0.5 * X, Z, 1.0)
    s = np.linspace(0, 1, 1234)
    position, tangent = curve.at(s)
    assert np.abs(np.linalg.norm(tangent, axis=1) - 1).max() < 1e-14
    # Central differences over 2/1233 of a curve with κ L ~ 20 (third derivative below 1e3): 1e3
    # h²/6.
    slope = (position[2:] - position[:-2]) / (s[2:] - s[:-2])[:, None]
    assert np.abs(slope - tangent[1:-1]).max() < 1.2e-4
    point, direction = curve.at(0.25)
    assert point.shape == direction.shape == (3,)


@pytest.mark.parametrize("length", [0.9, 0.0, -1.0, math.nan, math.inf])
def test_impossible_lengths_are_named(length):
    for make in (
        lambda: hermite(0 * X, X, X, X, length),
        lambda: catenary(0 * X, X, length, -Z),
    ):
        with pytest.raises(ProblemError, match="length"):
            make()


def test_catenary_against_its_closed_form():
    """X = 1, L = 1.5, V = 0 and 0.3: y = c cosh((x − a)/c) + b, c and lowest point to 12 digits."""
    for rise, c, lowest in (
        (0.0, 0.308236469736, -0.502633261648),
        (0.3, 0.316905698276, -0.349864632049),
    ):
        curve = catenary(0 * X, X + rise * Z, 1.5, -9.81 * Z)
        assert_is_a_curve(curve, 0 * X, X + rise * Z, 1.5)
        position, _ = curve.at(np.linspace(0, 1.5, 100001))
        assert position[:, 2].min() == pytest.approx(lowest, abs=1e-8)
        # c is the radius at the lowest point; the samples nearest to it miss it by δ²/c², δ <
        # 1.5/300.
        assert curve.smallest_bend_radius()[0] == pytest.approx(c, rel=3e-4)


@pytest.mark.parametrize("distance", [1.0, 1e-3, 1e-12, 0.0])
@pytest.mark.parametrize("rise", [0.0, 0.5, -0.5, 1.0])
@pytest.mark.parametrize("slack", [0, 1e-12, 1e-9, 1e-3, 20])
def test_catenary_exists_for_every_length_from_the_chord_up(distance, rise, slack):
    length = math.hypot(distance, rise) * (1 + slack) or 1.0
    end = distance * Y + rise * X
    assert_is_a_curve(catenary(0 * X, end, length, -2 * X), 0 * X, end, length)


@pytest.mark.parametrize("slack", [1e-5, 1e-8])
def test_taut_catenary_sags_like_a_parabola(slack):
    """L = X (1 + 8/3 (f/X)² − …), so f = X √(3/8 slack) to a relative error of the order of the slack."""
    curve = catenary(0 * X, X, 1 + slack, -Z)
    sag = -curve.at(curve.length / 2)[0][2]
    assert sag == pytest.approx(math.sqrt(3 / 8 * slack), rel=max(slack, 1e-7))


def test_catenary_hangs_down_and_up_on_a_vertical_chord():
    curve = catenary(0 * X, 0.4 * Z, 1.0, -Z)
    assert curve.position[:, 2].min() == pytest.approx(-0.3, abs=1e-5)
    with pytest.raises(ProblemError, match="gravity"):
        catenary(0 * X, X, 2.0, 0 * X)


def test_spline_of_two_points_is_the_hermite_cubic():
    """End derivatives of magnitude one over a parameter as long as the chord."""
    chord = 2.0
    curve = spline([0 * X, chord * X], Y, -Y)
    u = np.linspace(0, 1, 7)
    exact = np.outer(3 * u**2 - 2 * u**3, chord * X) + np.outer(chord * u * (1 - u), Y)

    def speed(u):
        return math.hypot(6 * chord * u * (1 - u), chord * (1 - 2 * u))

    length = quad(speed, 0, 1, epsabs=0, epsrel=1e-12)[0]
    assert curve.length == pytest.approx(length, rel=1e-9)
    s = np.array([quad(speed, 0, end, epsrel=1e-12)[0] for end in u])
    assert np.abs(curve.at(s)[0] - exact).max() < 1e-9 * length


def test_spline_passes_its_points_with_continuous_curvature():
    points = np.array([[0, 0, 0], [1, 1, 0], [2, 0, 1], [2.5, 0, 3]])
    curve = spline(points, X, None)
    for point in points:
        assert np.linalg.norm(curve.position - point, axis=1).min() < 1e-12
    assert np.abs(curve.tangent[0] - X).max() < 1e-12
    assert curve.curvature[-1] < 1e-4
    # C²: from sample to sample (some 200 a span) the curvature moves by a few percent of its
    # largest value.
    assert np.abs(np.diff(curve.curvature)).max() < 0.05 * curve.curvature.max()
    with pytest.raises(ProblemError, match="points"):
        spline([0 * X, 0 * X, X])
