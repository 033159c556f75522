# SPDX-License-Identifier: LGPL-2.1-or-later
"""What supports put on the correction of a rod: held poses, forces in the directions held, and free arc lengths.

At a support the pose is continuous, C δ = 0 holds in the held directions, the loads jump by Cᵀλ + (∇²g λ) δ, and where
the rod slides the energy flux H = n·r' + m·κ − W is continuous (the balance of configurational forces; Bigoni et al.,
"Eshelby-like forces acting on elastic structures", Mech. Mater. 80 (2015)).
"""

import numpy as np

from ..geometry import rotation

ON_RIM = 1e-5
"""Distance to the rim of a ring, without units, below which it may push."""


def add(linear, shape, values, structure, law, states, parts):
    """The rows of all joints, and with sliding ones the lengths of the stretches as unknowns."""
    lengths = None
    if structure.slides:
        lengths = linear.unknowns(len(parts))
        _free_lengths(linear, law, states, parts, lengths)
        linear.add([(np.ones((1, len(lengths))), lengths)], 0.0, border=True)
    for j, joint in enumerate(shape.joints):
        here, beyond = states[j][-1], states[j + 1][0]
        matrix, stiffness = _held(structure.supports[j], values["supports"][j], here, joint)
        a, b = linear.node(j, -1), linear.node(j + 1, 0)
        eye = np.eye(12)
        linear.add([(eye[:6], b), (-eye[:6], a)], np.zeros(6))
        linear.add([(np.hstack([matrix, np.zeros_like(matrix)]), a)], np.zeros(len(matrix)))
        load = np.concatenate([joint.force, joint.moment])
        multipliers = np.linalg.lstsq(matrix.T, load, rcond=None)[0]
        bent = np.zeros((6, 12))
        bent[:, :6] = stiffness
        linear.add(
            [(eye[6:], b), (-eye[6:] + bent, a), (matrix.T, linear.unknowns(len(matrix), a))],
            load - matrix.T @ multipliers,
        )
        if structure.sliding[j]:
            flux, slope = _flux(law, here)
            flux_beyond, slope_beyond = _flux(law, beyond)
            linear.add([(slope_beyond, b), (-slope, a)], flux - flux_beyond, border=True)
        elif structure.slides:
            linear.add([(np.ones((1, j + 1)), lengths[: j + 1])], 0.0, border=True)


def _held(kind, support, state, joint):
    """(C (k, 6), ∇²g λ (6, 6)) over position and turn."""
    eye, stiffness = np.eye(6), np.zeros((6, 6))
    if kind == "clamp":
        return eye, stiffness
    if kind == "eyelet":
        return eye[:3], stiffness
    frame = rotation.matrix(state[3:7])
    if kind == "sleeve":
        turns = np.hstack([np.zeros((2, 3)), frame[:, :2].T])
        return np.vstack([eye[:3], turns]), stiffness
    axis = rotation.tangent(support["quaternion"])
    rows = [np.append(axis, np.zeros(3))]
    offset, play = state[:3] - support["position"], float(support["play"])
    out = offset / max(np.linalg.norm(offset), 1e-300)
    push = -joint.force @ out
    if push > 0 and play - np.linalg.norm(offset) < ON_RIM:
        rows.append(np.append(out, np.zeros(3)))
        stiffness[:3, :3] = -push / play * np.eye(3)
    return np.array(rows), stiffness


def _flux(law, y):
    """(H, its derivative (1, 12)) of a state (13,)."""
    frame = rotation.matrix(y[3:7])
    force, moment = frame.T @ y[7:10], frame.T @ y[10:]
    curvature = law.curvature(moment)
    strain = curvature - law.natural
    slope = frame @ (np.array([0, 0, 1.0]) + law.shear * force)
    kappa = frame @ curvature
    stored = np.divide(strain**2, law.bend, out=np.zeros(3), where=law.bend > 0).sum() / 2
    flux = force[2] + moment @ curvature - stored + force @ (law.shear * force) / 2
    turn = -np.cross(y[10:], kappa) - np.cross(y[7:10], slope)
    return flux, np.concatenate([np.zeros(3), turn, slope, kappa])[None]


def _free_lengths(linear, law, states, parts, lengths):
    """A longer stretch moves the far node of each element along the rod by its share."""
    begin = 0
    for column, state, part in zip(lengths, states, parts, strict=True):
        share = part.steps / part.steps.sum()
        rate = law.rate(state[1:])
        spin = 2 * rotation.multiply(rate[:, 3:7], rotation.conjugate(state[1:, 3:7]))[:, 1:]
        growth = np.hstack([rate[:, :3], spin, rate[:, 7:]]) * share[:, None]
        count = len(share)
        moved = np.einsum("kij,kj->ki", linear.after[begin : begin + count], growth)
        rows = linear.element_rows[begin : begin + count, None] + np.arange(12)
        linear.add_to(rows.ravel(), column, -moved.ravel())
        begin += count
