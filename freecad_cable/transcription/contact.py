# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rows that keep places of a cable away from obstacles.

A feature of an obstacle (see ``problem.obstacles``) is a face, an edge or a corner, sharp or round; all are one quadric

    g(r) = n·(r − c) + α |r − c|²/2 − β (a·(r − c))²/2 − d ≥ 0

with n = 0 and α = β = 1/R about a line, α = 1/R and β = 0 about a point, d = R/2, R the distance to keep from it; and
α = β = 0, d = R from a face. g is zero at the distance to keep, and near it grows as the distance does.

In a hole of radius ρ the way from its axis is at most P = ρ − √(R² − z²), z the way beyond its rim. With P linear about
the node's z, (P² − |r − c|²)/2P is the same quadric: n = P' a, α = −1/P, β = −(1 + P'²)/P, d = −P/2, all times
1/√(1 + P'²).
"""

import casadi as ca
import numpy as np

from ..geometry.nearest import FLAT, HOLE, LINE

PARAMETERS = 12
"""c (3), n (3), a (3), α, β, d of one feature"""
LINK_PARAMETERS = PARAMETERS + 1
"""See ``link_gap``."""

PAST_RIM = 0.99
"""Way beyond the rim of a hole, in distances to keep, from which it is not in the way."""

BENT = 4.0
"""Largest P'', in inverse distances to keep: farther out P bends more with every step, and a parabola that bends as
much would be wider than the hole before it."""

NONE = np.array([0.0] * 11 + [-1.0])
"""Of a feature that is never in the way."""


def gap(r, feature):
    """g of a place from the column of a feature's parameters."""
    offset = r - feature[:3]
    about = ca.dot(feature[6:9], offset)
    round_part = feature[9] * ca.dot(offset, offset) - feature[10] * about**2
    return ca.dot(feature[3:6], offset) + round_part / 2 - feature[11]


def steepest(r, feature):
    """Gradient of g at a place from the column of a feature's parameters."""
    offset = r - feature[:3]
    about = ca.dot(feature[6:9], offset)
    return feature[3:6] + feature[9] * offset - feature[10] * about * feature[6:9]


def link_gap(nodes, link):
    """g between a node of a rod and a point of one of its elements: columns of the node's place and of those of the
    element's ends (9), and of the parameters of a feature, whose c is measured from where the last of all, a share of
    the element, is on its chord."""
    on_chord = (1 - link[PARAMETERS]) * nodes[3:6] + link[PARAMETERS] * nodes[6:]
    return gap(nodes[:3] - on_chord, link[:PARAMETERS])


def parameters(nearest, keep) -> np.ndarray:
    """(m, 12) of the features nearest to m points, ``keep`` [their unit] the distance to keep from the obstacle."""
    flat, line = nearest.feature == FLAT, nearest.feature == LINE
    distance = keep + nearest.radius
    inverse = np.where(flat, 0.0, 1 / distance)
    rows = np.column_stack(
        [
            nearest.center,
            np.where(flat[:, None], nearest.direction, 0.0),
            np.where(line[:, None], nearest.direction, 0.0),
            inverse,
            np.where(line, inverse, 0.0),
            np.where(flat, keep, distance / 2),
        ]
    )
    holes = nearest.feature == HOLE
    if holes.any():
        rows[holes] = _in_hole(nearest.taken(holes), keep)
    return rows


def _in_hole(nearest, keep):
    direction = nearest.direction
    beyond = nearest.distance * np.einsum("ki,ki->k", nearest.normal, direction)
    past = beyond >= PAST_RIM * keep
    aside = np.sqrt(keep**2 - np.where(past, 0.0, beyond) ** 2)
    scale, inverse = aside / keep, 1 / (nearest.radius - aside)
    bent = np.where(beyond == 0, 0.0, np.minimum(keep**2 / aside**3, BENT / keep))
    rows = np.column_stack(
        [
            nearest.center,
            (beyond / keep)[:, None] * direction,
            direction,
            -scale * inverse,
            -inverse / scale - bent * scale,
            -scale / inverse / 2,
        ]
    )
    rows[past] = NONE
    return rows


def value(r, features) -> np.ndarray:
    """(m,) g at points (m, 3)."""
    offset = r - features[:, :3]
    about = np.einsum("ki,ki->k", features[:, 6:9], offset)
    round_part = features[:, 9] * (offset**2).sum(axis=1) - features[:, 10] * about**2
    return np.einsum("ki,ki->k", features[:, 3:6], offset) + round_part / 2 - features[:, 11]


def slope(r, features) -> np.ndarray:
    """(m, 3) gradients of g at points (m, 3)."""
    c, n, a = features[:, :3], features[:, 3:6], features[:, 6:9]
    offset = r - c
    about = np.einsum("ki,ki->k", a, offset)[:, None]
    return n + features[:, 9:10] * offset - features[:, 10:11] * about * a


def bent(direction, features) -> np.ndarray:
    """(m, 3) how that gradient changes along directions (m, 3)."""
    about = np.einsum("ki,ki->k", features[:, 6:9], direction)[:, None]
    return features[:, 9:10] * direction - features[:, 10:11] * about * features[:, 6:9]
