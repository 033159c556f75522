# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far the nodes are from the exact equilibrium: one Newton step of the strong form.

The rod's differential equations are integrated over each element from its first node (Runge–Kutta of order
4 in substeps); what is missing at its last node is the element's defect. The linearised boundary value
problem turns the defects into corrections of all nodes at once (multiple shooting; Ascher, Mattheij, Russell,
*Numerical Solution of Boundary Value Problems*, 1995, ch. 4). The size of the correction is the error, up to
its square. It shares nothing with the transcription but the nodes; for the equations see ``law``.
"""

import numpy as np

from ..geometry import rotation
from . import joints
from .law import Law
from .linear import LinearProblem, solved

LAYERS = 2.0
"""Longest element in bending layers: Runge–Kutta steps of half a layer, far from the end of their stability."""
MOST_PARTS = 100


def correction(shape, values, structure) -> np.ndarray:
    """Corrections (n+1, 12) of the nodes without units: position, turn (world), force, moment.

    Infinite where the rod cannot be integrated at all: such nodes are no rod."""
    compliance, law = _law(values, structure)
    parts, given = [], []
    for part in shape.parts():
        arc_length, own = _resolving(part, compliance)
        parts.append(part.on(arc_length))
        given.append(own)
    states, (transfer, defects) = _over(law, parts)
    if not np.isfinite(defects).all():
        return np.full((len(shape.arc_length), 12), np.inf)
    first, last = states[0][0], states[-1][-1]
    first_rows = _end_rows(structure.start, first[3:7], first[7:10], first[10:])
    last_rows = _end_rows(structure.end, last[3:7], last[7:10], last[10:])
    if structure.rolls:
        first_rows = _fix_roll(first_rows, first[3:7])
    found = None if shape.joints else solved(transfer, defects, first_rows, last_rows)
    if found is not None:
        return found[given[0]]
    linear = LinearProblem([len(part.steps) for part in parts])
    linear.elements(transfer, defects)
    linear.ends(first_rows, last_rows)
    if shape.joints:
        joints.add(linear, shape, values, structure, law, states, parts)
    found = linear.solve()
    # A joint is known from both sides; the nodes of a shape are those just before it.
    return np.vstack(
        [
            own[index if k == 0 else index[1:]]
            for k, (own, index) in enumerate(zip(found, given, strict=True))
        ]
    )


def defect(shape, values, structure, elements) -> float:
    """By how much some ``elements`` (n,) of a shape miss the equations in sum, without units."""
    _, (_, defects) = _over(_law(values, structure)[1], shape.parts())
    # Of a shape that is no rod they are so large that their squares are no numbers.
    return float(np.hypot.reduce(defects[elements, :6], axis=1).sum())


def _law(values, structure):
    """Compliance (6,) of the strains that are kept, and the law."""
    compliance = np.zeros(6)
    kept = list(structure.strains)
    compliance[kept] = 1 / values["stiffness"][kept]
    limit = float(values["curvature_limit"]) if structure.bend_limit else np.inf
    return compliance, Law(compliance, values["natural"], values["weight"], limit)


def _over(law, parts):
    """States of the nodes of each part of a shape, and what a law says of all elements."""
    states = [
        np.hstack([part.position, part.quaternion, part.force, part.moment]) for part in parts
    ]
    before, after = (np.concatenate([y[cut] for y in states]) for cut in (np.s_[:-1], np.s_[1:]))
    return states, law.elements(before, after, np.concatenate([part.steps for part in parts]))


def _resolving(shape, compliance):
    """(arc lengths, indices of the shape's own nodes): elements split until none is longer than
    ``LAYERS`` bending layers √(EI/T). Over longer ones the growing solutions drown everything; what is
    interpolated in between is wrong to second order, which the Newton step squares."""
    tension = np.linalg.norm(shape.force, axis=1)
    tension = np.maximum(tension[1:], tension[:-1])
    parts = shape.steps * np.sqrt(tension * compliance[:2].max()) / LAYERS
    if parts.max() <= 1:
        return shape.arc_length, np.arange(len(shape.arc_length))
    parts = np.clip(np.ceil(parts), 1, MOST_PARTS).astype(int)
    given = np.concatenate([[0], np.cumsum(parts)])
    element = np.repeat(np.arange(len(parts)), parts)
    within = (np.arange(given[-1]) - given[element]) * (shape.steps / parts)[element]
    return np.append(shape.arc_length[element] + within, shape.arc_length[-1]), given


def _end_rows(kind, quaternion, force, moment):
    """(matrix (6, 12), values (6,)) of the conditions that an end puts on a correction."""
    eye = np.eye(12)
    if kind == "clamped":
        return eye[:6], np.zeros(6)
    frame = rotation.matrix(quaternion).T
    held, zero = eye[0:3], np.zeros(3)
    if kind == "pinned":
        return np.vstack([held, eye[9:12]]), np.append(zero, -moment)
    if kind == "free":
        return eye[6:], np.append(-force, -moment)
    turn, torque = np.zeros((2, 12)), np.zeros((1, 12))
    turn[:, 3:6] = frame[:2]
    torque[0, 9:12] = frame[2]
    torque[0, 3:6] = rotation.cross(moment, frame[2])
    return np.vstack([held, turn, torque]), np.concatenate([zero, [0, 0, -frame[2] @ moment]])


def _fix_roll(rows, quaternion):
    """Replace the condition on the torque, which vanishes everywhere, by one on the roll, which is free."""
    matrix, values = rows
    d3 = rotation.tangent(quaternion)
    torque = matrix[:, 9:12] @ d3
    k = int(np.argmax(np.abs(torque)))
    matrix, values = matrix.copy(), values.copy()
    matrix[k] = 0
    matrix[k, 3:6] = d3
    values[k] = 0
    return matrix, values
