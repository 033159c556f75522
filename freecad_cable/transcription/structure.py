# SPDX-License-Identifier: LGPL-2.1-or-later
"""What makes two problems share one built solver: everything that is not a number."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

STRAINS = ("κ1", "κ2", "τ", "γ1", "γ2", "ε")
"""Bending about d1 and d2, twist, shear along d1 and d2, stretch."""


@dataclass(frozen=True)
class Structure:
    """Key of a transcription. Two scenes with equal structures differ in parameters only."""

    scheme: str
    stretches: tuple[int, ...]
    """elements between one support and the next"""
    start: str
    end: str
    strains: tuple[int, ...]
    """indices into STRAINS of what the model keeps; the others stay at their natural value"""
    supports: tuple[str, ...] = ()
    """``clamp``, ``sleeve``, ``ring`` or ``eyelet`` (a ring without play)"""
    sliding: tuple[bool, ...] = ()
    """of each support, whether its arc length is an unknown"""
    contacts: int = 0
    """features of obstacles that each element keeps away from"""
    bend_limit: bool = False
    """whether the curvature is bounded"""
    links: tuple[tuple[int, int], ...] = ()
    """(node, first node of the element) of the rod's own that keep away from each other; they couple stages that are
    no neighbours, which only the general solver bears"""

    @property
    def elements(self) -> int:
        return sum(self.stretches)

    @cached_property
    def joints(self) -> tuple[int, ...]:
        """Nodes of the supports."""
        return tuple(int(node) for node in np.cumsum(self.stretches)[:-1])

    @property
    def ends(self) -> list[int]:
        """Nodes where stretches begin and end."""
        return [0, *self.joints, self.elements]

    @property
    def slides(self) -> bool:
        """Whether element lengths are unknowns."""
        return any(self.sliding)

    @property
    def rolls(self) -> bool:
        """Whether nothing determines the roll of the frames: no torsion, and nothing clamped."""
        clamped = "clamped" in (self.start, self.end) or "clamp" in self.supports
        return 2 not in self.strains and not clamped
