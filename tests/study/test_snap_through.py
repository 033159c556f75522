# SPDX-License-Identifier: LGPL-2.1-or-later
"""Paths across snap-throughs whose critical values are known in closed form.

The closed forms of the arches hold for small slopes; what they leave out is of the order of the squared slope: with
an end shortening of 5, 2 and 1 ‰ the falls were found 2.1, 0.9 and 0.5 ‰ above. So 1 % leaves room for it ten times.
"""

import math

import numpy as np
import pytest
from scenes import strip, twisted
from scipy.integrate import trapezoid
from scipy.optimize import brentq

from freecad_cable.reference.buckling import twist
from freecad_cable.study import follow

SHORTENING = 2e-3
"""Of the arches, relative to their length."""


def jumps(scene_at, values):
    return [jump for step in follow(scene_at, values) for jump in step.jumps]


def pushed_through(shortening):
    """Weight at which a clamped arch of L = EI = 1 falls through.

    Its shape w under a load q hangs together by w'''' + k² w'' = −q, with the thrust k² that keeps its length,
    ½ ∫ w'² = e. It leaves its symmetry when the thrust is that of the antisymmetric mode, tan(k/2) = k/2: k =
    8.9868. With u from the middle, w' = −A k sin(k u) − q u/k² and w' = 0 at u = ½.
    """
    k = 2 * brentq(lambda x: math.tan(x) - x, 4.4, 4.6)
    u = np.linspace(-0.5, 0.5, 20001)
    slope = math.sin(k / 2) ** -1 * np.sin(k * u) / (2 * k**2) - u / k**2
    return math.sqrt(2 * shortening / trapezoid(slope**2, u))


def tilted_through(shortening):
    """Angle of one clamp, turned against an arch, at which it snaps.

    w'''' + k² w'' = 0 with w = w' = 0 at one end and w = 0, w' = −α at the other: w = α times a function of k, and
    ½ ∫ w'² = e gives α(k), whose maximum is the fold. (Gomez, Moulton, Vella, Nature Physics 13, 2017: α = 1.782 √e.)
    """

    def angle(k):
        s, x = np.linspace(0, 1, 4001), k
        # w = a (cos kx − 1) + b (sin kx − k x), with w(1) = 0 and w'(1) = 1.
        matrix = [
            [math.cos(x) - 1, math.sin(x) - x],
            [-x * math.sin(x), x * math.cos(x) - x],
        ]
        a, b = np.linalg.solve(matrix, [0.0, 1.0])
        slope = -a * k * np.sin(k * s) + b * k * (np.cos(k * s) - 1)
        return math.sqrt(2 * shortening / trapezoid(slope**2, s))

    # Between the arch at rest, k = 2π, and the antisymmetric mode.
    return max(angle(k) for k in np.linspace(6.4, 8.9, 2001))


def test_an_arch_is_pushed_through_by_its_weight():
    exact = pushed_through(SHORTENING)
    found = jumps(lambda q: strip(1 - SHORTENING, weight=q), np.linspace(-8, 16, 13))
    (jump,) = found
    assert not jump.buckling
    assert jump.before == pytest.approx(exact, rel=0.01)
    assert jump.after == pytest.approx(exact, rel=0.01)
    assert 0 < jump.after - jump.before <= 1e-3 * 24


@pytest.mark.parametrize("shortening", [1e-3, 2e-4])
def test_a_small_jump_in_the_first_step_is_seen(shortening):
    """It changes the shape by 3 and by 1 % of the length."""
    exact = pushed_through(shortening)
    values = exact * np.array([-1.2, 1.3, 1.6])
    (jump,) = jumps(lambda q: strip(1 - shortening, weight=q), values)
    assert jump.change < 0.05
    assert jump.value == pytest.approx(exact, rel=0.01)


def test_an_arch_snaps_when_its_clamp_is_turned():
    exact = tilted_through(SHORTENING)
    assert exact == pytest.approx(1.7818 * math.sqrt(SHORTENING), rel=1e-3)
    found = jumps(lambda tilt: strip(1 - SHORTENING, tilt), np.linspace(0.06, -0.12, 10))
    (jump,) = found
    assert not jump.buckling
    assert -jump.before == pytest.approx(exact, rel=0.01)
    assert -jump.after == pytest.approx(exact, rel=0.01)


def test_the_way_back_is_another():
    """An arch that has snapped stays where it is until the clamp is turned as far to the other side."""
    there = np.linspace(0.06, -0.12, 10)
    way = [*there, *there[::-1][1:], 0.12]
    found = jumps(lambda tilt: strip(1 - SHORTENING, tilt), way)
    assert [round(jump.value, 2) for jump in found] == [-0.08, 0.08]


def test_a_twisted_cable_leaves_the_straight_line_at_the_critical_turn():
    """Greenhill: the torque at which a rod between clamps under the tension EA ε buckles, and the turn GJ gives
    it."""
    exact = twist(20.0) / 0.8
    found = jumps(lambda turn: twisted(turn, 0.02, 1e3), np.arange(0.0, 17.0, 1.0))
    assert found
    assert found[0].before == pytest.approx(exact, rel=0.01)
    assert found[0].after == pytest.approx(exact, rel=0.01)


def test_a_twisted_cable_forms_a_loop_and_keeps_its_turns():
    """Between ends that hardly pull. Clamps do not count turns, so straight with two of them fewer it would be in
    balance too, with a hundredth of the energy; what is twisted cannot get there."""
    steps = list(follow(lambda turn: twisted(turn, 0.0, 100.0), np.arange(0.0, 17.0, 1.0)))
    (jump,) = (jump for step in steps for jump in step.jumps)
    exact = twist(0.0) / 0.8
    assert jump.before == pytest.approx(exact, rel=0.01)
    assert jump.after == pytest.approx(exact, rel=0.01)
    looped = steps[-1].solution
    assert np.abs(looped.position[:, 1:]).max() > 0.15
    straight = 0.8 * steps[-1].value ** 2 / 2
    assert 0.9 * straight < looped.energy.total < straight


def test_no_jump_without_one():
    assert jumps(lambda q: strip(1 - SHORTENING, weight=q), np.linspace(-8, 4, 4)) == []
