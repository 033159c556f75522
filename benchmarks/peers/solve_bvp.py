# SPDX-License-Identifier: LGPL-2.1-or-later
"""SciPy's ``solve_bvp``, a general collocation solver of order 4 with its own mesh refinement, on the rod in strong
form: position, quaternion, force and moment, 13 unknowns a node, lengths in L and forces in EI/L².

Variant ``derivatives given`` tells it the exact ones, as somebody who knows the rod can; ``own differences`` leaves it
to itself."""

import numpy as np
from scipy.integrate import solve_bvp

from benchmarks.peers.task import Found, Task
from freecad_cable.problem import Clamped, Free
from freecad_cable.reference import held
from freecad_cable.reference.rod_equations import RodEquations

MOST_NODES = 20_000


def solve(task: Task) -> Found:
    length, force = task.length, task.bending / task.length**2
    stiffness = np.array([1.0, 1.0, task.torsion / task.bending])
    rod = RodEquations(
        stiffness, np.zeros(3), np.zeros(3), task.mass * task.gravity * length / force
    )
    first = held.with_unit_quaternion(
        held.conditions(
            Clamped(task.start_position / length, task.start_quaternion), np.zeros(3), np.zeros(3)
        )
    )
    last = held.conditions(_end(task), np.zeros(3), np.zeros(3))

    def rates(_, y):
        return rod.rate(y.T)[0].T

    def rate_slopes(_, y):
        return np.moveaxis(rod.rate(y.T)[1], 0, -1)

    def missing(a, b):
        return np.concatenate([first(a)[0], last(b)[0]])

    def missing_slopes(a, b):
        zero = np.zeros((13, 13))
        at_start, at_end = zero.copy(), zero.copy()
        slope = first(a)[1]
        at_start[: len(slope)] = slope
        at_end[len(slope) :] = last(b)[1]
        return at_start, at_end

    nodes, given = task.start, task.variant == "derivatives given"
    loads = [
        np.zeros_like(nodes.position) if load is None else load / unit
        for load, unit in ((nodes.force, force), (nodes.moment, force * length))
    ]
    guess = np.hstack([nodes.position / length, nodes.quaternion, *loads]).T
    found = solve_bvp(
        rates,
        missing,
        nodes.arc_length / length,
        guess,
        fun_jac=rate_slopes if given else None,
        bc_jac=missing_slopes if given else None,
        tol=task.tolerance,
        max_nodes=MOST_NODES,
    )
    if not found.success:
        raise ArithmeticError(found.message)
    return Found(found.x * length, found.y[:3].T * length, found.y.size)


def _end(task):
    if task.end_position is None:
        return Free()
    return Clamped(task.end_position / task.length, task.end_quaternion)
