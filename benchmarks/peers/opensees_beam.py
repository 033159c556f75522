# SPDX-License-Identifier: LGPL-2.1-or-later
"""OpenSees' elastic beam-columns in corotational frames, load control with Newton's method, and steps that are halved
where that fails."""

import numpy as np
import openseespy.opensees as ops

from benchmarks.peers.beam_path import Path, to_beam, to_world
from benchmarks.peers.task import Found, Task

HALVINGS = 10
SAMPLES = 801
CONVERGED = 1e-8
"""Norm of the last change, in metres and radians: below it Newton's method no longer gets."""


def solve(task: Task) -> Found:
    clamped = task.end_position is not None
    count = task.elements + 1
    ops.wipe()
    ops.model("basic", "-ndm", 3, "-ndf", 6)
    for k, x in enumerate(task.arc_length):
        ops.node(k + 1, float(x), 0.0, 0.0)
    ops.fix(1, *[1] * 6)
    # Area and both moduli are one number each; A and I are what makes EA and EI of it.
    ops.geomTransf("Corotational", 1, 0.0, 0.0, 1.0)
    for k in range(1, count):
        section = (task.axial, 1.0, 1.0, task.torsion, task.bending, task.bending)
        ops.element("elasticBeamColumn", k, k, k + 1, *section, 1)
    _load(task, count, Path(task) if clamped else None)
    ops.constraints("Transformation")
    ops.numberer("RCM")
    ops.system("BandGeneral")
    ops.test("NormDispIncr", CONVERGED, 25)
    ops.algorithm("Newton")
    _go(task.steps)
    position = np.array(
        [np.add(ops.nodeCoord(k + 1), ops.nodeDisp(k + 1)[:3]) for k in range(count)]
    )
    return Found(task.arc_length, to_world(task, position), 6 * count)


def _go(steps):
    smallest = 1 / steps / 2**HALVINGS
    step, reached = 1 / steps, 0.0
    while 1 - reached > smallest / 2:
        step = min(step, 1 - reached)
        ops.integrator("LoadControl", step)
        ops.analysis("Static", "-noWarnings")
        if ops.analyze(1) == 0:
            reached, step = reached + step, min(2 * step, 1 / steps)
        elif (step := step / 2) < smallest:
            raise ArithmeticError(f"Newton's method fails {reached:.0%} of the way")


def _load(task, count, path):
    """Half of the weight of each element on each of its nodes, and the way of the end."""
    series = {"times": [0.0, 1.0], "shares": [0.0, 1.0]}
    if path is not None:
        times = np.linspace(0, 1, SAMPLES)
        series = {"times": times.tolist(), "shares": [path.weight(t) for t in times]}
    _path(1, **series)
    ops.pattern("Plain", 1, 1)
    weight = to_beam(task, task.mass * task.gravity) * task.length / task.elements
    for k in range(count):
        share = weight / 2 if k in (0, count - 1) else weight
        ops.load(k + 1, *share.tolist(), 0.0, 0.0, 0.0)
    if path is None:
        return
    led = [np.concatenate([path.place(t) - [task.length, 0, 0], path.rotation(t)]) for t in times]
    for i, values in enumerate(np.transpose(led)):
        _path(i + 2, times.tolist(), values.tolist())
        ops.pattern("Plain", i + 2, i + 2)
        ops.sp(count, i + 1, 1.0)


def _path(tag, times, shares):
    ops.timeSeries("Path", tag, "-time", *times, "-values", *shares, "-useLast")
