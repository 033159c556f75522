# SPDX-License-Identifier: LGPL-2.1-or-later
"""Off a saddle: an equilibrium that a cable would leave."""

STEPS = 3
"""Saddles that are left one after the other."""


def descended(trial, solve, size, enough):
    """Follow the least stable variation down both sides, to a minimum if one is found.

    ``solve(shape)`` gives a trial or None, ``size`` is how far a node moves at most, relative to the length; a trial
    that is ``enough`` is not left."""
    for _ in range(STEPS):
        if enough(trial):
            return trial
        found = [solve(trial.swayed(sway)) for sway in (size, -size)]
        below = [each for each in found if each is not None and each.energy < trial.energy]
        if not below:
            return trial
        trial = min(below, key=lambda each: each.energy)
    return trial
