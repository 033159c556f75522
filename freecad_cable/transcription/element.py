# SPDX-License-Identifier: LGPL-2.1-or-later
"""One element of a rod: a step along a screw, exact on SE(3).

A screw (θ, ρ) turns the frame by exp(θ) and moves it by V(θ) ρ; a rod of constant strain is a screw with
θ = h κ and ρ = h v, and its mean position (for the work of gravity) is W(θ) ρ, both in closed form:

    V(θ) = ∫₀¹ exp(t θ^) dt        = 1 + B θ^ + C θ^θ^
    W(θ) = ∫₀¹ (1 − t) exp(t θ^) dt = ½ + C θ^ + D θ^θ^

    A = sin x / x,  B = (1 − cos x)/x²,  C = (x − sin x)/x³,  D = (x²/2 − 1 + cos x)/x⁴,  x = |θ|

The coefficients are written as power series of x², which have no singular point at x = 0 and need no
branch; with TERMS terms they are exact to 1e-12 up to a turn of 1 rad in one element, and no accurate
mesh turns that far. Source: Iserles et al., "Lie-group methods", Acta Numerica 9 (2000), app. B.
"""

from math import factorial

import casadi as ca

TERMS = 6


def series(t, first):
    """Σ (−t)^i / (2i + first)!"""
    total = 0
    for i in reversed(range(TERMS)):
        total = (-1) ** i / factorial(2 * i + first) + t * total
    return total


def upper(matrix):
    """Upper triangle of a symmetric matrix, row by row, as a dense column."""
    size = matrix.shape[0]
    return ca.densify(ca.vertcat(*(matrix[i, i:].T for i in range(size))))


def conjugate(q):
    """Inverse of a unit quaternion."""
    return ca.vertcat(q[0], -q[1:])


def multiply(a, b):
    """Quaternion product a ∘ b."""
    return ca.vertcat(
        a[0] * b[0] - ca.dot(a[1:], b[1:]), a[0] * b[1:] + b[0] * a[1:] + ca.cross(a[1:], b[1:])
    )


def rotate(q, v):
    """R(q) v for a unit quaternion."""
    twice = 2 * ca.cross(q[1:], v)
    return v + q[0] * twice + ca.cross(q[1:], twice)


def body(theta, rho, bow, square):
    """The screw seen from its first frame: (displacement, turn, mean displacement over the element).

    ``bow`` is the mean distance of the true path from the screw, in the frame at the middle; ``square`` is
    |θ|², by itself so that a derivative can treat it as one more variable."""
    first = ca.cross(theta, rho)
    second = ca.cross(theta, first)
    b, c, d = series(square, 2), series(square, 3), series(square, 4)
    displacement = rho + b * first + c * second
    turn = ca.vertcat(series(square / 4, 0), series(square / 4, 1) * theta / 2)
    mean = rho / 2 + c * first + d * second + bow + ca.cross(theta, bow) / 2
    return displacement, turn, mean


def step(q, theta, rho, bow):
    """From a node's frame along the screw: (displacement, next frame, mean displacement over the element)."""
    displacement, turn, mean = body(theta, rho, bow, ca.dot(theta, theta))
    return rotate(q, displacement), multiply(q, turn), rotate(q, mean)
