# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ctrl-C on the command line, looked at between two runs of a solver: inside one, CasADi makes an error of its own of
what Python raises."""

import multiprocessing
import signal
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager
from multiprocessing.sharedctypes import RawValue

from ..errors import StoppedError

_pressed = RawValue("b", 0)
"""Whether Ctrl-C was pressed; workers share it."""


def watch(_about=""):
    """The ``watch`` of ``find_equilibrium``, here and in workers. Errors: ``StoppedError`` after Ctrl-C."""
    if _pressed.value:
        raise StoppedError("The solve was stopped.")


def pressed() -> bool:
    """Whether Ctrl-C was pressed since ``waiting`` began."""
    return bool(_pressed.value)


@contextmanager
def waiting():
    """Inside, the first Ctrl-C waits for ``watch``; a second one ends the program at once."""
    _pressed.value = 0
    before = signal.signal(signal.SIGINT, _press)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


def workers(processes: int) -> ProcessPoolExecutor:
    """Processes whose solves end with Ctrl-C, too, if they are given ``watch``."""
    # A fresh interpreter each: a copy of one that has threads may stand still.
    context = multiprocessing.get_context("spawn")
    executor = ProcessPoolExecutor(processes, context, _begin, (_pressed,))
    # All begin here, deaf: one that Ctrl-C meets while it is starting would print a traceback.
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    for _ in range(processes):
        executor.submit(int)
    signal.signal(signal.SIGINT, before)
    return executor


def _begin(shared):
    global _pressed
    _pressed = shared
    signal.signal(signal.SIGINT, _press)


def _press(*_):
    _pressed.value = 1
    signal.signal(signal.SIGINT, signal.SIG_DFL)
