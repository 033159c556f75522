# SPDX-License-Identifier: LGPL-2.1-or-later
"""The differential equations of a rod and their linearisation over one element, as CasADi functions.

    r' = R (e₃ + γ),  q' = ½ q ∘ κ,  n' = −w,  m' = −r' × n,  κ = κ⁰ + K⁻¹ Rᵀ m,  γ = C Rᵀ n

A state y (13,) is position, quaternion, force, moment; a change of it (12,) has a turn in the world's frame in place of
the quaternion's. A law (13,) is compliance of κ1, κ2, τ, γ1, γ2, ε (0: rigid), natural curvature, weight, and the
largest curvature.
"""

from functools import lru_cache

import casadi as ca
import numpy as np

from ..transcription.across import across
from ..transcription.numeric import Numeric

SUBSTEPS = 3
"""Runge–Kutta steps in an element: leaves 1/3⁴ of an order-4 element's own error unseen."""
HELD = 20
"""Newton steps for the moment that holds a rod at its largest curvature."""


class Law:
    """A law with numbers; states (n, 13) or arrays of their parts."""

    def __init__(self, compliance, natural, weight, limit=np.inf):
        self.bend, self.shear, self.natural = compliance[:3], compliance[3:], natural
        self._given = np.concatenate([compliance, natural, weight, [min(limit, 1e300)]])
        self._limited = bool(np.isfinite(limit))

    def curvature(self, moment):
        """(3,) curvature and twist from the moment in the material frame (3,)."""
        return _curvature(self._limited)(moment, self._given)[0]

    def rate(self, y):
        """(n, 13) derivatives y' of states (n, 13)."""
        (found,) = _rates(self._limited, len(y))(y, self._given[None])
        return found

    def elements(self, before, after, steps):
        """(P, Q) (n, 12, 12) and defects (n, 12) of elements between the states at their nodes: a change a at the first
        node arrives at the last as b, P b = Q a; the defect is what the last is more than where the equations lead."""
        evaluate = _elements(self._limited, len(steps))
        p, q, defects = evaluate(before, after, steps, self._given[None])
        return (p.reshape(-1, 12, 12), q.reshape(-1, 12, 12)), defects


class _Equations:
    """Of a law in symbols."""

    def __init__(self, limited):
        self.limited, self.given = limited, ca.SX.sym("law", 13)
        parts = ca.vertsplit(self.given, [0, 3, 6, 9, 12, 13])
        self.bend, self.shear, self.natural, self.weight, self.limit = parts

    def curvature(self, moment):
        """Curvature, and its change (3, 3) with the moment. Where the rod is held at the limit, κ minimises its energy
        less m·κ on |κ| = limit, and so (K + μ) κ = m + K κ⁰ with a multiplier μ."""
        kappa, change = self.natural + self.bend * moment, ca.diag(self.bend)
        if not self.limited:
            return kappa, change
        pull, mu = kappa[:2] / self.bend[:2], 0
        for _ in range(HELD):
            soft = 1 / (1 / self.bend[:2] + mu)
            bent = soft * pull
            size = ca.norm_2(bent)
            mu += (size / self.limit - 1) * size**2 / ca.dot(bent, soft * bent)
        across_it = soft * bent
        held = ca.SX(change)
        held[:2, :2] = ca.diag(soft) - across_it @ across_it.T / ca.dot(bent, across_it)
        over = ca.norm_2(kappa[:2]) > self.limit
        at_limit = ca.vertcat(bent, kappa[2])
        return ca.if_else(over, at_limit, kappa), ca.if_else(over, held, change)

    def rate(self, y):
        q, n, m = y[3:7], y[7:10], y[10:]
        frame = _matrix(q)
        kappa, _ = self.curvature(frame.T @ m)
        slope = frame @ self._stretched(frame, n)
        turning = ca.vertcat(-ca.dot(q[1:], kappa), q[0] * kappa + ca.cross(q[1:], kappa)) / 2
        return ca.vertcat(slope, turning, -self.weight, -ca.cross(slope, n))

    def _stretched(self, frame, n):
        return ca.vertcat(0, 0, 1) + self.shear * (frame.T @ n)

    def integrated(self, y, length):
        """Runge and Kutta's method of order 4."""
        h = length / SUBSTEPS
        for _ in range(SUBSTEPS):
            a = self.rate(y)
            b = self.rate(y + h / 2 * a)
            c = self.rate(y + h / 2 * b)
            d = self.rate(y + h * c)
            y = y + h / 6 * (a + 2 * b + 2 * c + d)
            y[3:7] /= ca.norm_2(y[3:7])
        return y

    def transfer(self, y, length):
        """P and Q about a state. The Padé form of the exponential keeps growing modes growing and decaying ones
        decaying, however long the element is against the bending layer; a Taylor form does not."""
        n, m = y[7:10], y[10:]
        frame = _matrix(y[3:7] / ca.norm_2(y[3:7]))
        bend = frame @ self.curvature(frame.T @ m)[1] @ frame.T
        shear = frame @ ca.diag(self.shear) @ frame.T
        slope = ca.skew(frame @ self._stretched(frame, n))
        rate = ca.SX(12, 12)
        rate[0:3, 3:6] = shear @ ca.skew(n) - slope
        rate[0:3, 6:9] = shear
        rate[3:6, 3:6] = bend @ ca.skew(m)
        rate[3:6, 9:12] = bend
        rate[9:12, 3:9] = ca.skew(n) @ rate[0:3, 3:9]
        rate[9:12, 6:9] -= slope
        odd = rate * length / 2
        even = ca.SX.eye(12) + odd @ odd / 3
        return even - odd, even + odd


def _matrix(q):
    """Rotation matrix of a unit quaternion."""
    v = ca.skew(q[1:])
    return ca.SX.eye(3) + 2 * q[0] * v + 2 * v @ v


def _turn(q, before):
    """Rotation vector of q ∘ before⁻¹, unit quaternions."""
    w = ca.dot(q, before)
    v = before[0] * q[1:] - q[0] * before[1:] - ca.cross(q[1:], before[1:])
    sine = ca.norm_2(v) + 1e-300
    return 2 * ca.atan2(ca.sign(w) * sine, ca.fabs(w)) / sine * v


@lru_cache
def _curvature(limited):
    law, moment = _Equations(limited), ca.SX.sym("m", 3)
    return Numeric(ca.Function("curvature", [moment, law.given], [law.curvature(moment)[0]]))


@lru_cache
def _element(limited):
    """(y before, y after, length, law) → P and Q, row by row, and the defect."""
    law = _Equations(limited)
    before, after, length = ca.SX.sym("a", 13), ca.SX.sym("b", 13), ca.SX.sym("h")
    p, q = law.transfer((before + after) / 2, length)
    reached = law.integrated(before, length)
    turn = _turn(after[3:7], reached[3:7])
    defect = ca.vertcat(after[:3] - reached[:3], turn, after[7:] - reached[7:])
    outputs = [ca.densify(ca.vec(p.T)), ca.densify(ca.vec(q.T)), defect]
    return ca.Function("element", [before, after, length, law.given], outputs)


@lru_cache(maxsize=64)
def _elements(limited, count):
    return _over(_element(limited), (count, 13), (count, 13), (count, 1), (1, 13))


@lru_cache(maxsize=64)
def _rates(limited, count):
    law, y = _Equations(limited), ca.SX.sym("y", 13)
    function = ca.Function("rate", [y, law.given], [law.rate(y)])
    return _over(function, (count, 13), (1, 13))


def _over(function, *shapes):
    symbols = [ca.MX.sym("v", *shape) for shape in shapes]
    return Numeric(ca.Function(function.name(), symbols, across(function, *symbols)))
