# SPDX-License-Identifier: LGPL-2.1-or-later
"""What pushes a cable between its supports, and whether all is in balance with it."""

import numpy as np

from ..result import Balance, Contact, Pushes, balance


def contacts_of(problem, trial) -> tuple[Contact, ...]:
    """One contact for each place or stretch that an obstacle pushes, and two for each place in which the cable touches
    itself."""
    scaling, found = problem.scaling, []
    forces = trial.contact_forces * scaling.force
    size = np.linalg.norm(forces, axis=2)
    for obstacle in () if trial.places is None else np.unique(trial.places.owners):
        for run in trial.contact_runs(problem.surroundings.radius, obstacle):
            middle = np.average(trial.contact_places[run], weights=size[run]) * scaling.length
            found.append(Contact(float(middle), int(obstacle), forces[run].sum(axis=0)))
    touches = trial.with_itself
    for place in touches.places(problem.own.radius):
        size = np.linalg.norm(touches.forces[place], axis=1)
        here, there = (
            float(np.average(each[place], weights=size)) * scaling.length
            for each in (touches.here, touches.there)
        )
        force = touches.forces[place].sum(axis=0) * scaling.force
        found += [Contact(here, None, force, there), Contact(there, None, -force, here)]
    return tuple(sorted(found, key=lambda contact: contact.arc_length))


def balanced(problem, trial, pushes) -> Balance:
    """The worst of the stretches between supports; ``pushes`` (n+1, 3) [N] is what the cable itself exerts on nodes."""
    scene, scaling, shape = problem.scene, problem.scaling, trial.shape
    pushed = np.flatnonzero(pushes.any(axis=1))
    touching = trial.contact_forces.any(axis=2)
    places, forces = [shape.arc_length[pushed]], [pushes[pushed]]
    positions = [shape.position[pushed]]
    if touching.any():
        places.append(trial.contact_places[touching])
        positions.append(trial.touched.position[touching])
        forces.append(trial.contact_forces[touching] * scaling.force)
    places, positions, forces = (np.concatenate(each) for each in (places, positions, forces))
    found = []
    for part in shape.parts():
        # What acts on a node that is held goes into what holds it.
        own = (places > part.arc_length[0]) & (places < part.arc_length[-1])
        found.append(
            balance(
                scene.rod,
                scene.weight,
                part.arc_length * scaling.length,
                scaling.origin + part.position * scaling.length,
                part.quaternion,
                part.force * scaling.force,
                Pushes(
                    places[own] * scaling.length,
                    scaling.origin + positions[own] * scaling.length,
                    forces[own],
                ),
            )
        )
    return Balance(max(b.moment for b in found), max(b.force for b in found))
