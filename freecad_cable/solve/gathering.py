# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contact on finer meshes, until it is as accurate as asked for."""

from dataclasses import replace

import numpy as np

from . import mesh, touching
from .problem import Problem, TimeUpError
from .settling import settled
from .surroundings import BESIDE
from .trial import Trial

COARSER = 1.5
"""Error of a mesh to its distance from a finer one by a third, at order 4 of which that has a third of the error."""
CHANCE = 3.0
"""By how much more than first order the error of a mesh is taken to be, from the changes before it."""
FIRST, APART, HEAVY = 64, 96, 1e3
"""Elements of the first mesh; at least so many of a finer one where the cable touches itself or is so heavy (w L³/EI)
that it bends sharply where it leaves what it lies on."""
MESHES = (48, 64, 96, 96, 128, 128, 192, 256, 256, 256, 256, 384, 384)
LOST = 0.02
"""Change from mesh to mesh that is no refinement."""
NARROWEST = 3e-5
"""Shortest elements, relative to the length, that nodes gather to; with shorter ones the solvers fail."""
GATHER = 6.0
"""Factor by which nodes draw nearer, from mesh to mesh, to where contact begins and ends."""


def gathered(problem: Problem, found: Trial, error=np.inf) -> Trial:
    """On meshes whose nodes gather where contact begins and ends, until the shape stays. ``error`` of what was found,
    as far as it is known."""
    around_it, tolerance = problem.surroundings, problem.scene.options.tolerance
    found, width = found.measured_as(error), 1 / FIRST
    expected = last = 0.0
    here = touching.places(problem, found)
    coarsest = APART if problem.apart or problem.scaling.weight_ratio > HEAVY else 0
    try:
        for elements in MESHES:
            if elements < coarsest:
                continue
            if not len(here):
                return found.measured_as(None)  # touches nothing, so the strong form holds
            width = max(width / GATHER, NARROWEST)
            nodes = mesh.gathered(found.shape, elements, here, width)
            finer = settled(problem, found.shape.on(nodes), BESIDE, fallback=True)
            if finer is None:
                return found
            # As one piece: supports that slide are elsewhere on the one than on the other.
            coarser = replace(found.shape, joints=()).on(finer.shape.arc_length)
            change = np.linalg.norm(finer.shape.position - coarser.position, axis=1).max()
            if change > LOST and found.measured < LOST:
                return found  # the finer one has left for another equilibrium
            # A node may lie well by chance, and then one change tells too little: the error goes with the elements. Two
            # that are small are no chance.
            fineness = touching.fineness(found.shape, here)
            here = touching.places(problem, finer)
            finer_by = touching.fineness(finer.shape, here) / fineness if len(here) else 1.0
            expected = max(min(expected, last), change) * min(finer_by, 1.0)
            last = change
            error = max(COARSER * change, CHANCE * expected)
            found = finer.measured_as(error)
            inside = problem.apart and problem.own.depths(found.shape)
            if error <= tolerance and not (inside or around_it.deepest(found.shape)):
                return found
    except TimeUpError:
        if np.isinf(found.measured):
            raise
    return found


def finer(problem: Problem, trial: Trial) -> Trial:
    """On twice as many elements, gathered where it touches, and once more if it is in something there; the same if that
    is not to be had."""
    best, elements = trial, mesh.size(2 * len(trial.shape.steps))
    for _ in range(2):
        places = touching.places(problem, best)
        width = touching.fineness(best.shape, places)
        nodes = mesh.gathered(best.shape, elements, places, width)
        found = settled(problem, best.shape.on(nodes), BESIDE, fallback=True)
        if found is None:
            break
        best = found.measured_as(trial.error)
        if not problem.surroundings.deepest(best.shape):
            break
    return best


def compared(problem: Problem, found: Trial) -> Trial:
    """With its error measured on elements that are halves of its own."""
    s = found.shape.arc_length
    halves = np.sort(np.append(s, (s[1:] + s[:-1]) / 2))
    finer = settled(problem, found.shape.on(halves), BESIDE, fallback=True)
    if finer is None:
        return found.measured_as(np.inf)
    change = np.linalg.norm(finer.shape.position[::2] - found.shape.position, axis=1).max()
    return found.measured_as(COARSER * change)
