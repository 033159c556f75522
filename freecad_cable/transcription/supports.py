# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rows for the sections that supports hold: equations, and what must not be negative."""

import casadi as ca

from .element import rotate
from .ends import relative, tangent_rows

PARAMETERS = {"position": 3, "quaternion": 4, "play": 1, "arc_length": 1}
"""Sizes of the parameters of one support, without units. d3 of the quaternion is the direction or the axis."""

TIGHT = 1e-6
"""Play of a ring, relative to the length of the cable, below which it has none."""


def equations(kind, r, q, parameters):
    """What a support sets to zero."""
    offset = r - parameters["position"]
    if kind == "ring":
        axis = rotate(parameters["quaternion"], ca.SX([0, 0, 1]))
        return ca.dot(axis, offset)
    if kind == "eyelet":
        return offset
    if kind == "clamp":
        return ca.vertcat(offset, relative(parameters["quaternion"], q)[1:])
    return ca.vertcat(offset, tangent_rows(parameters["quaternion"], q))


def play_left(kind, r, parameters):
    """What a support keeps from being negative: of a ring, about the distance that is left to its rim."""
    if kind != "ring":
        return ca.SX(0, 1)
    offset, play = r - parameters["position"], parameters["play"]
    return (play - ca.dot(offset, offset) / play) / 2
