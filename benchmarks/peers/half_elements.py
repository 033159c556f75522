# SPDX-License-Identifier: LGPL-2.1-or-later
"""How chains of straight elements, whose directions are known at their centres only, are clamped.

``as documented`` the first and the last element are fixed as wholes, so that the cable is half an element too stiff at
each end and the error of order one. ``centred`` lets half an element stick out at each clamp, so that its centre is the
section that is clamped: of order two. Both are measured.
"""

from dataclasses import dataclass

import numpy as np

from benchmarks.peers.task import Task


@dataclass(frozen=True)
class Chain:
    nodes: np.ndarray
    """(elements+1,) arc lengths, some outside of the cable"""
    centres: np.ndarray
    """(elements,)"""
    inside: np.ndarray
    """(elements+1,) which nodes are of the cable"""

    @classmethod
    def of(cls, task: Task) -> "Chain":
        before = after = 0.0
        if task.variant == "centred":
            before, after = 0.5, 0.5 if task.end_position is not None else 0.0
        step = task.length / (task.elements - before - after)
        nodes = step * (np.arange(task.elements + 1) - before)
        inside = (nodes > -1e-9 * step) & (nodes < task.length + 1e-9 * step)
        return cls(nodes, (nodes[1:] + nodes[:-1]) / 2, inside)
