# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers and vectors from outside, checked. Every reader of a statement goes through these."""

import reprlib
from itertools import chain

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
            field,
            f"is {shown(value)}{unit}; it must be a finite number, at most {LARGEST:g}{unit} in size",
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
    if isinstance(value, np.ndarray):
        value = value.tolist()
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
            field, f"is {shown(array)}; its length is zero, so it gives no direction"
        )
    array = array / norm
    array.flags.writeable = False
    return array


def table(field, value, least=1):
    """``value`` as a read-only array (k, 3) of finite floats, k at least ``least``. Quick for long ones."""
    array = _rows(field, value, number, "iuf", {int, float}, f"at least {least} lists of 3 numbers")
    if len(array) < least:
        raise ProblemError(field, f"has {len(array)} rows; it must have at least {least}")
    array = np.array(array, float)
    good = np.abs(array) <= LARGEST
    if not good.all():
        i, j = np.argwhere(~good)[0]
        number(f"{field}[{i}][{j}]", float(array[i, j]))
    array.flags.writeable = False
    return array


def index_table(field, value, count, things):
    """``value`` as a read-only array (k, 3), k at least 1, of indices into ``count`` things. Quick for long ones."""
    array = _rows(field, value, _whole, "iu", {int}, "a list of lists of 3 whole numbers")
    if len(array) == 0:
        raise ProblemError(field, "is empty; it must have at least 1 row")
    good = (array >= 0) & (array < count)
    if not good.all():
        i, j = np.argwhere(~good)[0]
        raise ProblemError(
            f"{field}[{i}][{j}]",
            f"is {array[i, j]}; it must be from 0 to {count - 1}, as there are {count} {things}",
        )
    array = np.array(array, int)
    array.flags.writeable = False
    return array


def _rows(field, value, check, kinds, types, wanted):
    """``value`` as an array (k, 3) of one of the dtype ``kinds``. Lists of anything but ``types`` are searched,
    number by number with ``check``, for what to name."""
    if isinstance(value, np.ndarray):
        if value.ndim != 2 or value.shape[1] != 3 or value.dtype.kind not in kinds:
            raise ProblemError(
                field, f"is an array {value.shape} of {value.dtype}; it must be {wanted}"
            )
        return value
    if not isinstance(value, (list, tuple)):
        raise ProblemError(field, f"is {shown(value)}; it must be {wanted}")
    rows_of_three = set(map(type, value)) <= {list, tuple} and set(map(len, value)) <= {3}
    if rows_of_three and set(map(type, chain.from_iterable(value))) <= types:
        array = np.array(value).reshape(-1, 3)
        if array.dtype.kind in kinds:
            return array
    for i, row in enumerate(value):
        if not isinstance(row, (list, tuple, np.ndarray)) or len(row) != 3:
            raise ProblemError(f"{field}[{i}]", f"is {shown(row)}; it must be a list of 3 numbers")
        for j, item in enumerate(row):
            check(f"{field}[{i}][{j}]", item)
    return np.array(value).reshape(-1, 3)


def _whole(field, value):
    if isinstance(value, bool) or not isinstance(value, (int, np.integer)) or abs(value) > 2**62:
        raise ProblemError(field, f"is {shown(value)}; it must be a whole number")


def record(place, data, required, optional):
    """``data`` as a dict with all required and no unknown fields; ``place`` is ``scene`` or ``study`` for all of a
    file."""
    if not isinstance(data, dict):
        raise ProblemError(place, f"is {shown(data)}; it must be an object")
    inside = "" if place in ("scene", "study") else f"{place}."
    for name in required:
        if name not in data:
            raise ProblemError(f"{inside}{name}", "is missing")
    for name in data:
        if name not in required and name not in optional:
            raise ProblemError(
                f"{inside}{name}",
                f"is not known here; known are {', '.join((*required, *optional))}",
            )
    return data
