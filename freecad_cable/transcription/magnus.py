# SPDX-License-Identifier: LGPL-2.1-or-later
"""Magnus elements: strain linear in each element and continuous at the nodes, order 4.

The step is the Magnus series to order 4 on SE(3), which for a linear strain needs one commutator:
Ω = h (ξ₀ + ξ₁)/2 + h²/12 [ξ₀, ξ₁] for Y' = Y ξ (Iserles et al., "Lie-group methods", Acta Numerica 9 (2000), sec. 5;
for rods: arXiv 2008.01054). The mean position along the step's screw is that of the true path to the same
order as far as the frame turns unevenly (that deviation is odd about the middle of the element); where the
rod stretches unevenly the path runs ahead or behind by v' s (s − h)/2, on average −(v₁ − v₀) h/12: the bow.
"""

import casadi as ca

ORDER = 4
STRAIN_IS_STATE = True


def screw(h, first, last):
    """(θ, ρ, bow) of an element of length h from the strains (κ, v) at its two nodes."""
    (kappa0, v0), (kappa1, v1) = first, last
    theta = h / 2 * (kappa0 + kappa1) + h**2 / 12 * ca.cross(kappa0, kappa1)
    rho = h / 2 * (v0 + v1) + h**2 / 12 * (ca.cross(kappa0, v1) - ca.cross(kappa1, v0))
    return theta, rho, -h / 12 * (v1 - v0)


def elastic_energy(h, stiffness, first, last):
    """Energy per strain component, from deviations (m,) from the natural strain at the two nodes."""
    return h / 6 * stiffness * (first**2 + first * last + last**2)
