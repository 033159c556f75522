# SPDX-License-Identifier: LGPL-2.1-or-later
"""An earlier solution as the start of another scene's."""

import time

import numpy as np

from ..errors import ProblemError
from ..geometry import rotation
from ..problem.between import between
from ..result import Solution, is_near
from .answer import solution

STEP, SHORTEST = 1 / 2, 1 / 32
"""First and last step, as shares of the way, where one does not arrive."""
PART = 0.5
"""Of the time that is left, what steps may take: what is tried after them needs some, too."""


def pull(start: Solution | None) -> float:
    """Largest force in an earlier solution [N]."""
    if start is None or start.force is None:
        return 0.0
    return float(np.linalg.norm(start.force, axis=1).max())


def curvature(rod, quaternion, moment) -> np.ndarray:
    """(3,) [1/m] of a rod with this frame (4,) under a moment (3,) [N m], in the material frame."""
    return rod.natural_curvature + rotation.matrix(quaternion).T @ moment / rod.stiffness


def nodes(start: Solution | None, problem):
    """The nodes of an earlier solution as a ``Shape`` in the units of a ``Problem``; None if it is too far."""
    from ..transcription.shape import Joint, Shape

    scene, scaling = problem.scene, problem.scaling
    if start is None or start.position is None or not is_near(start, scene):
        return None
    span = start.arc_length[-1]

    def strain(curvature):
        return np.concatenate([curvature * span, np.zeros_like(curvature)], axis=-1)

    joints = []
    for node, load in zip(start.support_nodes, start.support_reactions, strict=True):
        beyond = curvature(scene.rod, start.quaternion[node], start.moment[node] - load.moment)
        force, turning = load.force / scaling.force, load.moment / scaling.energy
        joints.append(Joint(node, strain(beyond), force, turning))
    return Shape(
        _arc_lengths(start, scene),
        scaling.point(start.position),
        rotation.continuous(start.quaternion),
        strain(start.curvature),
        start.force / scaling.force,
        start.moment / scaling.energy,
        tuple(joints),
        _contact_error(start),
    )


def follows(problem, start: Solution | None):
    """Tell a ``Problem`` what is to be followed."""
    if start is None or start.position is None:
        return
    problem.before, problem.pushers = start.scene, {}
    before, after = start.scene.obstacles, problem.scene.obstacles
    for index in {contact.obstacle for contact in start.contacts} - {None}:
        if len(before) == len(after) and before[index].place == after[index].place:
            moved = _middle(after[index]) - _middle(before[index])
            if moved.any():
                problem.pushers[index] = moved


def _middle(obstacle):
    """(3,) [m] a point that moves with an obstacle; the origin for one that fills a half of space."""
    corners = getattr(obstacle, "vertices", obstacle.bounds)
    return corners.mean(axis=0) if np.isfinite(corners).all() else np.zeros(3)


def by_steps(problem, start: Solution):
    """The ``Trial`` of a ``Problem`` that an earlier solution becomes while its scene changes step by step into this
    one; None if a step does not arrive."""
    from ..solve.problem import TimeUpError
    from ..solve.refining import GARBAGE
    from ..solve.search import followed
    from ..solve.stepping import stepped

    before, after = start.scene, problem.scene
    now = time.perf_counter()
    deadline = now + PART * (problem.deadline - now)

    def advance(here, _, ahead, __):
        try:
            there = problem if ahead == 1 else on_the_way(here, ahead)
        except ProblemError:
            return None
        follows(there, here)
        warm = nodes(here, there)
        found = None if warm is None else followed(there, warm)
        if found is None or not found.stable or found.error > GARBAGE:
            return None
        return found if ahead == 1 else solution(there, found)

    def on_the_way(here, ahead):
        there = problem.eased(between(before, after, ahead), pull(here))
        there.deadline, there.hurried = deadline, True
        if not problem.surroundings.rims:
            there.surroundings = there.surroundings.without_rims()
        return there

    problem.hurried = True
    try:
        return None if before is after else stepped(start, advance, STEP, SHORTEST)
    except TimeUpError:
        return None
    finally:
        problem.hurried = False


def _contact_error(start):
    """Relative error estimate of an earlier solution in contact."""
    if not start.contacts:
        return None
    return start.position_error / start.arc_length[-1]


def _arc_lengths(start, scene):
    """Those of the nodes of an earlier solution, relative to the length, with those of the supports where they are
    given now."""
    before = start.arc_length / start.arc_length[-1]
    given = [
        (before[node], support.arc_length / scene.rod.length)
        for node, support in zip(start.support_nodes, scene.supports, strict=True)
        if not support.slides
    ]
    return np.interp(before, *np.transpose([(0.0, 0.0), *given, (1.0, 1.0)]))
