# SPDX-License-Identifier: LGPL-2.1-or-later
"""Off a saddle: an equilibrium that a cable would leave."""

import numpy as np

STEPS = 3
"""Saddles that are left one after the other."""
LEVEL = 1e-8
"""Difference of energies, without units, that says nothing: the solvers leave as much."""


def descended(trial, solve, size, enough):
    """Follow the least stable variation down both sides, to a minimum if one is found.

    ``solve(shape)`` gives a trial or None, ``size`` is how far a node moves at most, relative to the length; a trial
    that is ``enough`` is not left."""
    for _ in range(STEPS):
        if enough(trial):
            return trial
        found = [solve(trial.swayed(sway)) for sway in (size, -size)]
        found = [each for each in found if each is not None]
        lowest = min((each.energy for each in found), default=np.inf)
        if lowest > trial.energy + LEVEL:
            return trial
        # Two may be images of each other: the cable goes to the nearer one.
        level = [each for each in found if each.energy < lowest + LEVEL]
        trial = min(level, key=lambda each: (not enough(each), _away(trial, each)))
    return trial


def _away(one, other):
    """How far a node moves, and how far it turns, from one trial to the other."""
    a, b = one.shape, other.shape.on(one.shape.arc_length)
    moved = np.linalg.norm(a.position - b.position, axis=1).max()
    return moved + np.sqrt(1 - np.abs(np.einsum("ki,ki->k", a.quaternion, b.quaternion)).min())
