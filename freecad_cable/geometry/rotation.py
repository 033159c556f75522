# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rotations as unit quaternions (Euler parameters), scalar first, vectorised over leading axes.

R(q) e_i = d_i: the columns of the rotation matrix are the axes of the rotated frame. ``multiply(a, b)``
turns by b in the frame of a. Formulas: Shoemake, "Animating rotation with quaternion curves", 1985;
exponential series where a closed form divides by zero.
"""

import numpy as np

# Of the units 1, i, j, k, each with each; the vector part of that of i, j, k is their cross product.
_PRODUCT = np.array(
    [
        [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]],
        [[0, 1, 0, 0], [-1, 0, 0, 0], [0, 0, 0, 1], [0, 0, -1, 0]],
        [[0, 0, 1, 0], [0, 0, 0, -1], [-1, 0, 0, 0], [0, 1, 0, 0]],
        [[0, 0, 0, 1], [0, 0, 1, 0], [0, -1, 0, 0], [-1, 0, 0, 0]],
    ],
    float,
)
OPPOSITE = 1e-8
"""Norm of (1 + a·b, a × b), twice the cosine of half their angle, below which two unit vectors are opposite but for
rounding, and their cross product tells no axis."""
_CROSS = _PRODUCT[1:, 1:, 1:]
_CROSS_MATRIX = np.swapaxes(_CROSS, 1, 2)
# R = 1 + 2 w [v ×] + 2 [v ×]² of q = (w, v), after Rodrigues.
_TURN = np.zeros((4, 4, 3, 3))
_TURN[0, 1:] = 2 * _CROSS_MATRIX
_TURN[1:, 1:] = 2 * _CROSS_MATRIX[:, None] @ _CROSS_MATRIX


def _bilinear(a, b, table):
    """What is linear in a (..., i) and in b (..., j), of the table (i, j, ...) of its values at units. One matrix
    product, because on the few nodes of a rod the number of steps is what takes time."""
    a, b = np.asarray(a, float), np.asarray(b, float)
    products = a[..., :, None] * b[..., None, :]
    rows = products.reshape(*products.shape[:-2], a.shape[-1] * b.shape[-1])
    values = rows @ table.reshape(rows.shape[-1], -1)
    return values.reshape(*values.shape[:-1], *table.shape[2:])


def cross(a, b):
    """Cross product of vectors (..., 3)."""
    return _bilinear(a, b, _CROSS)


def cross_matrix(v):
    """Matrices (n, 3, 3) of the cross products v × of vectors (n, 3)."""
    return np.tensordot(v, _CROSS_MATRIX, 1)


def multiply(a, b):
    """Quaternion product a ∘ b, (..., 4)."""
    return _bilinear(a, b, _PRODUCT)


def conjugate(q):
    """Inverse of a unit quaternion, (..., 4)."""
    return np.asarray(q, float) * (1.0, -1.0, -1.0, -1.0)


def backwards(q):
    """Frames (..., 4) after half a turn about their d1: d3 the other way."""
    return multiply(q, (0.0, 1.0, 0.0, 0.0))


def matrix(q):
    """Rotation matrices (..., 3, 3) of unit quaternions (..., 4)."""
    return np.eye(3) + _bilinear(q, q, _TURN)


def rotate(q, v):
    """Vectors v (..., 3) of the rotated frame, in the outer frame."""
    return np.einsum("...ij,...j->...i", matrix(q), np.asarray(v, float))


def tangent(q):
    """Third axes d3 of the frames, (..., 3)."""
    return matrix(q)[..., :, 2]


def exponential(theta):
    """Unit quaternions (..., 4) of rotation vectors (..., 3) [rad]."""
    theta = np.asarray(theta, float)
    half = np.linalg.norm(theta, axis=-1, keepdims=True) / 2
    return np.concatenate([np.cos(half), np.sinc(half / np.pi) * theta / 2], axis=-1)


def logarithm(q):
    """Rotation vectors (..., 3) [rad], of at most half a turn, of unit quaternions (..., 4)."""
    q = np.asarray(q, float)
    q = np.where(q[..., :1] < 0, -q, q)
    sine = np.linalg.norm(q[..., 1:], axis=-1, keepdims=True)
    half = np.arctan2(sine, q[..., :1])
    return q[..., 1:] * 2 / np.sinc(half / np.pi)


def between(a, b, share):
    """Frames (..., 4) a ``share`` (...) of the least turn from the frames a to the frames b (..., 4)."""
    turn = logarithm(multiply(conjugate(a), b))
    return multiply(a, exponential(np.asarray(share)[..., None] * turn))


def from_tangent(t):
    """A quaternion (4,) whose d3 is the unit vector t (3,); its roll is arbitrary but deterministic."""
    return shortest_arc((0.0, 0.0, 1.0), t)


def shortest_arc(a, b):
    """The least rotation (4,) that turns unit vector a into unit vector b; any axis if they are opposite."""
    a, b = np.asarray(a, float), np.asarray(b, float)
    if a @ b > -0.9:
        q = np.append(1 + a @ b, cross(a, b))
        return q / np.linalg.norm(q)
    # All but opposite, where the axis drowns in rounding: half a turn about what is left of it, and a small rest.
    axis = cross(a, b)
    if np.linalg.norm(axis) < 1e-8:
        axis = cross(a, np.eye(3)[np.argmin(np.abs(a))])
    half_turn = np.append(0.0, axis / np.linalg.norm(axis))
    return multiply(shortest_arc(-a, b), half_turn)


def transport(q0, tangents):
    """Carry the frame q0 (4,) along unit tangents (m, 3) without twist → (m, 4), sign-continuous.

    Step-wise least rotations, which is parallel transport to second order in the step.
    """
    a, b = tangents[:-1], tangents[1:]
    turns = np.concatenate([1 + np.sum(a * b, axis=1)[:, None], cross(a, b)], axis=1)
    size = np.linalg.norm(turns, axis=1)[:, None]
    turns /= np.maximum(size, 1e-300)
    for k in np.flatnonzero(size < OPPOSITE):
        turns[k] = shortest_arc(a[k], b[k])
    first = multiply(shortest_arc(tangent(q0), tangents[0]), q0)
    return continuous(np.vstack([first, multiply(_running_product(turns), first)]))


def _running_product(q):
    """(m, 4) products q_k ∘ … ∘ q_0 of unit quaternions (m, 4), in log₂ m steps (Hillis, Steele 1986): each takes what
    ends at it times what ends just before that."""
    q, reach = np.array(q), 1
    while reach < len(q):
        q[reach:] = multiply(q[reach:], q[:-reach])
        reach *= 2
    return q


def continuous(q):
    """The same frames (m, 4), signs chosen so that neighbours are near each other."""
    q = np.array(q, float)
    flips = np.sum(q[1:] * q[:-1], axis=-1) < 0
    q[1:][np.cumsum(flips) % 2 == 1] *= -1
    return q
