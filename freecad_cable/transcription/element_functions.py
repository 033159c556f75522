# SPDX-License-Identifier: LGPL-2.1-or-later
"""One element as functions: what it does, and what its derivatives are.

The functions are written once, symbolically, and evaluated across all elements of a rod. The Hessian follows the chain
rule through the screw by hand: half the operations of differentiating the whole.
"""

from functools import lru_cache
from types import SimpleNamespace

import casadi as ca

from . import helix, magnus
from .element import body, conjugate, multiply, rotate, step, upper

SCHEMES = {"helix": helix, "magnus": magnus}


@lru_cache(maxsize=64)
def element(scheme: str, kept: tuple[int, ...], slides: bool) -> SimpleNamespace:
    """Functions of one element with variables v: the quaternion of its node (4), the strains that the model keeps
    (m) at its first and, if the strain is continuous, at its last node; and if the cable slides the length of the
    stretch, of which h is then a share.

    ``motion`` (v, h, stiffness and natural strains and weight) → displacement (3), next quaternion (4). ``energy``
    (v, h, …) → elastic energies (m), mean position over the element from its node (3), length. ``slope`` (r − origin,
    v, h, …) → gradient of the energy over r and v. ``block`` (v, h, …, λ_f, λ of the pose gap) → upper triangle of the
    Hessian of the element's part of the Lagrangian over v. ``reach`` (v, h, …) → Jacobian of the pose that it reaches,
    over v, column by column (7 for each).
    """
    law = _Law(SCHEMES[scheme], kept, slides)
    block, reach = law.derivatives()
    return SimpleNamespace(
        motion=law.motion(), energy=law.energy(), slope=law.slope(), block=block, reach=reach
    )


class _Law:
    def __init__(self, scheme, kept, slides):
        size = len(kept)
        self.scheme, self.kept = scheme, list(kept)
        self.q, self.h = ca.SX.sym("q", 4), ca.SX.sym("h")
        self.stiffness, self.natural, self.weight = (
            ca.SX.sym(n, k) for n, k in (("k", 6), ("n", 3), ("w", 3))
        )
        self.first = ca.SX.sym("e0", size)
        self.last = ca.SX.sym("e1", size) if scheme.STRAIN_IS_STATE else self.first
        strains = [self.first, self.last] if scheme.STRAIN_IS_STATE else [self.first]
        self.step = self.h
        if slides:
            strains.append(ca.SX.sym("l"))
            self.step = self.h * strains[-1]
        self.strains = ca.vertcat(*strains)
        self.screw = scheme.screw(self.step, self._full(self.first), self._full(self.last))
        rest = ca.vertcat(self.natural, 0, 0, 0)[self.kept]
        self.elastic = scheme.elastic_energy(
            self.step, self.stiffness[self.kept], self.first - rest, self.last - rest
        )
        self.inputs = [
            ca.vertcat(self.q, self.strains),
            self.h,
            ca.vertcat(self.stiffness, self.natural, self.weight),
        ]

    def _full(self, strain):
        """(κ, v) from the strains that the model keeps."""
        e = ca.SX(ca.vertcat(self.natural, 0, 0, 0))
        for i, index in enumerate(self.kept):
            e[index] = strain[i]
        return e[:3], ca.vertcat(e[3], e[4], 1 + e[5])

    def motion(self):
        return ca.Function("motion", self.inputs, list(step(self.q, *self.screw)[:2]))

    def energy(self):
        mean = step(self.q, *self.screw)[2]
        return ca.Function("energy", self.inputs, [self.elastic, mean, self.step])

    def slope(self):
        r = ca.SX.sym("r", 3)
        mean = step(self.q, *self.screw)[2]
        energy = ca.sum1(self.elastic) - self.step * ca.dot(self.weight, r + mean)
        return ca.Function(
            "slope", [r, *self.inputs], [ca.gradient(energy, ca.vertcat(r, self.inputs[0]))]
        )

    def derivatives(self):
        q, strains, weight = self.q, self.strains, self.weight
        factor, gap = ca.SX.sym("lam_f"), ca.SX.sym("lam", 7)
        # λ·(R D) + λ_f w·(R h M) + λ_q·(q ∘ E) = k(q)·B(z), with B = (D, h M, E) in the frame of the node.
        weights = ca.vertcat(
            rotate(conjugate(q), gap[:3]),
            factor * rotate(conjugate(q), weight),
            multiply(conjugate(q), gap[3:]),
        )
        k, z, b = ca.SX.sym("k", 10), ca.SX.sym("z", 11), ca.SX.sym("b", 10)
        displacement, turned, mean = body(z[:3], z[3:6], z[6:9], z[9])
        seen = ca.vertcat(displacement, z[10] * mean, turned)
        curved, slope = ca.hessian(-ca.dot(k, seen), z)
        screw = ca.vertcat(*self.screw)
        # |θ|² as a variable of its own: the power series are then differentiated once, along it.
        screw = ca.vertcat(screw, ca.dot(screw[:3], screw[:3]), self.step)
        values = [k, z], [weights, screw]
        curved, slope, lead, seen = ca.substitute(
            [curved, slope, ca.jacobian(seen, z), seen], *values
        )
        along = ca.jacobian(screw, strains)
        g = ca.SX.sym("g", 11)
        bent = ca.substitute(ca.hessian(ca.dot(g, screw), strains)[0], g, slope)
        turning = ca.substitute(ca.hessian(-ca.dot(weights, b), q)[0], b, seen)
        mixed = -along.T @ (lead.T @ ca.jacobian(weights, q))
        stiff = ca.hessian(factor * ca.sum1(self.elastic), strains)[0]
        stretched = along.T @ curved @ along + bent + stiff
        block = upper(ca.blockcat([[turning, mixed.T], [mixed, stretched]]))
        d, e = ca.SX.sym("d", 3), ca.SX.sym("e", 4)
        pose = ca.vertcat(rotate(q, d), multiply(q, e))
        outer = ca.horzcat(ca.jacobian(pose, q), ca.jacobian(pose, ca.vertcat(d, e)))
        outer = ca.substitute(outer, ca.vertcat(d, e), ca.vertcat(seen[:3], seen[6:]))
        inner = ca.vertcat(lead[:3, :], lead[6:, :]) @ along
        reach = ca.horzcat(outer[:, :4], outer[:, 4:] @ inner)
        return (
            ca.Function("block", [*self.inputs, factor, gap], ca.cse([block])),
            ca.Function("reach", self.inputs, ca.cse([ca.densify(ca.vec(reach))])),
        )
