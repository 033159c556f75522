# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the ends of a rod hold, as conditions on the state y = (r, q, n, m) with Jacobians (rows, 13)."""

import numpy as np

from ..geometry.guess import perpendicular
from .rod_equations import SIZE, M, N, Q, R, rotated_by_q, rotation

D3 = np.array([0.0, 0.0, 1.0])


def conditions(end, force, moment):
    """The six conditions of an end, as a function of y (13,).

    A clamp holds r and q up to sign; a swivel r and d3, and no torque; a pin r, and no moment; a
    free end has the dead loads ``force`` and ``moment`` (3,).
    """
    return {"clamped": _clamped, "swivel": _swivel, "pinned": _pinned, "free": _free}[end.kind](
        end, force, moment
    )


def with_unit_quaternion(conditions):
    """The conditions, and |q|² = 1, which the equations then keep along the rod."""

    def seven(y):
        value, jacobian = conditions(y)
        row = np.zeros((1, SIZE))
        row[0, Q] = 2 * y[Q]
        return np.append(value, y[Q] @ y[Q] - 1), np.vstack((jacobian, row))

    return seven


def _linear(part, target):
    """y[part] = target"""
    rows = np.eye(SIZE)[part]
    return lambda y: (y[part] - target, rows)


def _both(first, second):
    def joined(y):
        (a, a_y), (b, b_y) = first(y), second(y)
        return np.concatenate((a, b)), np.vstack((a_y, b_y))

    return joined


def _clamped(end, force, moment):
    w, x, y, z = end.quaternion
    # The vector part of conj(target) ∘ q
    rows = np.zeros((3, SIZE))
    rows[:, Q] = [[-x, w, z, -y], [-y, -z, w, x], [-z, y, -x, w]]
    return _both(_linear(R, end.position), lambda state: (rows @ state, rows))


def _swivel(end, force, moment):
    # The tangent of half the angle between d3 and the tangent held: zero at it, infinite at its
    # opposite.
    first = perpendicular(end.tangent)
    across = np.stack((first, np.cross(end.tangent, first)))

    def turn(y):
        d3, d3_q = rotation(y[Q])[:, 2], rotated_by_q(y[Q], D3)
        aside, ahead = across @ d3, 1 + end.tangent @ d3
        rows = np.zeros((3, SIZE))
        rows[:2, Q] = across @ d3_q / ahead - np.outer(aside, end.tangent @ d3_q) / ahead**2
        rows[2, M] = end.tangent
        return np.append(aside / ahead, end.tangent @ y[M]), rows

    return _both(_linear(R, end.position), turn)


def _pinned(end, force, moment):
    return _both(_linear(R, end.position), _linear(M, np.zeros(3)))


def _free(end, force, moment):
    return _both(_linear(N, force), _linear(M, moment))
