# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shear and stretch are left out until the loads say that they matter.

A cable that is rigid in both is solved first. From its internal forces follows by how much shear and stretch would move
it; if that is below the tolerance asked for, they stay out, else the cable is solved again with them.
"""

from dataclasses import replace

import numpy as np

from ..problem.reduce import reduce
from . import search
from .problem import Problem
from .trial import Trial

SAFETY = 10.0
"""Between the strain summed along the cable and the tolerance: a change of length δ changes the sag of a cable of
slack s by about 0.3 δ/√s (a parabola), at most 3 δ where this is tried, and other soft directions get as much again."""


def find(problem: Problem, *start) -> Trial | None:
    """As ``search.find``, with as little of the model as the tolerance allows."""
    anew = problem.anew
    trial = search.find(problem, *start)
    if not problem.model.tried:
        return trial
    if trial is not None:
        moved = _moved(problem, trial)
        names = " and ".join(problem.model.tried)
        if SAFETY * moved <= problem.scene.options.tolerance:
            sentence = f"{names}: summed along the cable they are {moved:.1e} of its length, below the tolerance"
            problem.model = replace(problem.model, left_out=(*problem.model.left_out, sentence))
            return trial
    problem.model, problem.anew = reduce(problem.scene, rigid=False), anew
    return search.find(problem, *start)


def _moved(problem, trial) -> float:
    """Shear and stretch that the forces of a rigid rod would cause, summed along it, relative to its length."""
    rod, shape = problem.scene.rod, trial.shape
    local = np.einsum("kij,ki->kj", trial.frames, shape.force) * problem.scaling.force
    strain = np.zeros(len(local))
    if "shear" in problem.model.tried:
        strain += np.linalg.norm(local[:, :2], axis=1) / rod.shear_stiffness
    if "stretch" in problem.model.tried:
        strain += np.abs(local[:, 2]) / rod.axial_stiffness
    return float(np.sum((strain[1:] + strain[:-1]) / 2 * shape.steps))
