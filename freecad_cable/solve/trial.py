# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is known about the answer of one solve."""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ..geometry import rotation
from ..transcription import arms, layout
from ..transcription.nlp import Nlp
from ..transcription.rows import SHORTEST
from ..transcription.shape import Shape
from . import backend, stability, strong_form
from .own import Touches

ACTING = 1e-6
"""Push of a bound, in units of force, below which it is none: the solvers leave their tolerance of 1e-9 over the
distance to a bound that does not act."""
FAINT = 1e-3
"""Share of the largest push below which a place is not taken to touch."""
MARGIN = 1.1
"""On the error estimate, which else is as often below the true error as above it, by up to a tenth (160 rows of
`./run bench`)."""


@dataclass(frozen=True, eq=False)
class Trial:
    """A converged program and its reading."""

    nlp: Nlp
    values: dict
    parameters: np.ndarray
    raw: backend.RawSolution
    steps: np.ndarray
    """(n,) element lengths that the program was given"""
    measured: float | None = None
    """error found by comparing meshes, where bounds act and the strong form does not hold as it is"""
    places: arms.Places | None = None
    """what keeps away from obstacles"""

    def measured_as(self, error: float | None) -> "Trial":
        """The same with its error measured; all else that has been read of it stays read."""
        other = replace(self, measured=error)
        read = vars(self).keys() - vars(other).keys() - {"error"}
        vars(other).update((name, vars(self)[name]) for name in read)
        return other

    @cached_property
    def shape(self) -> Shape:
        """The nodes; of rivals, of which only the energy is asked, they need not be read."""
        found = self.raw.x, self.raw.multipliers
        return layout.shape_of(self.nlp, self.values, self.parameters, self.steps, *found)

    @cached_property
    def energies(self) -> np.ndarray:
        """(4,) bending, torsion, stretch, gravity without units"""
        return self.nlp.energy_function(self.raw.x, self.parameters)[0]

    @property
    def energy(self) -> float:
        return float(self.energies.sum())

    @cached_property
    def error(self) -> float:
        """Estimate of the largest position error of a node, relative to the length."""
        if self.slipped:
            return np.inf
        if self.measured is not None:
            return self.measured
        structure = self.nlp.structure
        correction = strong_form.correction(self.shape, self.values, structure)
        return MARGIN * float(np.linalg.norm(correction[:, :3], axis=1).max())

    @cached_property
    def acting(self) -> np.ndarray:
        """(rows,) whether a row holds: an equation, or a bound that pushes harder than it is far."""
        if self.nlp.equality.all():
            return self.nlp.equality
        (left,) = self.nlp.rows_function(self.raw.x, self.parameters)
        push = -self.raw.multipliers
        return self.nlp.equality | ((push > ACTING) & (push > left))

    @cached_property
    def frames(self) -> np.ndarray:
        """(n+1, 3, 3) material frames, d1 d2 d3 as columns"""
        return rotation.matrix(self.shape.quaternion)

    @property
    def touches(self) -> bool:
        return bool(self.contact_forces.any() or len(self.with_itself.nodes))

    @cached_property
    def with_itself(self) -> Touches:
        """Where the rod touches itself."""
        rows = self.nlp.link_rows
        push = np.where(self.acting[rows], -self.raw.multipliers[rows], 0.0)
        return Touches.of(self.shape, self.values["links"], push)

    @cached_property
    def touched(self) -> arms.Touched:
        """Where its places are that keep away from obstacles."""
        return arms.read(self.nlp, self.raw.x, self.values["arms"])

    @cached_property
    def contact_forces(self) -> np.ndarray:
        """(n, contacts, 3) what obstacles exert on each element, without units."""
        rows = self.nlp.contact_rows
        if not rows.size:
            return np.zeros((len(rows), 0, 3))
        push = np.where(self.acting[rows], -self.raw.multipliers[rows], 0.0)
        return push[..., None] * self.touched.slope

    @cached_property
    def contact_places(self) -> np.ndarray:
        """(n, contacts) arc lengths at which it does so, relative to the length"""
        if self.places is None:
            return np.zeros(self.contact_forces.shape[:2])
        return self.shape.arc_length[:-1, None] + self.places.beyond + self.touched.slid

    def contact_runs(self, radius, owner=None) -> list[tuple[np.ndarray, np.ndarray]]:
        """(elements, slots) of each place or stretch at which obstacles push, or one of them; what is less than a
        diameter apart is one."""
        there = self.contact_forces.any(axis=2)
        if owner is not None:
            there = there & (self.places.owners == owner)
        elements, slots = np.nonzero(there)
        apart = np.diff(self.contact_places[there])
        parts = np.flatnonzero((np.diff(elements) > 1) & (apart > 2 * radius)) + 1
        runs = zip(np.split(elements, parts), np.split(slots, parts), strict=True)
        return [run for run in runs if len(run[0])]

    @cached_property
    def pushed(self) -> arms.Pushed | None:
        """The places that obstacles push, but for what the solver leaves of its barrier beside them."""
        size = np.linalg.norm(self.contact_forces, axis=2)
        there = size > FAINT * size.max(initial=0.0)
        if not there.any():
            return None
        places, touched = self.places, self.touched
        return arms.Pushed(
            np.nonzero(there)[0],
            self.contact_places[there],
            touched.position[there],
            touched.gap[there],
            places.features[there],
            places.slides[there],
            places.owners[there],
        )

    @cached_property
    def slipped(self) -> tuple[int, ...]:
        """Supports that have slid as near to what is beside them as the program allows: no equilibrium."""
        structure = self.nlp.structure
        if not structure.slides:
            return ()
        ends = self.shape.arc_length[structure.ends]
        short = np.diff(ends) < (1 + 1e-3) * SHORTEST
        return tuple(int(j) for j in np.flatnonzero(structure.sliding) if short[j : j + 2].any())

    @property
    def _program(self):
        return self.nlp, self.raw.x, self.parameters, self.raw.multipliers, self.acting

    @cached_property
    def lowest_mode(self):
        """(relative eigenvalue, variation of the decision vector)"""
        return stability.SecondVariation(*self._program).lowest_mode()

    def swayed(self, size) -> Shape:
        """Its nodes moved along the least stable variation, the one that moves most by ``size`` (negative for the
        other way): a guess that has no symmetry to be caught in."""
        mode = self.lowest_mode[1]
        change = size * mode / max(np.abs(mode[self.nlp.states[:, :3]]).max(), 1e-9)
        while True:
            nodes = layout.places(self.nlp, self.shape.steps, self.raw.x + change)
            if (np.diff(nodes[0]) > 0).all():
                return Shape.from_frames(*nodes, self.nlp.structure.joints)
            change /= 2  # a support would slide past another, or past an end

    @cached_property
    def stable(self) -> bool:
        return stability.proven(*self._program) or self.lowest_mode[0] > -stability.ZERO
