# SPDX-License-Identifier: LGPL-2.1-or-later
"""All stable equilibria of a scene that many starts lead to: a cable has two to four as a rule."""

import numpy as np

from ..transcription.guess import guess, holds_turns, turned
from . import contact, mesh, refining, search
from .problem import Problem, TimeUpError
from .trial import Trial

TURNS = (0, -1, 1, -2, 2)
"""Full turns of twist beyond the least of each start."""
WAYS = 8
"""Directions, besides that of gravity, into which the slack of a start goes."""
SAG = 60.0
"""Load that sends it there, without units."""
APART = 0.01
"""Distance between shapes, relative to the length, from which they are two; and, if they lie in the same place, share
of the energy by which their twist must differ."""


def find_all(problem: Problem) -> list[Trial]:
    """Stable equilibria, each to the tolerance asked for, lowest energy first. The time limit ends the search; what was
    found until then is returned."""
    found = []
    try:
        for start in _starts(problem):
            trial = problem.solve(start)
            if trial is None:
                continue
            trial = search.off_saddle(problem, trial)
            if not trial.stable or trial.error > refining.GARBAGE:
                continue
            if any(_same(trial, other) for other, _ in found):
                continue
            answer = refining.refined(problem, trial)
            if problem.surroundings.obstacles:
                answer = contact.around(problem, answer)
            answer = answer and search.apart(problem, answer)
            if answer is not None and not any(_same(answer, other) for _, other in found):
                found.append((trial, answer))
    except TimeUpError:
        pass
    return sorted((answer for _, answer in found), key=lambda trial: trial.energy)


def _starts(problem):
    arc_length = mesh.uniform(mesh.COARSE, problem.breaks)
    directions = np.random.default_rng(7).normal(size=(WAYS, 3))
    sags = [None, *(SAG * d / np.linalg.norm(d) for d in directions)]
    scene, scaling = problem.scene, problem.scaling
    starts = [guess(scene, scaling, arc_length, sag=sag) for sag in sags]
    for turns in TURNS if problem.model.twist and holds_turns(scene) else TURNS[:1]:
        yield from (turned(scene, scaling, start, turns) for start in starts)


def _same(trial, other) -> bool:
    """Whether two trials are one shape, as far as the coarser of their meshes tells."""
    s = np.linspace(0, 1, 101)
    places = [
        np.stack([np.interp(s, t.shape.arc_length, x) for x in t.shape.position.T], axis=1)
        for t in (trial, other)
    ]
    turned = abs(trial.energies[1] - other.energies[1]) > APART * abs(trial.energies).max()
    apart = np.linalg.norm(places[0] - places[1], axis=1).max()
    return bool(apart < APART and not turned)
