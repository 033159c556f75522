# SPDX-License-Identifier: LGPL-2.1-or-later
"""What makes two problems share one built solver: everything that is not a number."""

from dataclasses import dataclass

STRAINS = ("κ1", "κ2", "τ", "γ1", "γ2", "ε")
"""Bending about d1 and d2, twist, shear along d1 and d2, stretch."""


@dataclass(frozen=True)
class Structure:
    """Key of a transcription. Two scenes with equal structures differ in parameters only."""

    scheme: str
    elements: int
    start: str
    end: str
    strains: tuple[int, ...]
    """indices into STRAINS of what the model keeps; the others stay at their natural value"""

    @property
    def rolls(self) -> bool:
        """Whether nothing determines the roll of the frames: no torsion, and no end clamped."""
        return 2 not in self.strains and "clamped" not in (self.start, self.end)
