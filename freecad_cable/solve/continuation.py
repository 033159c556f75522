# SPDX-License-Identifier: LGPL-2.1-or-later
"""Heavy and taut cables: from an easy one to the one asked for, in steps that the mesh can follow.

Under more weight or with less slack the bending layers at the ends become narrower, so each step starts from the
last shape on a mesh that suits it, and a step that the mesh cannot follow is halved.
"""

from collections.abc import Iterator

import numpy as np

from ..problem.reduce import tautness
from ..transcription.guess import guess
from . import mesh
from .problem import Problem
from .stepping import stepped
from .trial import Trial

LIGHT = 100.0
"""Weight ratio with which continuation begins."""
TAUT = 0.97
"""Distance of the ends, relative to the length, with which continuation begins."""
FACTOR = 4.0
"""Growth of the weight, and loss of slack, in one step."""
SHORTEST = 1 / 32
"""Shortest step, as a share of the longest."""
DRIFT = 1e-3
"""Error estimate above which a step was too long for the mesh."""


def taut_chord(scene) -> float:
    """Of the held places that an inextensible cable is most taut between: distance over length; else 0."""
    if scene.rod.axial_stiffness is not None:
        return 0.0
    return tautness(scene)


def continued(problem: Problem, elements: int) -> Iterator[Trial]:
    """The scene's equilibrium, if continuation arrives there; nothing if there is nothing to continue in."""
    scene, scaling = problem.scene, problem.scaling
    load = min(1.0, LIGHT / max(scaling.weight_ratio, LIGHT))
    chord = taut_chord(scene)
    slack = max(1 - chord, 1e-9)
    loose = max(1 - TAUT, slack)
    if load == 1.0 and loose == slack:
        return
    elements = max(elements, 2 * mesh.COARSE)

    def at(progress):
        """Both by equal factors: the weight, and the slack that is left."""
        reach = 1.0 if loose == slack else (1 - loose ** (1 - progress) * slack**progress) / chord
        return {"load": load ** (1 - progress), "reach": reach}

    arc_length = mesh.uniform(elements, problem.breaks)
    trial = problem.solve(guess(scene, scaling, arc_length), **at(0))
    longest = 1 / np.ceil(np.log(max(1 / load, loose / slack)) / np.log(FACTOR))

    def advance(trial, progress, ahead, step):
        start = trial.shape.on(mesh.refined(trial.shape, elements))
        before, after = (scaling.loaded(at(p)["load"]).force for p in (progress, ahead))
        start = start.in_units(before / after)
        following = problem.solve(start, **at(ahead), fallback=step <= longest * SHORTEST)
        return None if following is None or following.error > DRIFT else following

    if trial is not None:
        trial = stepped(trial, advance, longest, longest * SHORTEST)
    if trial is not None:
        yield trial
