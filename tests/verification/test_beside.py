# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cable that is dragged beside obstacles: as cheap as without them, but not through them."""

import numpy as np
import pytest

from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.problem import Cylinder, Pinned, Rod, Scene, round_section

ROD = Rod(length=0.3, **round_section(0.007, 10e6, 20e6, 1160.0))
ROOM, PIN = 2e-3, 1e-3
AT = ROOM + PIN + ROD.radius


def hanging(y, pins=(AT,)) -> Scene:
    """A cable in the plane at y, and upright pins beside its middle; at y = 0 it has ``ROOM`` to the first."""
    obstacles = tuple(Cylinder([0.1, at, -0.3], [0.1, at, 0.3], PIN) for at in pins)
    start, end = Pinned([0, y, 0]), Pinned([0.2, y, 0])
    return Scene(rod=ROD, start=start, end=end, gravity=[0, 0, -9.81], obstacles=obstacles)


@pytest.mark.parametrize("y", [0.75 * ROOM, -3 * ROOM])
def test_what_is_beside_costs_nothing(y):
    found, alone = (
        find_equilibrium(hanging(y, pins), start=find_equilibrium(hanging(0.0, pins)))
        for pins in ((AT, AT + 0.03), ())
    )
    assert found.contacts == ()
    assert found.solver["iterations"] == alone.solver["iterations"]
    assert np.array_equal(found.position, alone.position)


def test_it_follows_a_pin_that_moves_away():
    """Farther than a cable that touches looks beside itself; it would be on the other side of it by now."""
    found = None
    for y in np.linspace(0.0, AT + 0.03, 12):
        found = find_equilibrium(hanging(y), start=found).raise_for_status()
    assert len(found.contacts) == 1
    away = AT + 0.03 * ROD.length
    followed = find_equilibrium(hanging(y, (away,)), start=found).raise_for_status()
    assert len(followed.contacts) == 1
    assert followed.position[:, 1].min() < away - ROD.radius


def test_it_does_not_hop_over_a_pin():
    y = AT + 2 * ROOM + ROD.radius
    before = find_equilibrium(hanging(0.0)).raise_for_status()
    assert find_equilibrium(hanging(y)).contacts == ()
    held = find_equilibrium(hanging(y), start=before).raise_for_status()
    assert len(held.contacts) == 1
    assert held.contacts[0].force[1] < 0
    assert held.position[:, 1].min() < AT
