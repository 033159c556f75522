# SPDX-License-Identifier: LGPL-2.1-or-later
"""First arc lengths of the places that hold a cable."""

import numpy as np
import pytest

from freecad_cable.problem import Clamped, Free, Ring, Rod, Scene
from freecad_cable.transcription.guess import guess
from freecad_cable.transcription.scaling import Scaling
from freecad_cable.transcription.waypoints import breaks

ROD = Rod(
    length=1.0,
    radius=0.001,
    mass_per_length=1.0,
    bending_stiffness=1.0,
    torsional_stiffness=1.0,
)


def places(*positions, arc_length=(None, None, None)):
    rings = [
        Ring(position, [1, 0, 0], 0.01, arc_length=s)
        for position, s in zip(positions, arc_length, strict=False)
    ]
    start = Clamped([0, 0, 0], [1, 0, 0, 0], place="start")
    end = Clamped([0.8, 0, 0], [1, 0, 0, 0])
    scene = Scene(rod=ROD, start=start, end=end, supports=rings)
    return np.array(breaks(scene, Scaling.of(scene)))


def test_given_ones_stay_and_the_others_are_between():
    found = places([0.2, 0, 0], [0.4, 0, 0], [0.6, 0, 0], arc_length=(None, 0.5, None))
    assert found[1] == 0.5
    assert found == pytest.approx([0.25, 0.5, 0.75])


def test_no_stretch_is_shorter_than_its_chord_or_has_no_length():
    found = places([0.2, 0, 0], [0.2, 0, 0], [0.79, 0, 0])
    stretches = np.diff([0.0, *found, 1.0])
    chords = np.array([0.2, 0.0, 0.59, 0.01])
    assert (stretches >= chords).all()
    # A stretch of less than a thousandth is where the program stops it (SHORTEST).
    assert stretches.min() > 1e-3
    # The longest takes the slack: it gives way under the least force.
    assert np.argmax(stretches - chords) == 2


def test_the_last_node_is_there_when_only_the_end_is_held():
    end = Clamped([0.8, 0, 0], [1, 0, 0, 0])
    scene = Scene(rod=ROD, start=Free(place="start"), end=end)
    nodes = guess(scene, Scaling.of(scene), np.linspace(0, 1, 9))
    assert nodes.position.shape == (9, 3)
    assert nodes.position[-1] == pytest.approx(np.zeros(3), abs=1e-12)
