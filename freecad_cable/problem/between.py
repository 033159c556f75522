# SPDX-License-Identifier: LGPL-2.1-or-later
"""A scene on the way from one to another."""

from dataclasses import fields, is_dataclass, replace

import numpy as np

from ..geometry import rotation
from .scene import Scene


def between(before: Scene, after: Scene, share: float) -> Scene:
    """``after``, but places, directions, sizes and all other numbers that ``before`` has, too, are a ``share`` of the
    way from there. An obstacle or a support with another name (``place``) is another. Errors: ``ProblemError`` if that
    is no scene."""
    return replace(_between(before, after, share), options=after.options)


def _between(before, after, share):
    same = type(before) is type(after) and _name(before) == _name(after)
    if before is after or not same:
        return after
    if is_dataclass(after):
        return _of_fields(before, after, share)
    if isinstance(after, tuple) and len(before) == len(after):
        return tuple(_between(*pair, share) for pair in zip(before, after, strict=True))
    if isinstance(after, (float, np.ndarray)) and np.shape(before) == np.shape(after):
        return (1 - share) * before + share * after
    return after


def _name(thing):
    return getattr(thing, "place", None)


def _of_fields(before, after, share):
    pairs = {
        each.name: (getattr(before, each.name), getattr(after, each.name)) for each in fields(after)
    }
    changed = {}
    for name, pair in pairs.items():
        if isinstance(pair[1], np.ndarray) and pair[1].dtype.kind == "i":
            if not np.array_equal(*pair):
                return after  # another mesh
        elif name == "quaternion":
            changed[name] = rotation.between(*pair, share)
        else:
            changed[name] = _between(*pair, share)
    return replace(after, **changed)
