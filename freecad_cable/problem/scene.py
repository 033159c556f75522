# SPDX-License-Identifier: LGPL-2.1-or-later
"""The whole statement: a rod, what holds it, what is around it."""

from dataclasses import dataclass, field

import numpy as np

from ..errors import ProblemError
from ..options import SolveOptions
from .checked import number, vector
from .ends import End, Free, Pinned
from .reach import check_reach
from .rod import Rod

MOST_SUPPORTS = 200
"""Every support takes eight elements at least; more of them were never tried."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Scene:
    """A cable problem. Errors: ``ProblemError`` for values that contradict each other."""

    rod: Rod
    start: End
    end: End
    gravity: np.ndarray = field(default=(0.0, 0.0, -9.81))
    """(3,) [m/s²]"""
    supports: tuple = ()
    """of ``Support``, in order along the cable"""
    obstacles: tuple = ()
    """of ``Obstacle``"""
    clearance: float = 0.0
    """[m], between the surface of the cable and obstacles"""
    enforce_bend_radius: bool = False
    """whether the cable is formed so that it nowhere bends more sharply than ``rod.min_bend_radius``"""
    asks_length: bool = False
    """whether the length is what is asked for; ``rod.length`` is then where the search begins"""
    options: SolveOptions = SolveOptions()

    def __post_init__(self):
        object.__setattr__(self, "gravity", vector("gravity", self.gravity))
        object.__setattr__(self, "supports", tuple(self.supports))
        object.__setattr__(self, "obstacles", tuple(self.obstacles))
        if len(self.supports) > MOST_SUPPORTS:
            raise ProblemError(
                "supports",
                f"are {len(self.supports)}; at most {MOST_SUPPORTS} can be solved; divide the cable at a clamp",
            )
        given = number("clearance", self.clearance, at_least=0, unit="m")
        object.__setattr__(self, "clearance", given)
        if self.enforce_bend_radius and self.rod.min_bend_radius is None:
            raise ProblemError(
                "cable.min_bend_radius", "is not given, so it cannot be enforced; give it"
            )
        self._check_held()
        check_reach(self)

    def _check_held(self):
        held = [end for end in (self.start, self.end) if not isinstance(end, Free)]
        if not held and not self.supports:
            raise ProblemError(
                "end", "both ends are free, so nothing holds the cable; hold one of them"
            )
        hinged = len(held) == 1 and held[0].kind == "pinned" and not self.supports
        if hinged and not self.weight.any():
            raise ProblemError(
                held[0].place,
                "pinned, the other end free and no weight: the cable can turn freely; "
                "clamp this end or hold the other",
            )
        if not held and all(support.slides for support in self.supports):
            raise ProblemError(
                "supports",
                "both ends are free and every support lets the cable slide, so it would slide out; "
                "hold an end or give a support an arc length",
            )

    @property
    def spans(self) -> bool:
        """Whether both ends hold a position, so that there is a chord."""
        return isinstance(self.start, Pinned) and isinstance(self.end, Pinned)

    @property
    def chord(self) -> float:
        """Distance between the ends [m]; both must hold a position."""
        return float(np.linalg.norm(self.end.position - self.start.position))

    @property
    def weight(self) -> np.ndarray:
        """(3,) weight per unstretched length [N/m]."""
        return self.rod.mass_per_length * self.gravity
