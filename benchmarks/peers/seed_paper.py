# SPDX-License-Identifier: LGPL-2.1-or-later
"""The formulation of the paper that this work starts from (Du, Jiang, Xiong, Sci Rep 12, 2022), as a baseline.

Unknown are the Euler parameters of evenly spaced nodes, each with a constraint for its unit norm. Positions are sums of
tangents, curvatures come from differences over three nodes, energies from sums over the nodes, and a general
interior-point solver does the rest. Written anew in CasADi: the paper used AMPL.

Differences over three nodes (variant ``three points``) leave out the one in the middle. So even and odd nodes are two
curves that only share their ends, of which only the mean has to reach the target: slack is cheaper for the two to part
than for one to bend, and no mesh mends that. Variant ``two points`` takes differences within the elements instead, the
kindest reading of the paper; it is the one to beat.
"""

import time
from functools import lru_cache

import casadi as ca
import numpy as np

from benchmarks.peers.task import Found, Task

TOLERANCE = 1e-9
"""That of our own program, so that both solve their discrete problems equally well."""
ITERATIONS = 500


def solve(task: Task) -> Found:
    clamped, unit = task.end_position is not None, task.bending / task.length
    begin = time.perf_counter()
    solver, curve = _program(task.elements, clamped, task.variant)
    build = time.perf_counter() - begin
    _, q = task.start_at(task.arc_length)
    last = task.end_quaternion if clamped else q[-1]
    weight = task.mass * task.gravity * task.length**2 / task.bending * task.length
    given = np.concatenate(
        [
            task.start_quaternion * np.sign(task.start_quaternion @ q[0]),
            last * np.sign(last @ q[-1]),
            (task.end_position - task.start_position) / task.length if clamped else np.zeros(3),
            [1.0, task.torsion / task.bending],
            weight,
        ]
    )
    free = q[1:-1] if clamped else q[1:]
    found = solver(x0=free.ravel(), p=given, lbg=0, ubg=0)
    if not solver.stats()["success"]:
        raise ArithmeticError(f"ipopt: {solver.stats()['return_status']}")
    position = task.start_position + task.length * curve(found["x"], given).full()
    remark = f"{solver.stats()['iter_count']} iterations, energy {float(found['f']) * unit:.9g} J"
    return Found(task.arc_length, position, free.size, build, remark)


@lru_cache
def _program(elements, clamped, variant):
    """(solver, its unknowns and parameters → positions (n+1, 3)), without units: lengths in L, energies in EI/L."""
    h = 1 / elements
    first, last = ca.SX.sym("first", 4), ca.SX.sym("last", 4)
    target, weight = ca.SX.sym("target", 3), ca.SX.sym("weight", 3)
    bending, torsion = ca.SX.sym("bending"), ca.SX.sym("torsion")
    given = ca.vertcat(first, last, target, bending, torsion, weight)
    free = ca.SX.sym("q", 4, elements - 1 if clamped else elements)
    q = ca.horzcat(first, free, last) if clamped else ca.horzcat(first, free)
    if variant == "three points":
        at, share = q, ca.DM([h / 2] + [h] * (elements - 1) + [h / 2])
        slope = ca.horzcat(
            (-3 * q[:, 0] + 4 * q[:, 1] - q[:, 2]) / (2 * h),
            (q[:, 2:] - q[:, :-2]) / (2 * h),
            (3 * q[:, -1] - 4 * q[:, -2] + q[:, -3]) / (2 * h),
        )
    else:
        at, share = (q[:, 1:] + q[:, :-1]) / 2, ca.DM([h] * elements)
        slope = (q[:, 1:] - q[:, :-1]) / h
    curvature = _curvature(at, slope)
    elastic = (
        bending * (curvature[0, :] ** 2 + curvature[1, :] ** 2) + torsion * curvature[2, :] ** 2
    )
    w, x, y, z = (q[i, :] for i in range(4))
    tangent = ca.vertcat(2 * (x * z + w * y), 2 * (y * z - w * x), w**2 - x**2 - y**2 + z**2)
    position = [ca.SX.zeros(3)]
    for k in range(elements):
        position.append(position[-1] + h * (tangent[:, k] + tangent[:, k + 1]) / 2)
    position = ca.horzcat(*position)
    weights = ca.DM([h / 2] + [h] * (elements - 1) + [h / 2])
    energy = ca.mtimes(elastic / 2, share) - ca.mtimes(ca.mtimes(weight.T, position), weights)
    rows = [ca.sum1(free**2).T - 1]
    if clamped:
        rows.append(position[:, -1] - target)
    program = {"x": ca.vec(free), "p": given, "f": energy, "g": ca.vertcat(*rows)}
    options = {
        "print_time": False,
        "error_on_fail": False,
        "show_eval_warnings": False,
        "ipopt": {"print_level": 0, "sb": "yes", "tol": TOLERANCE, "max_iter": ITERATIONS},
    }
    solver = ca.nlpsol("seed_paper", "ipopt", program, options)
    return solver, ca.Function("curve", [ca.vec(free), given], [position.T])


def _curvature(q, slope):
    """κ = 2 vec(conj(q) ∘ q'), (3, k)"""
    w, x, y, z = (q[i, :] for i in range(4))
    a, b, c, d = (slope[i, :] for i in range(4))
    return 2 * ca.vertcat(
        w * b - x * a - y * d + z * c, w * c + x * d - y * a - z * b, w * d - x * c + y * b - z * a
    )
