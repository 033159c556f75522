# SPDX-License-Identifier: LGPL-2.1-or-later
"""Helix elements: constant strain in each element, order 2.

The kinematics and the work of gravity are exact for the chosen strains, so the discrete energy is the energy
of an admissible shape: an upper bound that no coarse mesh can cheat (a conforming Ritz method; for rods:
Bertails et al., "Super-helices", ACM TOG 25 (2006)).
"""

ORDER = 2
STRAIN_IS_STATE = False


def screw(h, first, last):
    """(θ, ρ, bow) of an element of length h from its strain (κ, v); both ends have the same, no bow."""
    kappa, v = first
    return h * kappa, h * v, 0 * v


def elastic_energy(h, stiffness, first, last):
    """Energy per strain component, from deviations (m,) from the natural strain."""
    return h / 2 * stiffness * first**2
