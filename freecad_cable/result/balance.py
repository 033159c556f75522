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
    """Both relative to the largest moment (or to w L²/1000 or EI/L/10⁶, whichever is the
    largest: a rod without load has none to compare with)."""

    moment: float
    """largest residual of the moment balance with the best n₀ and m₀"""
    force: float
    """largest moment that the difference between the best n₀ and the reported one exerts on a section"""


def balance(rod, weight, arc_length, position, quaternion, force) -> Balance | None:
    """Residuals of a rod's nodes: arc_length (n+1,), position (n+1, 3), quaternion (n+1, 4), force (n+1, 3);
    weight (3,) [N/m]; all SI. None with fewer than three nodes."""
    if len(arc_length) < 3:
        return None
    degree = min(5, (len(arc_length) - 1) | 1)
    degree = degree if degree < len(arc_length) else degree - 2
    frames = make_interp_spline(arc_length, quaternion, k=degree)
    places = make_interp_spline(arc_length, position, k=degree)
    # Between the nodes as well: a shape that is right at the nodes only is not in balance.
    s = np.sort(np.concatenate([arc_length, (arc_length[1:] + arc_length[:-1]) / 2]))
    q = frames(s)
    norm = np.linalg.norm(q, axis=1)[:, None]
    kappa = 2 * rotation.multiply(rotation.conjugate(q / norm), frames(s, 1) / norm)[:, 1:]
    strain = kappa - rod.natural_curvature
    moment = np.einsum("kij,kj->ki", rotation.matrix(q / norm), rod.stiffness * strain)
    lever = places(s) - position[0]
    hanging = places.antiderivative()(s) - np.outer(s, position[0])
    hanging -= hanging[0]
    weighed = rotation.cross(hanging, weight)
    # m + lever × (n₀ − w s) + weighed = m₀, linear in n₀ and m₀.
    known = moment - rotation.cross(lever, np.outer(s - s[0], weight)) + weighed
    matrix = np.concatenate([_hat(lever), -np.tile(np.eye(3), (len(s), 1, 1))], axis=2)
    unknown = np.linalg.lstsq(matrix.reshape(-1, 6), -known.ravel(), rcond=1e-12)[0]
    residual = np.linalg.norm((matrix @ unknown) + known, axis=1)
    length = arc_length[-1] - arc_length[0]
    load = float(np.linalg.norm(weight)) * length
    scale = max(
        np.linalg.norm(moment, axis=1).max(),
        load * length * 1e-3,
        1e-6 * rod.bending_stiffness.max() / length,
    )
    unbalanced = np.linalg.norm(rotation.cross(lever, unknown[:3] - force[0]), axis=1)
    return Balance(moment=float(residual.max() / scale), force=float(unbalanced.max() / scale))


def _hat(v):
    x, y, z = v.T
    o = np.zeros_like(x)
    return np.moveaxis(np.array([[o, -z, y], [z, o, -x], [-y, x, o]]), -1, 0)
