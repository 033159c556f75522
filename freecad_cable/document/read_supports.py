# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the supports that a cable links to, to those of its scene."""

import numpy as np

from ..errors import DocumentError
from ..problem import Pinned
from ..shape.units import vector_to_si
from .complaint import place_of
from .property_table import wrong
from .proxy import proxy_of
from .reference import container
from .support import Support


def read_supports(cable, start, end) -> tuple:
    """The supports of the scene, in order. ``start`` and ``end`` are its ends. Errors: ``DocumentError``,
    ``ProblemError``."""
    objects = _linked(cable)
    course = _course(objects, start, end)
    return tuple(
        obj.Proxy.held(obj, place_of(obj), course[i + 2] - course[i])
        for i, obj in enumerate(objects)
    )


def _linked(cable):
    found = list(cable.Supports)
    for i, support in enumerate(found):
        if proxy_of(support, Support) is None:
            raise wrong(
                cable,
                "Supports",
                f"has {support.Label}, which is no support; choose clamps, sleeves, rings or clips.",
            )
        if support.Status:
            raise DocumentError(support.Status)
        if container(support) is not container(cable):
            raise wrong(
                cable,
                "Supports",
                f"has {support.Label}, which is in another part or assembly than the cable; put both into the same.",
            )
        if support in found[:i]:
            raise wrong(
                cable, "Supports", f"has {support.Label} twice; a cable passes a support once."
            )
    return found


def _course(objects, start, end):
    """Points (n + 2, 3) [m]: the n supports, before them the start and after them the end. An end that is free stands
    where its neighbour does."""
    points = [vector_to_si(obj.Frame.Base) for obj in objects]
    if not points:
        return points
    before = start.position if isinstance(start, Pinned) else points[0]
    after = end.position if isinstance(end, Pinned) else points[-1]
    return np.array([before, *points, after])
