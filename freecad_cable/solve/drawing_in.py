# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cable that is not found among obstacles: found longer, and drawn in step by step.

A longer cable has more ways past what it meets, and each step starts in contact.
"""

from collections.abc import Callable

from .contact import handed_on, rests
from .letting_out import as_long
from .problem import Problem
from .stepping import stepped
from .trial import Trial

LONGER = (1.15, 1.3)
"""Length that it is found with, over its own: another where none is found with the first."""
LONGEST, SHORTEST = 1 / 3, 1 / 24
"""Steps, as shares of the way."""


def drawn_in(problem: Problem, find: Callable[[Problem, None], Trial | None]) -> Trial | None:
    """The equilibrium of a cable that ``find`` finds when it is longer; None if it does not, or a step does not
    arrive."""
    if problem.scene.options.elements is not None:
        return None
    for longer in LONGER:
        now = as_long(problem, longer)
        found = find(now, None)
        if rests(now, found):
            return _shorter(problem, now, found, longer)
    return None


def _shorter(problem, now, found, longer):
    def advance(state, _, ahead, __):
        now, found = state
        then = problem if ahead == 1 else as_long(problem, longer ** (1 - ahead))
        return handed_on(now, found, then, found.error)

    state = stepped((now, found), advance, LONGEST, SHORTEST)
    return None if state is None else state[1]
