# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cable is led to its supports: from where it hangs without them, each is moved to its place in steps."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from ..geometry import rotation
from ..problem import Clamp, Ring
from ..transcription.shape import Joint, Shape
from . import mesh
from .problem import Problem
from .stepping import stepped
from .trial import Trial

STEP = 1 / 3
"""First step, as a share of the way."""
SHORTEST = 1 / 48


def led(problem: Problem, free: Trial) -> Iterator[Trial]:
    """The scene's equilibrium from one of the same cable without supports, if every step arrives."""
    places = np.array(problem.breaks)
    elements = mesh.size(2 * mesh.COARSE)
    start = _with_joints(free.shape, mesh.uniform(elements, places), places)
    nodes = [joint.node for joint in start.joints]
    before = start.position[nodes] * problem.scaling.length + problem.scaling.origin
    frames = start.quaternion[nodes]

    def advance(trial, _, ahead, step):
        shape = start if trial is free else trial.shape.on(mesh.refined(trial.shape, elements))
        supports = [
            _moved(support, *pose, ahead)
            for support, *pose in zip(problem.scene.supports, before, frames, strict=True)
        ]
        here = replace(problem, scene=replace(problem.scene, supports=supports))
        found = here.solve(shape, fallback=step < 2 * SHORTEST)
        return None if found is None or found.slipped else found

    if (trial := stepped(free, advance, STEP, SHORTEST)) is not None:
        yield trial


def _with_joints(shape: Shape, arc_length, places) -> Shape:
    """Nodes at ``arc_length``, those at some ``places`` as joints that do not act."""
    shape = shape.on(arc_length)
    nothing = np.zeros(3)
    return replace(
        shape,
        joints=tuple(
            Joint(int(node), shape.strain[node], nothing, nothing)
            for node in np.searchsorted(arc_length, places - 1e-12)
        ),
    )


def _moved(support, position, quaternion, share):
    """A support on its way from a node of the free cable, a ``share`` of it done."""
    place = (1 - share) * position + share * support.position
    if isinstance(support, Clamp):
        turned = rotation.between(quaternion, support.quaternion, share)
        return replace(support, position=place, quaternion=turned)
    name = "axis" if isinstance(support, Ring) else "tangent"
    before = rotation.tangent(quaternion)
    whole = rotation.logarithm(rotation.shortest_arc(before, getattr(support, name)))
    now = rotation.rotate(rotation.exponential(share * whole), before)
    return replace(support, position=place, **{name: now})
