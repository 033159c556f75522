# SPDX-License-Identifier: LGPL-2.1-or-later
"""Derivatives of the program, block by block.

Nothing couples two stages but the gaps, which are linear in the next state, so the Hessian of the
Lagrangian is block diagonal. The block of an element is made once, symbolically, by the chain rule
through the screw, and written out for every element: half the operations, and a fraction of the
building time, of differentiating the whole program.
"""

import casadi as ca

from .element import body, conjugate, multiply, rotate


def element_block(scheme, structure, full) -> ca.Function:
    """(q and strains, h, stiffness, natural, weight, λ_f, λ of the pose gap) → over q and strains: Hessian of
    an element's part of the Lagrangian, and Jacobian (7, …) of the pose that it reaches. Where element lengths are
    unknowns, h is a share of the length of the stretch, which comes last of the strains.

    ``full`` completes the strains that the model keeps to (κ, v)."""
    size = len(structure.strains)
    q, h, factor = ca.SX.sym("q", 4), ca.SX.sym("h"), ca.SX.sym("lam_f")
    stiffness, natural, weight = (ca.SX.sym(n, k) for n, k in (("k", 6), ("n", 3), ("w", 3)))
    gap = ca.SX.sym("lam", 7)
    first = ca.SX.sym("e0", size)
    last = ca.SX.sym("e1", size) if scheme.STRAIN_IS_STATE else first
    strains = ca.vertcat(first, last) if scheme.STRAIN_IS_STATE else first
    step = h
    if structure.slides:
        stretch = ca.SX.sym("l")
        strains, step = ca.vertcat(strains, stretch), h * stretch

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
    screw = ca.vertcat(*scheme.screw(step, full(first, natural), full(last, natural)))
    # |θ|² as a variable of its own: the power series are then differentiated once, along it.
    screw = ca.vertcat(screw, ca.dot(screw[:3], screw[:3]), step)
    values = [k, z], [weights, screw]
    curved, slope, lead, seen = ca.substitute([curved, slope, ca.jacobian(seen, z), seen], *values)
    along = ca.jacobian(screw, strains)
    g = ca.SX.sym("g", 11)
    bent = ca.substitute(ca.hessian(ca.dot(g, screw), strains)[0], g, slope)
    turning = ca.substitute(ca.hessian(-ca.dot(weights, b), q)[0], b, seen)
    mixed = -along.T @ (lead.T @ ca.jacobian(weights, q))
    kept = list(structure.strains)
    rest = ca.vertcat(natural, 0, 0, 0)[kept]
    elastic = scheme.elastic_energy(step, stiffness[kept], first - rest, last - rest)
    stiff = ca.hessian(factor * ca.sum1(elastic), strains)[0]
    stretched = along.T @ curved @ along + bent + stiff
    block = ca.triu2symm(ca.triu(ca.blockcat([[turning, mixed.T], [mixed, stretched]])))
    d, e = ca.SX.sym("d", 3), ca.SX.sym("e", 4)
    pose = ca.vertcat(rotate(q, d), multiply(q, e))
    outer = ca.horzcat(ca.jacobian(pose, q), ca.jacobian(pose, ca.vertcat(d, e)))
    outer = ca.substitute(outer, ca.vertcat(d, e), ca.vertcat(seen[:3], seen[6:]))
    inner = ca.vertcat(lead[:3, :], lead[6:, :]) @ along
    reach = ca.horzcat(outer[:, :4], outer[:, 4:] @ inner)
    inputs = [ca.vertcat(q, strains), h, stiffness, natural, weight, factor, gap]
    return ca.Function("element_block", inputs, [block, reach])
