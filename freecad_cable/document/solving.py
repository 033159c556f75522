# SPDX-License-Identifier: LGPL-2.1-or-later
"""Who solves a cable, and when: at once, or, where there is a window, beside it."""

from typing import Protocol

from ..equilibrium import find_equilibrium
from ..result import Solution
from .stored_solution import kept

UPDATES = ("Manual", "On recompute", "Live")


class Beside(Protocol):
    """What solves beside the window."""

    def solution(self, cable, inputs, work) -> Solution | None:
        """What ``work(watch)`` returns or raises (``watch`` as of ``find_equilibrium``), or None while that takes its
        time; then the cable is recomputed when it is there. ``inputs`` is the fingerprint of the scene: whoever asks
        again with the same one gets the same answer."""

    def knows(self, cable, inputs) -> bool:
        """Whether an answer is there or under way."""

    def is_solving(self, cable) -> bool:
        """Whether an answer is under way."""

    def drop(self, cable):
        """Nothing is asked for this cable any more."""

    def wait(self, document):
        """Come back when no cable of the document is being solved."""


beside: Beside | None = None
"""``gui.worker`` puts itself here; None: cables are solved at once."""

_asked = set()


def solve(cable):
    """Solve a cable now, also if its ``Update`` is Manual. In a window it may go on beside it: see ``wait``."""
    _asked.add(key(cable))
    cable.touch()
    cable.Document.recompute()


def wait(document):
    """Come back when no cable of the document is being solved any more: for macros in a window, where a recompute
    leaves what takes long to be solved beside it."""
    if beside is not None:
        beside.wait(document)


def key(cable) -> tuple[str, str]:
    """What a cable is known by as long as its document is open."""
    return cable.Document.Name, cable.Name


def solution(cable, scene, inputs) -> Solution | None:
    """The solution of the scene of a cable, or None if there is none yet: ``cable.Update`` is Manual, or it is being
    solved beside the window. Errors: those of ``find_equilibrium``."""
    known = beside is not None and beside.knows(cable, inputs)
    if cable.Update == "Manual" and not known and key(cable) not in _asked:
        drop(cable)
        return None
    _asked.discard(key(cable))
    start = kept(cable, scene)
    if beside is None:
        return find_equilibrium(scene, start=start)
    return beside.solution(
        cable, inputs, lambda watch: find_equilibrium(scene, start=start, watch=watch)
    )


def drop(cable):
    """A solve of the cable that still runs is of no use any more."""
    if beside is not None:
        beside.drop(cable)


def why_waiting(cable) -> str:
    """What a cable says that has no answer yet."""
    if beside is not None and beside.is_solving(cable):
        return f"{_state(cable)}: it is being solved."
    return f"{_state(cable)}: Update is {cable.Update}; Solve Now brings it up to date."


def stopped(cable):
    """A person has stopped the solve of a cable."""
    cable.Status = f"{_state(cable)}: its solve was stopped; a recompute starts it again."


def _state(cable):
    return "Out of date" if cable.SolvedInputs else "No shape yet"
