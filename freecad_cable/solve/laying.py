# SPDX-License-Identifier: LGPL-2.1-or-later
"""A heavy cable that is not found among obstacles: laid there when it is light, and made heavier step by step.

A light cable bends widely and touches in few places. More weight lets it down onto more of what is below it, and each
step starts in contact.
"""

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from .contact import handed_on
from .problem import Problem
from .stepping import stepped
from .trial import Trial

LIGHT = (50.0, 20.0, 100.0)
"""Weight ratios with which it is laid: another where the first is caught somewhere."""
FACTOR, LEAST = 4.0, 1.1
"""Growth of the weight in one step; the least that is tried."""
ROUGH = 1e-3
"""Error, relative to the length, of a shape on the way: from there its mesh can follow."""


def laden(problem: Problem, find: Callable[[Problem, None], Trial | None]) -> Trial | None:
    """The equilibrium of a cable that ``find`` finds when it is lighter; None if it does not, or a step does not
    arrive."""
    ratio = problem.scaling.weight_ratio
    if problem.scene.options.elements is not None:
        return None
    for load in (light / ratio for light in LIGHT if 2 * light < ratio):
        now = _under(problem, load)
        found = find(now, None)
        if found is not None and found.stable:
            return _heavier(problem, now, found, load)
    return None


def _heavier(problem, now, found, load):
    def advance(state, _, ahead, __):
        now, found = state
        then = problem if ahead == 1 else _under(problem, load ** (1 - ahead))
        # What was known of the error says nothing of that under more weight.
        return handed_on(now, found, then, np.inf)

    longest, shortest = np.log([FACTOR, LEAST]) / -np.log(load)
    state = stepped((now, found), advance, longest, shortest)
    return None if state is None else state[1]


def _under(problem, load):
    """The same cable under a share of its weight, roughly."""
    scene = problem.scene
    options = replace(scene.options, tolerance=max(ROUGH, scene.options.tolerance))
    return problem.eased(replace(scene, gravity=load * scene.gravity, options=options))
