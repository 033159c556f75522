# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finer meshes, until the error estimate is within the tolerance."""

import numpy as np

from ..transcription.nlp import SCHEMES
from . import gathering, mesh
from .problem import TimeUpError

GARBAGE = 0.02
"""Error estimate, relative to the length, above which a coarse answer says nothing about the true one."""
HOPELESS = 128
"""Elements from which such an answer is not refined."""


def finer(problem, trial):
    """On twice as many elements; the same if that is not to be had."""
    if problem.scene.options.elements is not None:
        return trial
    try:
        if trial.touches:
            return gathering.finer(problem, trial)
        nodes = mesh.refined(trial.shape, mesh.size(2 * len(trial.shape.steps)))
        return problem.solve(trial.shape.on(nodes)) or trial
    except TimeUpError:
        return trial


def refined(problem, trial):
    """Re-mesh until the error estimate is within the tolerance, or the mesh as fine as it may be; the same on a mesh
    that is given."""
    if problem.scene.options.elements is not None:
        return trial
    tolerance = problem.scene.options.tolerance
    order = SCHEMES[problem.scheme].ORDER
    for _ in range(8):
        if trial.error <= tolerance or trial.slipped:
            return trial
        elements = len(trial.shape.steps)
        if trial.error > GARBAGE and elements >= HOPELESS:
            return trial
        # Aim at half the tolerance; at least 1.2 times the elements, at most 4 times.
        factor = np.clip((2 * trial.error / tolerance) ** (1 / order), 1.2, 4.0)
        wanted = mesh.size(elements * factor)
        try:
            finer = problem.solve(trial.shape.on(mesh.refined(trial.shape, wanted)))
        except TimeUpError:
            return trial  # less accurate than asked for, and its estimate says so
        if finer is None or not finer.stable or (elements == wanted and finer.error >= trial.error):
            return trial
        trial = finer
    return trial
