# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the ends of a rod hold, as conditions on the state y = (r, q, n, m) with Jacobians (rows, 13)."""

import numpy as np

from ..geometry.guess import perpendicular
from ..problem import Pinned
from .collocation import NoSolutionError
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


def symmetries(scene, loads) -> int:
    """How many independent motions of the whole rod change nothing about its problem.

    A rod that bends alike in all directions may spin about itself if no end is clamped. Any rod may
    turn about a line if the ends lie on it and are held along it, and weight and ``loads`` (k, 3)
    act along it; a clamped one must spin back, so it has to bend alike. Two pins in one point
    without weight leave all turns free.
    """
    ends = [end for end in (scene.start, scene.end) if isinstance(end, Pinned)]
    held = [end.tangent for end in ends if end.kind == "swivel"]
    held += [rotation(end.quaternion)[:, 2] for end in ends if end.kind == "clamped"]
    clamped = any(end.kind == "clamped" for end in ends)
    spin = int(scene.rod.isotropic and not clamped)
    chord = ends[-1].position - ends[0].position
    directions = [v for v in (chord, *held, scene.weight, *loads) if v.any()]
    if not directions:
        return spin + 3
    axis = directions[0] / np.linalg.norm(directions[0])
    off = max(np.linalg.norm(np.cross(axis, v)) / np.linalg.norm(v) for v in directions)
    return spin + int(off < 1e-9 and (scene.rod.isotropic or not clamped))


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
    # opposite, where the sine would vanish too.
    first = perpendicular(end.tangent)
    across = np.stack((first, np.cross(end.tangent, first)))

    def turn(y):
        d3, d3_q = rotation(y[Q])[:, 2], rotated_by_q(y[Q], D3)
        aside, ahead = across @ d3, 1 + end.tangent @ d3
        if ahead < 1e-6:
            raise NoSolutionError(f"the {end.place} points against the tangent it is held at")
        rows = np.zeros((3, SIZE))
        rows[:2, Q] = across @ d3_q / ahead - np.outer(aside, end.tangent @ d3_q) / ahead**2
        rows[2, M] = end.tangent
        return np.append(aside / ahead, end.tangent @ y[M]), rows

    return _both(_linear(R, end.position), turn)


def _pinned(end, force, moment):
    return _both(_linear(R, end.position), _linear(M, np.zeros(3)))


def _free(end, force, moment):
    return _both(_linear(N, force), _linear(M, moment))
