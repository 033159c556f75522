# SPDX-License-Identifier: LGPL-2.1-or-later
"""The solution of a scene: plain arrays in SI units, world frame unless said otherwise."""

from dataclasses import dataclass, field

import numpy as np
from scipy.integrate import trapezoid

from ..errors import SolveError
from ..problem import Scene
from ..status import Status
from .balance import Balance

ENFORCED = 1e-4
"""Share of a bend radius that an enforced one may fall short by: the solvers stop so near to their bounds."""


@dataclass(frozen=True)
class Load:
    """A force (3,) [N] and a moment (3,) [N m] about the point where they act."""

    force: np.ndarray
    moment: np.ndarray


@dataclass(frozen=True)
class Contact:
    """What an obstacle, or another part of the cable, exerts on one place of it."""

    arc_length: float
    """[m] of the middle of the force"""
    obstacle: int | None
    """index of the scene's obstacle; None where the cable touches itself"""
    force: np.ndarray
    """(3,) [N] on the cable, summed over the place"""
    other_arc_length: float | None = None
    """[m] of the other place, where the cable touches itself"""


@dataclass(frozen=True)
class Formed:
    """A piece of the cable that keeps its bend radius only because it is formed: its elastic moment is less than the
    moment that it must carry there, by this much."""

    start: float
    """[m] arc length"""
    end: float
    """[m] arc length"""
    moment: float
    """[N m] largest in the piece"""


@dataclass(frozen=True)
class Energy:
    """[J]; gravity is measured along −gravity from the start point."""

    bending: float
    torsion: float
    stretch: float
    gravity: float

    @property
    def total(self) -> float:
        return self.bending + self.torsion + self.stretch + self.gravity


@dataclass(frozen=True)
class LengthBound:
    """One end of the interval of lengths that satisfy all requirements."""

    length: float
    """[m]"""
    requirement: str | None
    """what fails beyond it: bend radius, clearance, reach or equilibrium; None where the search ended"""
    arc_length: float | None
    """[m] where on the cable it fails; None if that is no place"""
    sentence: str


@dataclass(frozen=True, kw_only=True, eq=False)
class Solution:
    """An equilibrium of a scene, or the reason why there is none.

    The arrays are None if nothing was found. n is the number of elements.
    """

    scene: Scene
    status: Status
    message: str

    arc_length: np.ndarray | None = None
    """(n+1,) unstretched arc length of the nodes [m]"""
    position: np.ndarray | None = None
    """(n+1, 3) [m]"""
    quaternion: np.ndarray | None = None
    """(n+1, 4) scalar first, sign-continuous; R(q) e_i = d_i, d3 the tangent"""
    force: np.ndarray | None = None
    """(n+1, 3) internal force: what the part beyond the node exerts on the part before it [N]"""
    moment: np.ndarray | None = None
    """(n+1, 3) internal moment, same sense [N m]"""
    curvature: np.ndarray | None = None
    """(n+1, 3) κ1, κ2 and twist at the nodes, material frame [1/m]"""

    energy: Energy | None = None
    start_reaction: Load | None = None
    """what the connector at the start exerts on the cable"""
    end_reaction: Load | None = None
    support_reactions: tuple[Load, ...] = ()
    """what each support exerts on the cable; beyond its node force and moment are less by as much"""
    support_nodes: tuple[int, ...] = ()
    """node of each support; force, moment and curvature there are those just before it"""
    min_bend_radius: tuple[float, float] | None = None
    """smallest bend radius of the centreline [m] and the arc length where it is [m]"""
    formed: tuple[Formed, ...] = ()
    """where the cable must be formed, if its bend radius is enforced"""
    contacts: tuple[Contact, ...] = ()
    min_clearance: float | None = None
    """smallest distance between the surfaces of the cable and of the obstacles in its reach [m]; None without any"""
    anew: bool = False
    """whether no equilibrium was found that the solution before becomes, though that was near: this one may have a turn
    more, or be on another side of an obstacle"""
    stable: bool | None = None
    """whether the second variation of the energy is positive; None if not known"""
    position_error: float | None = None
    """estimate of the largest position error of a node [m]"""
    balance: Balance | None = None
    """residuals of the equations of equilibrium, recomputed from the nodes alone"""

    feasible_lengths: tuple[LengthBound, LengthBound] | None = None
    """shortest and longest, where the length was asked for"""

    left_out: tuple[str, ...] = ()
    """what the model left out, and why, as sentences"""
    kept: tuple[str, ...] = ()
    stretches: tuple["Solution", ...] = ()
    """of a cable that clamps cut into stretches, the solution of each"""
    solver: dict = field(default_factory=dict)
    """name, scheme, elements, iterations, build_time [s], solve_time [s]"""

    @property
    def bend_radius_margin(self) -> float | None:
        """Smallest bend radius less the one that the rod allows [m], negative if it is violated; None if it allows any,
        or if nothing was found."""
        limit = self.scene.rod.min_bend_radius
        if limit is None or self.min_bend_radius is None:
            return None
        return self.min_bend_radius[0] - limit

    @property
    def bends_too_sharply(self) -> bool:
        """Whether it does somewhere, beyond what the solvers leave of a bend radius that is enforced."""
        margin = self.bend_radius_margin
        return margin is not None and margin < -ENFORCED * self.scene.rod.min_bend_radius

    @property
    def pushed_clear(self) -> Contact | None:
        """The first place at which an obstacle pushes a cable that is asked to keep clear of it: by itself it does not.
        None if there is none."""
        pushed = (each for each in self.contacts if each.obstacle is not None)
        return next(pushed, None) if self.scene.clearance > 0 else None

    @property
    def twist(self) -> float | None:
        """Angle by which the rod is twisted from its start to its end, beyond what it is by nature [rad]; None if
        nothing was found."""
        if self.stretches:
            return sum(part.twist for part in self.stretches)
        if self.curvature is None:
            return None
        excess = self.curvature[:, 2] - self.scene.rod.natural_curvature[2]
        return float(trapezoid(excess, self.arc_length))

    def raise_for_status(self) -> "Solution":
        """Itself when the shape may be used; else ``SolveError``."""
        if not self.status.success:
            raise SolveError(self)
        return self
