# SPDX-License-Identifier: LGPL-2.1-or-later
"""PyElastica: explicit dynamics of Cosserat rods, damped until they rest."""

from dataclasses import replace

import elastica
import numpy as np

from benchmarks.peers.half_elements import Chain
from benchmarks.peers.task import Found, Task
from freecad_cable.geometry import rotation

STEP = 0.7
"""Of the period of the shear of a section against its turning, R √(ρ/G), which limits the time step; with more it was
seen to diverge."""
DAMPING = 8.0
"""[1/s], near the critical one of the slowest mode: it rests soonest"""
LOOK_EVERY = 0.1
"""[s] of the cable's time"""
AT_REST = 1e-6
"""Movement between two looks, relative to the length, below which it rests: a hundredth of the errors reached"""
LONGEST = 60.0
"""[s] of the cable's time"""


class Simulator(
    elastica.BaseSystemCollection, elastica.Constraints, elastica.Forcing, elastica.Damping
):
    pass


def rehearse(task: Task):
    """Its functions are compiled when they are first called."""
    _relaxed(replace(task, elements=8), LOOK_EVERY / 10)


def solve(task: Task) -> Found:
    chain, position, time = _relaxed(task, LONGEST)
    unknowns = 6 * task.elements + 3
    return Found(
        chain.nodes[chain.inside],
        position[chain.inside],
        unknowns,
        remark=f"{time:.1f} s of its time",
    )


def _relaxed(task, longest):
    chain = Chain.of(task)
    density = task.mass / (np.pi * task.radius**2)
    rod = _rod(task, chain, density)
    clamped = task.end_position is not None
    simulator = Simulator()
    simulator.append(rod)
    held = {
        "constrained_position_idx": [0, *([1] if chain.nodes[0] < 0 else [])],
        "constrained_director_idx": [0],
    }
    if clamped:
        held["constrained_position_idx"] += [-1, *([-2] if chain.nodes[0] < 0 else [])]
        held["constrained_director_idx"] += [-1]
    simulator.constrain(rod).using(
        elastica.FixedConstraint, **{name: tuple(places) for name, places in held.items()}
    )
    simulator.add_forcing_to(rod).using(elastica.GravityForces, acc_gravity=task.gravity)
    step = STEP * task.radius * np.sqrt(density * np.pi * task.radius**2 / task.shear)
    simulator.dampen(rod).using(
        elastica.AnalyticalLinearDamper, uniform_damping_constant=DAMPING, time_step=step
    )
    simulator.finalize()
    stepper, time = elastica.PositionVerlet(), np.float64(0)
    while time < longest:
        before = rod.position_collection.copy()
        for _ in range(int(min(LOOK_EVERY, longest) / step)):
            time = stepper.step(simulator, time, step)
        moved = np.abs(rod.position_collection - before).max()
        if not np.isfinite(moved):
            raise ArithmeticError(f"its motion diverged after {time:.3g} s of its time")
        if moved < AT_REST * task.length:
            break
    else:
        if longest == LONGEST:
            raise ArithmeticError(f"it does not rest after {LONGEST:g} s of its time")
    return chain, rod.position_collection.T.copy(), time


def _rod(task, chain, density):
    """Straight and unloaded at first, then bent to the start."""
    rod = elastica.CosseratRod.straight_rod(
        task.elements,
        np.zeros(3),
        np.array([0.0, 0.0, 1.0]),
        np.array([1.0, 0.0, 0.0]),
        chain.nodes[-1] - chain.nodes[0],
        task.radius,
        density,
        youngs_modulus=task.axial / (np.pi * task.radius**2),
        shear_modulus=task.shear / (np.pi * task.radius**2),
    )
    stiffness = np.diag([task.shear, task.shear, task.axial])
    rod.shear_matrix[:] = stiffness[:, :, None]
    stiffness = np.diag([task.bending, task.bending, task.torsion])
    rod.bend_matrix[:] = stiffness[:, :, None]
    position, _ = task.start_at(chain.nodes)
    _, quaternion = task.start_at(chain.centres)
    quaternion[0] = task.start_quaternion
    if task.end_position is not None:
        quaternion[-1] = task.end_quaternion
    # The clamped elements where they belong, whatever the start is.
    ends = [(0, task.start_position)]
    if task.end_position is not None:
        ends.append((-1, task.end_position))
    for end, place in ends:
        if task.variant == "centred":
            half = (chain.nodes[1] - chain.nodes[0]) / 2 * rotation.tangent(quaternion[end])
            pair = [0, 1] if end == 0 else [-2, -1]
            position[pair] = place - half, place + half
        else:
            position[end] = place
    rod.position_collection[:] = position.T
    rod.director_collection[:] = np.moveaxis(rotation.matrix(quaternion), 0, -1).swapaxes(0, 1)
    return rod
