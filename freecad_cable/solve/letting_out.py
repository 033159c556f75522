# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cable that is not found among obstacles: nearly taut between what holds it, and let out step by step.

A short cable goes straight, through ducts and past plates that a long one crosses before it knows of them. What is let
out meets obstacles from the side that it is on.
"""

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from ..problem.reduce import tautness
from . import mesh, touching
from .contact import rests, resumed
from .gathering import FIRST
from .problem import Problem
from .saddle import descended
from .settling import settled
from .stepping import stepped
from .surroundings import BESIDE
from .trial import Trial

Find = Callable[[Problem, None], Trial | None]

SLACK = (0.02, 1e-3, 5e-5)
"""Slack, relative to the way between what holds it, with which it begins: the first with which it touches nothing. On
its way through supports a cable with less bends sharply, and is dear to find."""
FACTOR, LEAST = 2.0, 1.02
"""Growth of the slack in one step; the least that is tried."""
WIDTH = 1 / 6 / FIRST
"""Shortest elements, relative to the length, on the way."""
SWAY = 0.01
"""Displacement, in lengths, off a saddle on the way."""


def let_out(problem: Problem, find: Find, slacks=SLACK) -> Trial | None:
    """The equilibrium of a cable that ``find`` finds free of all obstacles when it is short; None if it does not, or if
    a step does not arrive."""
    taut = tautness(problem.scene)
    # A free end says nothing of how long the way is.
    if problem.scene.options.elements is not None or not (problem.scene.spans and taut):
        return None
    full = 1 / taut - 1
    for slack in slacks[:1] if problem.scene.supports else slacks:
        if LEAST * slack > full:
            continue
        now = as_long(problem, taut * (1 + slack))
        found = find(now, None)
        if rests(now, found):
            shape = found.shape.on(mesh.refined(found.shape, FIRST))
            return _longer(problem, now, shape, slack, full)
    return None


def _longer(problem, now, shape, slack, full):
    def advance(state, _, ahead, __):
        now, shape = state
        share = (1 + slack * (full / slack) ** ahead) / (1 + full)
        then = problem if ahead == 1 else as_long(problem, share)
        before, after = now.scaling, then.scaling
        start = shape.in_units(before.force / after.force, before.length / after.length)
        then.formed = then.scene.enforce_bend_radius
        found = settled(then, start, BESIDE, hasty=True)
        if found is None:
            return None
        found = descended(found, lambda shape: settled(then, shape), SWAY, lambda t: t.stable)
        return (then, _gathered(then, found)) if found.stable else None

    longest, shortest = np.log([FACTOR, LEAST]) / np.log(full / slack)
    state = stepped((now, shape), advance, longest, shortest)
    # Nothing is known of its error.
    return None if state is None else resumed(problem, replace(state[1], error=np.inf))


def _gathered(problem, trial):
    """Its shape with nodes where it touches: on even ones a few steps on are not found."""
    here = touching.places(problem, trial)
    if not len(here):
        return trial.shape
    return trial.shape.on(mesh.gathered(trial.shape, FIRST, here, WIDTH))


def as_long(problem: Problem, share: float) -> Problem:
    """The same cable with a share of its length."""
    scene = problem.scene
    supports = tuple(
        each if each.slides else replace(each, arc_length=share * each.arc_length)
        for each in scene.supports
    )
    rod = replace(scene.rod, length=share * scene.rod.length)
    return problem.eased(replace(scene, rod=rod, supports=supports))
