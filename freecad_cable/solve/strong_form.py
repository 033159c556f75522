# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far the nodes are from the exact equilibrium: one Newton step of the strong form, in NumPy.

The rod's differential equations are integrated over each element from its first node (Runge–Kutta of order
4 in substeps); what is missing at its last node is the element's defect. The linearised boundary value
problem turns the defects into corrections of all nodes at once (multiple shooting; Ascher, Mattheij, Russell,
*Numerical Solution of Boundary Value Problems*, 1995, ch. 4). The size of the correction is the error, up to
its square. It shares nothing with the transcription but the nodes.

    r' = R (e₃ + γ),  q' = ½ q ∘ κ,  n' = −w,  m' = −r' × n,  κ = κ⁰ + K⁻¹ Rᵀ m,  γ = C Rᵀ n
"""

import numpy as np
from scipy.linalg import lstsq
from scipy.sparse import csc_matrix
from scipy.sparse.linalg import splu

from ..geometry import rotation

SUBSTEPS = 4
"""Runge–Kutta steps in an element: leaves 1/4⁴ of an order-4 element's own error unseen."""


def correction(shape, values, start_kind, end_kind, strains):
    """(corrections, defects) of the nodes, each (…, 12): position, turn (world), force, moment.

    Corrections (n+1, 12), defects (n, 12), without units. ``strains`` are the indices that the model keeps.
    """
    compliance = np.zeros(6)
    kept = list(strains)
    compliance[kept] = 1 / values["stiffness"][kept]
    law = _Law(compliance, values["natural"], values["weight"])
    state = np.hstack([shape.position, shape.quaternion, shape.force, shape.moment])
    reached = law.integrate(state[:-1], shape.steps)
    turn = rotation.logarithm(
        rotation.multiply(state[1:, 3:7], rotation.conjugate(reached[:, 3:7]))
    )
    defects = np.hstack(
        [state[1:, :3] - reached[:, :3], turn, state[1:, 7:] - reached[:, 7:]]
    )
    transfer = law.transfer((state[1:] + state[:-1]) / 2, shape.steps)
    first = _end_rows(start_kind, shape.quaternion[0], shape.force[0], shape.moment[0])
    last = _end_rows(end_kind, shape.quaternion[-1], shape.force[-1], shape.moment[-1])
    if 2 not in strains and start_kind != "clamped":
        first = _fix_roll(first, shape.quaternion[0])
    return _solve(transfer, defects, first, last), defects


class _Law:
    """The right-hand side and its linearisation, for many elements at once."""

    def __init__(self, compliance, natural, weight):
        self.bend, self.shear = compliance[:3], compliance[3:]
        self.natural, self.weight = natural, weight

    def rate(self, y):
        q, n, m = y[:, 3:7], y[:, 7:10], y[:, 10:]
        frames = rotation.matrix(q)
        kappa = self.natural + self.bend * np.einsum("kij,ki->kj", frames, m)
        v = (0, 0, 1) + self.shear * np.einsum("kij,ki->kj", frames, n)
        slope = np.einsum("kij,kj->ki", frames, v)
        turning = rotation.multiply(q, np.hstack([np.zeros((len(q), 1)), kappa])) / 2
        weight = np.broadcast_to(-self.weight, n.shape)
        return np.hstack([slope, turning, weight, -np.cross(slope, n)])

    def integrate(self, y, steps):
        h = (steps / SUBSTEPS)[:, None]
        for _ in range(SUBSTEPS):
            a = self.rate(y)
            b = self.rate(y + h / 2 * a)
            c = self.rate(y + h / 2 * b)
            d = self.rate(y + h * c)
            y = y + h / 6 * (a + 2 * b + 2 * c + d)
            y[:, 3:7] /= np.linalg.norm(y[:, 3:7], axis=1)[:, None]
        return y

    def transfer(self, y, steps):
        """(n, 12, 12): how a change at the first node of an element arrives at its last."""
        q = y[:, 3:7] / np.linalg.norm(y[:, 3:7], axis=1)[:, None]
        frames, n, m = rotation.matrix(q), _hat(y[:, 7:10]), _hat(y[:, 10:])
        bend = np.einsum("kij,j,klj->kil", frames, self.bend, frames)
        shear = np.einsum("kij,j,klj->kil", frames, self.shear, frames)
        v = (0, 0, 1) + self.shear * np.einsum("kij,ki->kj", frames, y[:, 7:10])
        slope = _hat(np.einsum("kij,kj->ki", frames, v))
        rate = np.zeros((len(y), 12, 12))
        rate[:, 0:3, 3:6] = shear @ n - slope
        rate[:, 0:3, 6:9] = shear
        rate[:, 3:6, 3:6] = bend @ m
        rate[:, 3:6, 9:12] = bend
        rate[:, 9:12, 3:9] = n @ rate[:, 0:3, 3:9]
        rate[:, 9:12, 6:9] -= slope
        step = rate * steps[:, None, None]
        square = step @ step
        return np.eye(12) + step + square / 2 + square @ step / 6 + square @ square / 24


def _hat(v):
    """(n, 3, 3) matrices of the cross products v ×."""
    x, y, z = v.T
    o = np.zeros_like(x)
    return np.moveaxis(np.array([[o, -z, y], [z, o, -x], [-y, x, o]]), -1, 0)


def _end_rows(kind, quaternion, force, moment):
    """(matrix (6, 12), values (6,)) of the conditions that an end puts on a correction."""
    eye = np.eye(12)
    frame = rotation.matrix(quaternion).T
    held, zero = eye[0:3], np.zeros(3)
    if kind == "clamped":
        return np.vstack([held, eye[3:6]]), np.zeros(6)
    if kind == "pinned":
        return np.vstack([held, eye[9:12]]), np.append(zero, -moment)
    if kind == "free":
        return np.vstack([eye[6:9], eye[9:12]]), np.append(-force, -moment)
    turn, torque = np.zeros((2, 12)), np.zeros((1, 12))
    turn[:, 3:6] = frame[:2]
    torque[0, 9:12] = frame[2]
    torque[0, 3:6] = np.cross(moment, frame[2])
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


def _solve(transfer, defects, first, last):
    n = len(transfer)
    size = 12 * (n + 1)
    block_rows, block_cols = np.meshgrid(np.arange(12), np.arange(12), indexing="ij")
    offset = 12 * np.arange(n)[:, None, None]
    eye_index = np.arange(12 * n)
    rows = [(6 + offset + block_rows).ravel(), 6 + eye_index]
    cols = [(offset + block_cols).ravel(), 12 + eye_index]
    data = [-transfer.ravel(), np.ones(12 * n)]
    for (matrix, _), row, col in ((first, 0, 0), (last, size - 6, size - 12)):
        i, j = np.nonzero(matrix)
        rows.append(row + i)
        cols.append(col + j)
        data.append(matrix[i, j])
    matrix = csc_matrix(
        (np.concatenate(data), (np.concatenate(rows), np.concatenate(cols))), (size, size)
    )
    right = np.concatenate([first[1], -defects.ravel(), last[1]])
    try:
        answer = splu(matrix).solve(right)
        resolved = np.abs(answer).max() < 1e6 * np.abs(right).max() + 1e-300
    except RuntimeError:
        resolved = False
    if not resolved:
        # A rod that may move as a whole (a circle of solutions) has no unique correction: the shortest.
        answer = lstsq(matrix.toarray(), right, cond=1e-10)[0]
    return answer.reshape(n + 1, 12)
