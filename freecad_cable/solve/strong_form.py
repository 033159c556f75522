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

from ..geometry import rotation
from . import joints
from .linear import LinearProblem

SUBSTEPS = 3
"""Runge–Kutta steps in an element: leaves 1/3⁴ of an order-4 element's own error unseen."""

LAYERS = 2.0
"""Longest element in bending layers: Runge–Kutta steps of half a layer, far from the end of their stability."""
MOST_PARTS = 100


def correction(shape, values, structure) -> np.ndarray:
    """Corrections (n+1, 12) of the nodes without units: position, turn (world), force, moment.

    Infinite where the rod cannot be integrated at all: such nodes are no rod."""
    compliance = np.zeros(6)
    kept = list(structure.strains)
    compliance[kept] = 1 / values["stiffness"][kept]
    limit = float(values["curvature_limit"]) if structure.bend_limit else np.inf
    law = Law(compliance, values["natural"], values["weight"], limit)
    parts, given = [], []
    for part in shape.parts():
        arc_length, own = _resolving(part, compliance)
        parts.append(part.on(arc_length))
        given.append(own)
    states = [
        np.hstack([part.position, part.quaternion, part.force, part.moment]) for part in parts
    ]
    before, after = (np.vstack([y[cut] for y in states]) for cut in (np.s_[:-1], np.s_[1:]))
    steps = np.concatenate([part.steps for part in parts])
    with np.errstate(all="ignore"):
        reached = law.integrate(before, steps)
    if not np.isfinite(reached).all():
        return np.full((len(shape.arc_length), 12), np.inf)
    turn = rotation.logarithm(rotation.multiply(after[:, 3:7], rotation.conjugate(reached[:, 3:7])))
    defects = np.hstack([after[:, :3] - reached[:, :3], turn, after[:, 7:] - reached[:, 7:]])
    transfer = law.transfer((after + before) / 2, steps)
    first, last = states[0][0], states[-1][-1]
    first_rows = _end_rows(structure.start, first[3:7], first[7:10], first[10:])
    last_rows = _end_rows(structure.end, last[3:7], last[7:10], last[10:])
    if structure.rolls:
        first_rows = _fix_roll(first_rows, first[3:7])
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


def _resolving(shape, compliance):
    """(arc lengths, indices of the shape's own nodes): elements split until none is longer than
    ``LAYERS`` bending layers √(EI/T). Over longer ones the growing solutions drown everything; what is
    interpolated in between is wrong to second order, which the Newton step squares."""
    tension = np.linalg.norm(shape.force, axis=1)
    tension = np.maximum(tension[1:], tension[:-1])
    parts = shape.steps * np.sqrt(tension * compliance[:2].max()) / LAYERS
    parts = np.clip(np.ceil(parts), 1, MOST_PARTS).astype(int)
    given = np.concatenate([[0], np.cumsum(parts)])
    element = np.repeat(np.arange(len(parts)), parts)
    within = (np.arange(given[-1]) - given[element]) * (shape.steps / parts)[element]
    return np.append(shape.arc_length[element] + within, shape.arc_length[-1]), given


class Law:
    """The right-hand side and its linearisation, for many elements at once."""

    def __init__(self, compliance, natural, weight, limit=np.inf):
        self.bend, self.shear = compliance[:3], compliance[3:]
        self.natural, self.weight, self.limit = natural, weight, limit

    def curvature(self, moment):
        """(n, 3) curvature and twist from the moment in the material frame (n, 3)."""
        kappa = self.natural + self.bend * moment
        if np.isfinite(self.limit):
            over, kappa[over, :2], _ = self._limited(kappa, moment)
        return kappa

    def _limited(self, kappa, moment):
        """(n,) where the limit acts, and there curvature (k, 2) and 1/(K + μ) (k, 2): where the rod is held at the
        limit, κ minimises its energy less m·κ on |κ| = limit, and so (K + μ) κ = m + K κ⁰ with a multiplier μ."""
        over = np.linalg.norm(kappa[:, :2], axis=1) > self.limit
        pull = kappa[over, :2] / self.bend[:2]
        mu = np.zeros((len(pull), 1))
        for _ in range(20):
            soft = 1 / (1 / self.bend[:2] + mu)
            bent = soft * pull
            size = np.linalg.norm(bent, axis=1, keepdims=True)
            slope = -(bent * soft * bent).sum(axis=1, keepdims=True) / size
            mu += (size / self.limit - 1) * size / -slope
        return over, bent, soft

    def compliance(self, moment):
        """(n, 3, 3) change of curvature with the moment, material frame."""
        found = np.tile(np.diag(self.bend), (len(moment), 1, 1))
        if np.isfinite(self.limit):
            over, bent, soft = self._limited(self.natural + self.bend * moment, moment)
            across = soft * bent
            held = np.einsum("ki,kj->kij", across, across)
            held /= (bent * across).sum(axis=1)[:, None, None]
            found[over, :2, :2] = soft[:, :, None] * np.eye(2) - held
        return found

    def rate(self, y):
        q, n, m = y[:, 3:7], y[:, 7:10], y[:, 10:]
        frames = rotation.matrix(q)
        kappa = self.curvature(np.einsum("kij,ki->kj", frames, m))
        v = (0, 0, 1) + self.shear * np.einsum("kij,ki->kj", frames, n)
        slope = np.einsum("kij,kj->ki", frames, v)
        turning = rotation.multiply(q, np.hstack([np.zeros((len(q), 1)), kappa])) / 2
        weight = np.broadcast_to(-self.weight, n.shape)
        return np.hstack([slope, turning, weight, -rotation.cross(slope, n)])

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
        """Two matrices (n, 12, 12), P and Q: a change a at the first node of an element arrives at the last as b
        with P b = Q a. The Padé form of the exponential keeps growing modes growing and decaying ones
        decaying, however long the element is against the bending layer; a Taylor form does not."""
        q = y[:, 3:7] / np.linalg.norm(y[:, 3:7], axis=1)[:, None]
        frames, n, m = (
            rotation.matrix(q),
            rotation.cross_matrix(y[:, 7:10]),
            rotation.cross_matrix(y[:, 10:]),
        )
        moment = np.einsum("kij,ki->kj", frames, y[:, 10:])
        bend = frames @ self.compliance(moment) @ np.swapaxes(frames, 1, 2)
        shear = np.einsum("kij,j,klj->kil", frames, self.shear, frames)
        v = (0, 0, 1) + self.shear * np.einsum("kij,ki->kj", frames, y[:, 7:10])
        slope = rotation.cross_matrix(np.einsum("kij,kj->ki", frames, v))
        rate = np.zeros((len(y), 12, 12))
        rate[:, 0:3, 3:6] = shear @ n - slope
        rate[:, 0:3, 6:9] = shear
        rate[:, 3:6, 3:6] = bend @ m
        rate[:, 3:6, 9:12] = bend
        rate[:, 9:12, 3:9] = n @ rate[:, 0:3, 3:9]
        rate[:, 9:12, 6:9] -= slope
        half = rate * (steps / 2)[:, None, None]
        even, odd = np.eye(12) + half @ half / 3, half
        return even - odd, even + odd


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
