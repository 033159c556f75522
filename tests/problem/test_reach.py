# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a cable reaches: what is too short, out of order or too narrow is named with its place and its numbers."""

from itertools import product

import numpy as np
import pytest

from freecad_cable.errors import ProblemError
from freecad_cable.problem import Clamp, Clamped, Clip, Free, Ring, Rod, Scene, Sleeve
from freecad_cable.problem.reach import Station, shortest_way

FRAME = [1.0, 0, 0, 0]
X = [1.0, 0, 0]


def scene(*supports, start=None, end=None, **rod):
    values = {
        "length": 1.0,
        "radius": 0.01,
        "mass_per_length": 0.1,
        "bending_stiffness": 1.0,
        "torsional_stiffness": 1.0,
    }
    return Scene(
        rod=Rod(**(values | rod)),
        start=start or Clamped([0, 0, 0], FRAME, place="start"),
        end=end or Free(),
        supports=supports,
    )


def ring(i, position, radius=0.01, arc_length=None):
    return Ring(position, X, radius, arc_length=arc_length, place=f"supports[{i}]")


def clip(i, position, arc_length):
    return Clip(position, X, arc_length=arc_length, place=f"supports[{i}]")


FREE, OFF = Free(place="start"), Clamped([0.6, 0, 0], FRAME)
WRONG = {
    "the cable is shorter than its chord": (
        {"end": Clamped([1.1, 0, 0], FRAME)},
        "cable.length",
        ("1 m", "1.1 m"),
    ),
    "and than the way through its supports": (
        {"supports": [ring(0, [0.3, 0.5, 0])], "end": OFF},
        "cable.length",
        ("way through its supports", "1.16619 m"),
    ),
    "a ring beyond the free end": (
        {"supports": [ring(0, [0, 1.2, 0])]},
        "supports[0]",
        ("1.2 m away from start", "only 1 m"),
    ),
    "a ring beyond the free start": (
        {"supports": [ring(0, [0, 0.6, 0]), clip(1, [0, 0, 0], 0.5)], "start": FREE},
        "supports[0]",
        ("0.6 m away from supports[1]", "only 0.5 m"),
    ),
    "two rings before a free end": (
        {"supports": [ring(0, [0.4, 0.4, 0]), ring(1, [0.8, 0, 0])]},
        "supports[1]",
        ("1.13137 m away from start",),
    ),
    "two clips closer than the cable between them": (
        {"supports": [clip(0, [0.2, 0, 0], 0.3), clip(1, [0.6, 0, 0], 0.65)]},
        "supports[1].arc_length",
        ("0.35 m of cable between supports[0] and supports[1]", "0.4 m apart"),
    ),
    "a ring between two clips": (
        {
            "supports": [
                clip(0, [0.2, 0, 0], 0.3),
                ring(1, [0.3, 0.3, 0]),
                clip(2, [0.4, 0, 0], 0.8),
            ]
        },
        "supports[2].arc_length",
        ("0.5 m of cable", "the way through the supports between them is 0.632456 m"),
    ),
    "a clip and the end": (
        {"supports": [clip(0, [0.1, 0, 0], 0.6)], "end": OFF},
        "supports[0].arc_length",
        ("0.4 m of cable between supports[0] and end", "0.5 m apart"),
    ),
    "out of order": (
        {"supports": [clip(0, [0.1, 0, 0], 0.6), ring(1, [0, 0.1, 0], arc_length=0.4)]},
        "supports[1].arc_length",
        ("0.4 m", "supports[0] before it is at 0.6 m", "in order"),
    ),
    "out of order past a sliding one": (
        {
            "supports": [
                clip(0, [0.1, 0, 0], 0.6),
                ring(1, [0.1, 0.1, 0]),
                clip(2, [0.1, 0.1, 0.1], 0.6),
            ]
        },
        "supports[2].arc_length",
        ("0.6 m", "in order"),
    ),
    "not on the cable": (
        {"supports": [clip(0, [0.1, 0, 0], 1.0)]},
        "supports[0].arc_length",
        ("not on the cable", "1 m"),
    ),
    "a ring that the cable does not pass": (
        {"supports": [ring(0, [0.1, 0, 0], 0.0099)]},
        "supports[0].radius",
        ("0.0099 m", "0.01 m"),
    ),
    "nothing but sliding supports": (
        {"supports": [ring(0, [0.1, 0, 0])], "start": FREE},
        "supports",
        ("slide out",),
    ),
}


@pytest.mark.parametrize("case", WRONG)
def test_what_cannot_be_is_named(case):
    given, field, words = WRONG[case]
    given = dict(given)
    with pytest.raises(ProblemError) as caught:
        scene(*given.pop("supports", ()), **given)
    assert caught.value.field == field
    for word in words:
        assert word in caught.value.message


def test_what_just_reaches_is_accepted():
    scene(ring(0, [0, 1.0, 0]))
    scene(clip(0, [0.2, 0, 0], 0.3), clip(1, [0.6, 0, 0], 0.7001))
    scene(ring(0, [0.3, 0.4, 0]), end=OFF)
    scene(clip(0, [0, 0, 0], 0.2), start=FREE)
    # A ring of radius r lets the centreline pass within r less the cable's radius.
    scene(ring(0, [0.3, 0.5, 0], radius=0.26), end=OFF)
    # One that stretches is taken at its word.
    scene(ring(0, [0.3, 0.5, 0]), end=OFF, axial_stiffness=100.0)


@pytest.mark.parametrize(
    ("make", "field"),
    [
        (lambda: Clamp([0, 0, 0], [0, 0, 0, 0], place="supports[3]"), "supports[3].quaternion"),
        (lambda: Sleeve([0, 0], X, place="supports[3]"), "supports[3].position"),
        (lambda: Sleeve([0, 0, 0], [0, 0, 0], place="supports[3]"), "supports[3].tangent"),
        (lambda: Ring([0, 0, 0], [0, 0, 0], 1, place="supports[3]"), "supports[3].axis"),
        (lambda: Ring([0, 0, 0], X, 0, place="supports[3]"), "supports[3].radius"),
        (lambda: clip(3, [0, 0, 0], 0.0), "supports[3].arc_length"),
        (lambda: clip(3, [0, 0, 0], float("nan")), "supports[3].arc_length"),
    ],
)
def test_a_support_that_is_wrong_in_itself(make, field):
    with pytest.raises(ProblemError) as caught:
        make()
    assert caught.value.field == field


def test_the_shortest_way_is_a_lower_bound():
    """No curve through balls in order, here polygons through random points of them, is shorter."""
    random = np.random.default_rng(3)
    for count, _ in product((2, 3, 5), range(20)):
        centres = random.normal(size=(count, 3))
        plays = random.uniform(0, 0.7, count) * (random.random(count) < 0.6)
        held = [Station("", c, p, None) for c, p in zip(centres, plays, strict=True)]
        bound = shortest_way(held)
        inside = random.normal(size=(200, count, 3))
        inside /= np.linalg.norm(inside, axis=2, keepdims=True)
        ways = np.diff(centres + inside * plays[:, None], axis=1)
        lengths = np.linalg.norm(ways, axis=2).sum(axis=1)
        assert bound <= lengths.min() + 1e-12
        if not plays.any():
            assert bound == pytest.approx(lengths[0], rel=1e-12)
