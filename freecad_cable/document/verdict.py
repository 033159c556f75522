# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is to be judged about a cable, the same for its stored results and for a preview of them. Lengths in mm."""

import math
from dataclasses import dataclass

from ..result import Solution
from ..shape.units import from_si


@dataclass(frozen=True)
class Verdict:
    """The numbers; ``limit`` 0: no limit, ``clearance`` infinite: nothing is near."""

    length: float
    bend_radius: float
    bend_at: float
    """where on the cable that is, from its start"""
    limit: float
    clearance: float
    clearance_asked: float
    stable: bool
    error: float
    """estimate of the largest error of position"""

    @property
    def margin(self) -> float:
        """Smallest bend radius less the limit; infinite without a limit."""
        return self.bend_radius - self.limit if self.limit else math.inf


def of_cable(cable) -> Verdict | None:
    """From the results of a cable; None if it has none."""
    if not cable.SolvedInputs:
        return None
    radius = cable.SmallestBendRadius.Value
    return Verdict(
        length=cable.SolvedLength.Value,
        bend_radius=radius,
        bend_at=cable.SmallestBendRadiusAt.Value,
        limit=max(0.0, radius - cable.BendRadiusMargin.Value),
        clearance=cable.SmallestClearance.Value,
        clearance_asked=cable.Clearance.Value,
        stable=cable.Stable,
        error=cable.ErrorEstimate.Value,
    )


def of_solution(solution: Solution) -> Verdict:
    """From a solution that has a shape."""
    rod, clearance = solution.scene.rod, solution.min_clearance
    radius, place = solution.min_bend_radius
    return Verdict(
        length=from_si("length", rod.length),
        bend_radius=from_si("length", radius),
        bend_at=from_si("length", place),
        limit=from_si("length", rod.min_bend_radius or 0.0),
        clearance=math.inf if clearance is None else from_si("length", clearance),
        clearance_asked=from_si("length", solution.scene.clearance),
        stable=bool(solution.stable),
        error=from_si("length", solution.position_error),
    )
