# SPDX-License-Identifier: LGPL-2.1-or-later
"""From an easy problem to the one asked for, in steps as long as arrive."""

from collections.abc import Callable
from typing import TypeVar

GROWTH = 1.5
"""Of a step after one that arrived."""
ROUNDING = 1e-9
"""What is left of the way after steps that divide it."""

State = TypeVar("State")


def stepped(
    first: State,
    advance: Callable[[State, float, float, float], State | None],
    longest: float,
    shortest: float,
) -> State | None:
    """The state at 1, from the ``first`` at 0. ``advance(state, progress, ahead, step)`` is the state at ``ahead``, or
    None if it does not arrive; then the step is halved. None if it would be shorter than ``shortest``."""
    state, progress, step = first, 0.0, longest
    while progress < 1:
        ahead = progress + step if progress + step < 1 - ROUNDING else 1.0
        following = advance(state, progress, ahead, step)
        if following is None:
            step /= 2
            if step < shortest:
                return None
            continue
        state, progress, step = following, ahead, min(longest, GROWTH * step)
    return state
