# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which variable of a program is what, in the stage order that fatrop wants: x₀ u₀ x₁ u₁ … x_N.

state x    position (3), quaternion (4); with a scheme whose strain is continuous the strain (m);
           where the cable slides, length and first arc length of the stretch (2)
control u  the strain of the element (m), or the strain at its far node (m);
           beyond a support also the strain at its first node (m), for it may jump there;
           beyond a support where the cable slides, the length of the next stretch (1)
"""

import numpy as np

from .element_functions import SCHEMES
from .structure import Structure


class Numbering:
    """Index arrays into the decision vector; n elements, m strains kept."""

    def __init__(self, structure: Structure):
        n, size = structure.elements, len(structure.strains)
        self.continuous = SCHEMES[structure.scheme].STRAIN_IS_STATE
        own = size if self.continuous else 0
        self.nx = 7 + own + 2 * structure.slides
        beyond = np.isin(np.arange(n), structure.joints)
        self.nu = np.append(size + beyond * (own + structure.slides), 0)
        self.begin = np.concatenate([[0], np.cumsum(self.nx + self.nu)])
        self.size = int(self.begin[-1])
        starts = self.begin[:-1, None]
        self.states = starts + np.arange(self.nx)
        """(n+1, nx)"""
        controls = starts[:-1] + self.nx
        place = np.arange(size)
        if self.continuous:
            state_strain = starts[:-1] + 7
            self.first = np.where(beyond[:, None], controls, state_strain) + place
            """(n, m) strain at the first node of each element"""
            self.last = controls + np.where(beyond[:, None], size, 0) + place
            """(n, m) strain at its last node; the same variables if the element has one strain"""
        else:
            self.first = self.last = controls + place
        self.stretch = None
        """(n,) length of the stretch of each element, where the cable slides"""
        if structure.slides:
            following = self.begin[1:-1] - 1
            self.stretch = np.where(beyond, following, self.states[:-1, self.nx - 2])
        strains = [self.first, self.last] if self.continuous else [self.first]
        lengths = [] if self.stretch is None else [self.stretch[:, None]]
        self.element = np.hstack([self.states[:-1, 3:7], *strains, *lengths])
        """(n, …) variables of the element functions"""
        self.strain_of = np.full(self.size, -1)
        """(size,) which of the kept strains a variable is; −1 for others"""
        if self.continuous:
            self.strain_of[self.states[:, 7 : 7 + size]] = place
        self.strain_of[self.first] = place
        self.strain_of[self.last] = place
