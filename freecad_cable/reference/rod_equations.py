# SPDX-License-Identifier: LGPL-2.1-or-later
"""The equations of a static rod in strong form and what its ends hold, with Jacobians.

State y = (r, q, n, m): position, quaternion, force and moment that the part beyond s exerts on the
part before, world frame. Antman, Nonlinear Problems of Elasticity, 2nd ed. (2005), chapter 8; Simo,
Comput. Methods Appl. Mech. Eng. 49 (1985) 55–70:

    r' = R(e3 + C Rᵀn),  q' = ½ q ∘ (0, κ),  κ = κ0 + K⁻¹ Rᵀm,  n' = −w,  m' = −r' × n

with C the compliances of shear and stretch (zeros: unshearable, inextensible) and K = diag(EI1,
EI2, GJ).
"""

from dataclasses import dataclass

import numpy as np

R, Q, N, M = slice(0, 3), slice(3, 7), slice(7, 10), slice(10, 13)
SIZE = 13


def cross(a):
    """The matrices (..., 3, 3) with cross(a) b = a × b."""
    x, y, z = np.moveaxis(a, -1, 0)
    zero = np.zeros_like(x)
    return np.stack((zero, -z, y, z, zero, -x, -y, x, zero), axis=-1).reshape(*x.shape, 3, 3)


def rotation(q):
    """R(q) (..., 3, 3), a quadratic form in q: orthonormal for unit quaternions only."""
    w, v = q[..., :1, None], q[..., 1:]
    outer = v[..., :, None] * v[..., None, :]
    return (w**2 - (v**2).sum(-1)[..., None, None]) * np.eye(3) + 2 * outer + 2 * w * cross(v)


def rotated_by_q(q, x, sign=1):
    """∂(R x)/∂q (..., 3, 4), or with sign −1 ∂(Rᵀx)/∂q."""
    w, v = q[..., :1], q[..., 1:]
    scalar = 2 * (w * x + sign * np.cross(v, x))
    vector = 2 * (
        (v * x).sum(-1)[..., None, None] * np.eye(3)
        + v[..., :, None] * x[..., None, :]
        - x[..., :, None] * v[..., None, :]
        - sign * w[..., None] * cross(x)
    )
    return np.concatenate((scalar[..., None], vector), axis=-1)


@dataclass(frozen=True, eq=False)
class RodEquations:
    """The right-hand side of a uniform rod."""

    stiffness: np.ndarray
    """(3,) EI1, EI2, GJ"""
    compliance: np.ndarray
    """(3,) 1/GA, 1/GA, 1/EA"""
    natural_curvature: np.ndarray
    """(3,)"""
    weight: np.ndarray
    """(3,) per unstretched length"""

    def strains(self, y):
        """Curvature κ and stretch C Rᵀn (..., 3) in the material frame."""
        transposed = rotation(y[..., Q]).swapaxes(-1, -2)
        moment = (transposed @ y[..., M, None])[..., 0]
        force = (transposed @ y[..., N, None])[..., 0]
        return self.natural_curvature + moment / self.stiffness, self.compliance * force

    def rate(self, y):
        """y' (..., 13) and its Jacobian (..., 13, 13)."""
        q, n, m = y[..., Q], y[..., N], y[..., M]
        turn = rotation(q)
        transposed = turn.swapaxes(-1, -2)
        curvature, stretch = self.strains(y)
        inside = stretch + (0.0, 0.0, 1.0)
        slope = (turn @ inside[..., None])[..., 0]
        w, v = q[..., :1], q[..., 1:]
        # q ∘ (0, κ) = spin κ
        spin = np.concatenate((-v[..., None, :], w[..., None] * np.eye(3) + cross(v)), axis=-2) / 2

        value = np.zeros_like(y)
        value[..., R] = slope
        value[..., Q] = (spin @ curvature[..., None])[..., 0]
        value[..., N] = -self.weight
        value[..., M] = np.cross(n, slope)

        flexibility = 1 / self.stiffness[:, None]
        compliance = self.compliance[:, None]
        by_q = rotated_by_q(q, inside) + turn @ (compliance * rotated_by_q(q, n, -1))
        by_n = turn @ (compliance * transposed)
        jacobian = np.zeros((*y.shape, SIZE))
        jacobian[..., R, Q] = by_q
        jacobian[..., R, N] = by_n
        jacobian[..., Q, Q] = spin @ (flexibility * rotated_by_q(q, m, -1))
        jacobian[..., 3, 4:7] -= curvature / 2
        jacobian[..., 4:7, 3] += curvature / 2
        jacobian[..., 4:7, 4:7] -= cross(curvature) / 2
        jacobian[..., Q, M] = spin @ (flexibility * transposed)
        jacobian[..., M, Q] = cross(n) @ by_q
        jacobian[..., M, N] = cross(n) @ by_n - cross(slope)
        return value, jacobian
