# SPDX-License-Identifier: LGPL-2.1-or-later
"""The solved nodes as this room takes them."""

from dataclasses import dataclass

import numpy as np

from ..errors import DocumentError
from .units import from_si

COINCIDENT = 1e-7
"""Nodes nearer to each other than this share of the length are one: rounding rules between them."""

SHORTEST = 1e-3
"""[mm] Shortest cable that gets a shape: OCCT takes points within 10⁻⁷ mm as one."""


@dataclass(frozen=True, eq=False)
class Nodes:
    """Nodes of a solved rod. A ``Solution`` has the same fields and serves as well."""

    arc_length: np.ndarray
    """(n,) unstretched arc length, increasing [m]"""
    position: np.ndarray
    """(n, 3) [m]"""
    quaternion: np.ndarray
    """(n, 4) scalar first; R(q) e_i = d_i, d3 the tangent"""
    curvature: np.ndarray | None = None
    """(n, 3) κ1, κ2 and twist, material frame [1/m]; None: from the turn between the nodes"""
    support_nodes: tuple = ()
    """where curvature may jump; given is that just before the node"""


def in_millimetres(nodes):
    """Arc length (n,), position (n, 3), unit quaternion (n, 4), curvature (n, 3) or None, and the inner nodes where
    curvature may jump, checked.

    Of nodes that coincide one is left. Errors: ``DocumentError`` if the nodes are missing, malformed or
    out of order.
    """
    if nodes.arc_length is None or nodes.position is None or nodes.quaternion is None:
        raise DocumentError("There is no solved shape to draw. Solve the cable first.")
    n = np.size(nodes.arc_length)
    if n < 2:
        raise DocumentError(f"The cable has {n} node(s); a shape needs at least 2.")
    s = from_si("length", _array("arc lengths", nodes.arc_length, (n,)))
    position = from_si("length", _array("positions", nodes.position, (n, 3)))
    quaternion = _array("quaternions", nodes.quaternion, (n, 4))
    norm = np.linalg.norm(quaternion, axis=1)
    if abs(norm - 1).max() > 1e-3:
        k = int(np.argmax(abs(norm - 1)))
        raise DocumentError(
            f"The quaternion of node {k} has the length {norm[k]:.4g}; it must be 1."
        )
    length = s[-1] - s[0]
    if not length >= SHORTEST:
        raise DocumentError(
            f"The cable is {length:.3g} mm long; a shape needs at least {SHORTEST:g} mm."
        )
    if np.diff(s).min() < 0:
        k = int(np.argmin(np.diff(s)))
        raise DocumentError(f"The arc length of node {k + 1} is less than that of node {k}.")
    keep = _distinct(s, COINCIDENT * length)
    curvature = nodes.curvature
    if curvature is not None:
        curvature = from_si("curvature", _array("curvatures", curvature, (n, 3)))[keep]
    near = {int(np.argmin(np.abs(s[keep] - s[node]))) for node in nodes.support_nodes}
    jumps = sorted(near - {0, len(keep) - 1})
    return s[keep], position[keep], (quaternion / norm[:, None])[keep], curvature, jumps


def _array(name, value, shape):
    array = np.asarray(value, float)
    if array.shape != shape:
        raise DocumentError(
            f"The {name} of the nodes have the shape {array.shape}; it must be {shape}."
        )
    bad = ~np.isfinite(array.reshape(shape[0], -1)).all(axis=1)
    if bad.any():
        raise DocumentError(f"The {name} of node {int(np.argmax(bad))} are not finite numbers.")
    return array


def _distinct(s, distance):
    """Indices of nodes farther apart than ``distance``; both ends are among them."""
    keep = [0]
    for k in range(1, len(s) - 1):
        if s[k] - s[keep[-1]] > distance and s[-1] - s[k] > distance:
            keep.append(k)
    return [*keep, len(s) - 1]
