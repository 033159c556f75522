# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exudyn's geometrically exact beam of two nodes, its static solver with load steps (Newton's method).

Variant ``from the start`` goes no way but begins with the nodes given, bent as they are.
"""

import exudyn
import numpy as np
from exudyn import itemInterface as items

from benchmarks.peers.beam_path import BEAM_AXES, Path, to_beam, to_world
from benchmarks.peers.task import Found, Task
from freecad_cable.geometry import rotation

HELD = (0, 1, 2, 4, 5, 6)
"""Position and vector part of the Euler parameters; the scalar part follows from the norm."""


def solve(task: Task) -> Found:
    clamped, given = task.end_position is not None, task.variant == "from the start"
    path = Path(task) if clamped else None
    system = exudyn.SystemContainer().AddSystem()
    nodes = _nodes(system, task, given)
    _elements(system, task, nodes)
    ground = system.AddNode(items.NodePointGround())
    ground = system.AddMarker(items.MarkerNodeCoordinate(nodeNumber=ground, coordinate=0))
    _hold(system, ground, nodes[0])
    if clamped:
        _hold(system, ground, nodes[-1], lambda time: _offsets(path, task, 1 if given else time))
    _weigh(system, task, nodes, (lambda _: 1.0) if given else path.weight if clamped else float)
    system.Assemble()
    settings = exudyn.SimulationSettings()
    static = settings.staticSolver
    static.numberOfLoadSteps = 1 if given else task.steps
    static.verboseMode = 0
    static.newton.relativeTolerance = 1e-9
    static.newton.absoluteTolerance = 1e-12
    static.newton.maxIterations = 50
    settings.solutionSettings.writeSolutionToFile = False
    settings.linearSolverType = exudyn.LinearSolverType.EigenSparse
    if not system.SolveStatic(settings):
        raise ArithmeticError("its static solver did not converge")
    kind = exudyn.OutputVariableType.Position
    position = np.array([system.GetNodeOutput(node, kind) for node in nodes])
    return Found(task.arc_length, to_world(task, position), 7 * len(nodes))


def _nodes(system, task, given):
    straight = np.zeros((task.elements + 1, 7))
    straight[:, 0] = task.arc_length
    straight[:, 3] = 1.0
    bent = straight
    if given:
        position, quaternion = task.start_at(task.arc_length)
        turns = rotation.multiply(rotation.conjugate(task.start_quaternion), quaternion)
        turns = rotation.continuous(turns) * np.sign(turns[0, 0])
        place = to_beam(task, position - task.start_position)
        bent = np.hstack([place, turns[:, :1], turns[:, 1:] @ BEAM_AXES.T])
    return [
        system.AddNode(items.NodeRigidBodyEP(referenceCoordinates=a, initialCoordinates=b - a))
        for a, b in zip(straight, bent, strict=True)
    ]


def _elements(system, task, nodes):
    section = exudyn.BeamSection()
    stiffness = [task.axial, task.shear, task.shear, task.torsion, task.bending, task.bending]
    section.stiffnessMatrix = np.diag(stiffness)
    section.massPerLength = task.mass
    section.inertia = task.mass * task.radius**2 / 4 * np.diag([2.0, 1.0, 1.0])
    for pair in zip(nodes, nodes[1:], strict=False):
        beam = items.ObjectBeamGeometricallyExact(
            nodeNumbers=list(pair), physicsLength=task.length / task.elements, sectionData=section
        )
        system.AddObject(beam)


def _hold(system, ground, node, offsets=None):
    """Hold the coordinates of a node; where ``offsets(time)`` (6,) are given, so far from where they begin."""
    for i, coordinate in enumerate(HELD):
        marker = system.AddMarker(
            items.MarkerNodeCoordinate(nodeNumber=node, coordinate=coordinate)
        )
        led = {}
        if offsets is not None:
            led["offsetUserFunction"] = lambda _, time, item, given, i=i: float(offsets(time)[i])
        system.AddObject(items.ObjectConnectorCoordinate(markerNumbers=[ground, marker], **led))


def _offsets(path, task, time):
    turn = rotation.exponential(path.rotation(time))
    return np.concatenate([path.place(time) - [task.length, 0, 0], turn[1:]])


def _weigh(system, task, nodes, share):
    """Half of the weight of each element on each of its nodes."""
    weight = to_beam(task, task.mass * task.gravity) * task.length / task.elements
    for k, node in enumerate(nodes):
        load = weight / 2 if k in (0, len(nodes) - 1) else weight
        system.AddLoad(
            items.LoadForceVector(
                markerNumber=system.AddMarker(items.MarkerNodePosition(nodeNumber=node)),
                loadVector=load.tolist(),
                loadVectorUserFunction=lambda _, time, given: (
                    share(time) * np.array(given)
                ).tolist(),
            )
        )
