# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which obstacles a cable cannot touch, whatever its shape."""

import numpy as np

from ..geometry.spheroid import Spheroid
from .ends import Free
from .obstacles import HalfSpace

STRETCH = 1.05
"""By how much more than its length a cable that stretches is taken to reach."""


def in_reach(scene, obstacles) -> np.ndarray:
    """(k,) whether the cable of a scene, whatever its shape, may touch each of k obstacles, or what has ``bounds``."""
    if not len(obstacles):
        return np.zeros(0, bool)
    held = [end.position for end in (scene.start, scene.end) if not isinstance(end, Free)]
    first, *second = held or [scene.supports[0].position]
    length = scene.rod.length * (1 if scene.rod.axial_stiffness is None else STRETCH)
    margin = scene.rod.radius + scene.clearance
    return ~out_of_reach(obstacles, first, second[0] if second else None, length, margin)


def out_of_reach(obstacles, a, b, length, margin) -> np.ndarray:
    """(k,) whether all of each obstacle, or rather of the box around it, is farther than ``margin`` [m] from wherever a
    cable of ``length`` [m] (stretched, if it stretches) can be that is held at a (3,) and b (3,) [m], or at a alone if
    b is None. Never True if any of it is nearer."""
    reach = Spheroid.of(length, a, b)
    far = reach.far_from(np.array([o.bounds for o in obstacles]).reshape(-1, 2, 3), margin)
    for i, obstacle in enumerate(obstacles):
        if isinstance(obstacle, HalfSpace):
            lowest = -reach.support(-obstacle.normal[None])[0]
            far[i] = lowest - obstacle.point @ obstacle.normal > margin
    return far
