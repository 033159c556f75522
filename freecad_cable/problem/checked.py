# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers and vectors from outside, checked. Every reader of a statement goes through these."""

import reprlib

import numpy as np

from ..errors import ProblemError

LARGEST = 1e30
"""Bound on every number, and 1/LARGEST on every one that must be positive: far outside anything built, and
products of a few of them still fit a float."""


def number(field, value, *, above=None, at_least=None, unit=""):
    """``value`` as a finite float within the bound; else ``ProblemError`` naming field, value and bound."""
    unit = f" {unit}" if unit else ""
    if isinstance(value, bool) or not isinstance(value, (int, float, np.number)):
        raise ProblemError(field, f"is {shown(value)}; it must be a number{unit and f' in{unit}'}")
    if not abs(value) <= LARGEST:
        raise ProblemError(
            field, f"is {shown(value)}; it must be a finite number, at most {LARGEST:g} in size"
        )
    value = float(value)
    if above is not None and above < value < 1 / LARGEST:
        raise ProblemError(field, f"is {value:g}{unit}; it must be at least {1 / LARGEST:g}{unit}")
    if above is not None and not value > above:
        raise ProblemError(field, f"is {value:g}{unit}; it must be greater than {above:g}{unit}")
    if at_least is not None and not value >= at_least:
        raise ProblemError(field, f"is {value:g}{unit}; it must be at least {at_least:g}{unit}")
    return value


def shown(value) -> str:
    """A value as a message shows it: in one line, and not all of a long one."""
    return reprlib.repr(value).replace("\n", " ")


def vector(field, value, size=3):
    """``value`` as a read-only array of ``size`` finite floats."""
    if isinstance(value, np.ndarray):
        value = value.tolist()
    if not isinstance(value, (list, tuple)) or len(value) != size:
        raise ProblemError(field, f"is {shown(value)}; it must be a list of {size} numbers")
    array = np.array([number(f"{field}[{i}]", item) for i, item in enumerate(value)])
    array.flags.writeable = False
    return array


def direction(field, value, size=3):
    """``value`` as a unit vector (or, with size 4, a unit quaternion); it must not vanish."""
    array = vector(field, value, size)
    norm = np.linalg.norm(array / max(np.abs(array).max(), 1e-300)) * np.abs(array).max()
    if not norm > 1e-9:
        raise ProblemError(
            field, f"is {shown(value)}; its length is zero, so it gives no direction"
        )
    array = array / norm
    array.flags.writeable = False
    return array
