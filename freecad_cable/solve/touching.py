# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where along a cable contact begins and ends: the nodes of finer meshes gather there."""

import numpy as np

FAINT = 0.01
"""Share of the largest force of a place below which a node is not taken to touch."""


def places(problem, trial, pointed=True) -> np.ndarray:
    """Arc lengths where contact begins or ends, or is at a point; whether those at which the cable slides freely over a
    point are among them: ``pointed``."""
    around_it, s = problem.surroundings, trial.shape.arc_length
    size, found = np.linalg.norm(trial.contact_forces, axis=2), []
    for run in trial.contact_runs(around_it.radius):
        if not pointed and len(run[0]) == 1 and trial.places.slides[run].all():
            continue
        found += _ends(trial.contact_places[run], size[run])
    touches = trial.with_itself
    force = np.linalg.norm(touches.forces, axis=1)
    for place in touches.places(problem.own.radius):
        found += _ends(touches.here[place], force[place])
        found += _ends(touches.there[place], force[place])
    if problem.apart:
        found += problem.own.mesh_places(trial.shape)
    if around_it.deepest(trial.shape):
        worst = int(np.argmin(around_it.between(trial.shape)))
        found.append((s[worst] + s[worst + 1]) / 2)
    return np.array(found)


def pushed(shape, weight) -> np.ndarray:
    """(n,) whether something pushes an element of an equilibrium under a ``weight`` (3,), told from its forces."""
    pushes = [
        part.force[:-1] - part.force[1:] - part.steps[:, None] * weight for part in shape.parts()
    ]
    push = np.linalg.norm(np.concatenate(pushes), axis=1)
    return push > FAINT * push.max()


def displaced(trial) -> float:
    """How far what is between the nodes of an element lets a force on it be from where it acts, at most: F h³/12 EI."""
    softness = 1 / trial.values["stiffness"][:2].min()
    force = np.linalg.norm(trial.contact_forces, axis=2).max(axis=1, initial=0.0)
    return float((force * trial.shape.steps**3).max(initial=0.0) * softness / 12)


def _ends(arc_length, force):
    """Where a contact begins and ends, from its places; of two, which share a force between them, the middle.
    What the solver leaves of its barrier beside a contact is none."""
    there = np.flatnonzero(force > FAINT * force.max())
    if there[-1] - there[0] <= 1:
        return [float(np.average(arc_length[there], weights=force[there]))]
    return [arc_length[there[0]], arc_length[there[-1]]]


def fineness(shape, here) -> float:
    """Longest of the elements at some places."""
    steps = shape.steps
    here = np.searchsorted(shape.arc_length, here).clip(1, len(steps) - 1)
    return np.maximum(steps[here - 1], steps[here]).max()
