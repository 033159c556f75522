# SPDX-License-Identifier: LGPL-2.1-or-later
"""Balance of force and moment in strong form, from the nodes alone.

Nothing is shared with the way a solution was found: frames are interpolated by quintic splines, their
curvature gives the moment by the constitutive law, and the equations of equilibrium

    n(s) = n₀ − w s,    m(s) + (r(s) − r₀) × n(s) + ∫₀ˢ (r − r₀) × w ds = m₀

must hold for some n₀ and m₀ (two integrals of n' = −w and m' = −r' × n; Antman, *Nonlinear Problems of
Elasticity*, 2005, ch. 8). The best n₀ and m₀ are found by least squares; what remains is the residual.
"""

from dataclasses import dataclass

import numpy as np
from scipy.interpolate import make_interp_spline

from ..geometry import rotation


@dataclass(frozen=True)
class Balance:
    """Moments out of balance, as the curvature or twist that they would cause, relative to the largest in the rod
    (or to w L²/EI/1000 or 10⁻⁶/L, whichever is the largest: a rod without load has none to compare with)."""

    moment: float
    """largest residual of the moment balance with the best n₀ and m₀"""
    force: float
    """largest effect on a section of the difference between the best n₀ and the reported one"""


@dataclass(frozen=True)
class Pushes:
    """What acts on a rod from outside: arc lengths (m,) [m], positions (m, 3) [m], forces (m, 3) [N]."""

    arc_length: np.ndarray
    position: np.ndarray
    force: np.ndarray


def balance(rod, weight, arc_length, position, quaternion, force, pushes=None) -> Balance | None:
    """Residuals of a rod's nodes: arc_length (n+1,), position (n+1, 3), quaternion (n+1, 4), force (n+1, 3);
    weight (3,) [N/m]; ``pushes`` act on it between its ends; all SI. None with fewer than three nodes."""
    if len(arc_length) < 3:
        return None
    degree = min(5, (len(arc_length) - 1) | 1)
    degree = degree if degree < len(arc_length) else degree - 2
    nodes = make_interp_spline(arc_length, np.hstack([quaternion, position]), k=degree)
    # Between the nodes as well: a shape that is right at the nodes only is not in balance.
    s = np.sort(np.concatenate([arc_length, (arc_length[1:] + arc_length[:-1]) / 2]))
    found = nodes(s)
    q, places = found[:, :4], found[:, 4:]
    norm = np.linalg.norm(q, axis=1)[:, None]
    kappa = 2 * rotation.multiply(rotation.conjugate(q / norm), nodes(s, 1)[:, :4] / norm)[:, 1:]
    strain = kappa - rod.natural_curvature
    gone, lever = (s - s[0])[:, None], places - position[0]
    hanging = nodes.antiderivative()(s)[:, 4:]
    hanging = hanging - hanging[0] - gone * position[0]
    # m + lever × (n₀ − w s) + hanging × w = m₀, linear in n₀ and m₀.
    # Read as the strain that it would cause, so that a direction in which the rod is stiff, where the least
    # error of a frame is a large moment, does not drown the others.
    known = rotation.cross(hanging - gone * lever, weight)
    if pushes is not None and len(pushes.arc_length):
        # Every one passed adds (r − its place) × its force to the moment.
        order = np.argsort(pushes.arc_length)
        passed = np.searchsorted(pushes.arc_length[order], s, "right")
        forces = pushes.force[order]
        turns = rotation.cross(pushes.position[order], forces)
        sums, turning = (
            np.vstack([np.zeros(3), np.cumsum(each, axis=0)])[passed] for each in (forces, turns)
        )
        known = known - rotation.cross(places, sums) + turning
    soften = np.swapaxes(rotation.matrix(q / norm), 1, 2) / rod.stiffness[:, None]
    matrix = np.concatenate([soften @ rotation.cross_matrix(lever), -soften], axis=2)
    known = strain + np.einsum("kij,kj->ki", soften, known)
    unknown = np.linalg.lstsq(matrix.reshape(-1, 6), -known.ravel(), rcond=1e-12)[0]
    residual = np.linalg.norm(matrix @ unknown + known, axis=1)
    length = arc_length[-1] - arc_length[0]
    load = float(np.linalg.norm(weight)) * length**2 / rod.bending_stiffness.max()
    scale = max(np.linalg.norm(strain, axis=1).max(), 1e-3 * load, 1e-6 / length)
    unbalanced = matrix[:, :, :3] @ (unknown[:3] - force[0])
    return Balance(
        moment=float(residual.max() / scale),
        force=float(np.linalg.norm(unbalanced, axis=1).max() / scale),
    )
