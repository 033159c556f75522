# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rows for the two ends.

The target orientation is the parameter quaternion; a swivel uses only its third axis. Orientation rows are
written in the target's frame, p = q*⁻¹ ∘ q, with as many rows as there are conditions: 3 for a frame
(the vector part of p), 2 for a tangent. So q and −q are both allowed at the far end; the start of the
iteration decides which class of turns is found.
"""

import casadi as ca

from .element import conjugate, multiply


def relative(target, q):
    """Rotation from the target frame to q."""
    return multiply(conjugate(target), q)


def tangent_rows(target, q):
    """q differs from the target by a turn about d3. (That d3 has no component along the target's d1 and d2 would
    allow the opposite direction too.)"""
    return relative(target, q)[1:3]


def start_rows(structure, r, q, parameters):
    """Rows at the first node. Where the frame is not clamped, the quaternion's norm is set here, once:
    the steps keep it. Without torsion, and with no clamp at either end, the roll of the frames has no meaning
    and is pinned to the reference's, or the energy would not change along it."""
    target = parameters["start_quaternion"]
    rows = [] if structure.start == "free" else [r - parameters["start_position"]]
    if structure.start == "clamped":
        return ca.vertcat(*rows, q - target)
    rows.append(ca.dot(q, q) - 1)
    if structure.start == "swivel":
        rows.append(tangent_rows(target, q))
    if structure.rolls:
        rows.append(relative(target, q)[3])
    return ca.vertcat(*rows)


def end_rows(structure, r, q, parameters):
    """Rows at the last node."""
    target = parameters["end_quaternion"]
    rows = [] if structure.end == "free" else [r - parameters["end_position"]]
    if structure.end == "clamped":
        rows.append(relative(target, q)[1:])
    if structure.end == "swivel":
        rows.append(tangent_rows(target, q))
    return ca.vertcat(*rows) if rows else ca.SX(0, 1)
