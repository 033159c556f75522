# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where along a cable contact begins and ends, and where it will: the nodes of finer meshes gather there."""

import numpy as np

from ..geometry.runs import runs

FAINT = 0.01
"""Share of the largest force of a place below which a node is not taken to touch."""
FARTHEST_AHEAD = 4.0
"""How far ahead, in lengths of the last step, a contact is taken to come to rest."""


def ahead(before, here):
    """Where contacts come to rest, from the last two times that they were looked up (see ``places``). A node on a
    round edge or a ball is pushed across that, and so nearly along the cable if the cable touches beside it: mesh by
    mesh, the cable slides until nothing is left of that."""
    (first, held), (last, holds) = before, here
    if len(first) != len(last):
        return last
    gone, eased = last - first, holds - held
    step = np.divide(-holds * gone, eased, out=np.zeros_like(gone), where=eased != 0)
    known = np.isfinite(step) & (np.abs(step) < FARTHEST_AHEAD * np.abs(gone))
    return np.clip(last + np.where(known, step, 0.0), 0.0, 1.0)


def places(problem, trial):
    """(places, grips): arc lengths where contact begins or ends, or is at a point, and of each what obstacles push
    along the cable there, which is nothing in an equilibrium; NaN where that does not tell where the contact comes to
    rest."""
    around_it, s = problem.surroundings, trial.shape.arc_length
    forces = trial.contact_forces.sum(axis=1)
    size, along = np.linalg.norm(trial.contact_forces, axis=2).sum(axis=1), trial.frames[:, :, 2]
    pushed = (forces * along).sum(axis=1)
    found, grips = [], []
    for a, b in runs(size > 0):
        ends = _ends(s[a:b], size[a:b])
        found += ends
        grips += [pushed[a:b].sum()] if len(ends) == 1 else [np.nan, np.nan]
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
    grips += [np.nan] * (len(found) - len(grips))
    return np.array(found), np.array(grips)


def _ends(arc_length, force):
    """Where a contact begins and ends, from its nodes; of two, which share a force between them, the middle.
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
