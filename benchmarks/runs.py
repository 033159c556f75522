# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which part of the benchmarks was run when, with what and where."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Run:
    """One part of ``./run bench``."""

    part: str
    commit: str
    date: str
    python: str
    numpy: str
    scipy: str
    casadi: str
    cpu: str
    load: str
    """[processes] of others, at the start"""
    seconds: float
    uncertainty: float
    """of the exact shapes that errors are measured against, relative to the length; 0 where there are none"""
