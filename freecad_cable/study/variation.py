# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is not known exactly: a parameter within a band."""

import math
from dataclasses import dataclass

from ..errors import ProblemError
from ..problem import Clamp, Clamped, Free, Scene, Sleeve, Swivel
from ..problem.checked import number, shown
from .parameter import Parameter

SPREADS = ("uniform", "normal", "log")

LENGTH_TOLERANCE = ((0.3, 0.025), (1.5, 0.05), (3.0, 0.1), (7.5, 0.15))
"""Length up to which, and by how much a cable may be longer [m]; never shorter. IPC/WHMA-A-620, Table 11-1."""
LONG = 0.05
"""The same for longer ones, relative to the length."""


@dataclass(frozen=True, eq=False)
class Variation:
    """A parameter between ``low`` and ``high``.

    ``spread``: ``uniform``; ``normal`` about the middle with a deviation of a sixth of the band, drawn anew where it
    leaves the band; ``log``: uniform in the logarithm, for a factor that is not known.
    """

    parameter: Parameter
    low: float
    high: float
    spread: str = "uniform"

    def __post_init__(self):
        place = self.parameter.field
        for name in ("low", "high"):
            object.__setattr__(self, name, number(f"{place} {name}", getattr(self, name)))
        if not self.low <= self.high:
            raise ProblemError(
                f"{place} high", f"is {self.high:g}; it must be at least low, {self.low:g}"
            )
        if self.spread not in SPREADS:
            raise ProblemError(
                f"{place} spread",
                f"is {shown(self.spread)}; it must be one of {', '.join(SPREADS)}",
            )
        if self.spread == "log" and not self.low > 0:
            raise ProblemError(
                f"{place} low", f"is {self.low:g}; with spread log it must be greater than 0"
            )

    def drawn(self, random) -> float:
        """A value, with a NumPy generator."""
        if self.spread == "log":
            low, high = math.log(self.low), math.log(self.high)
            return min(max(math.exp(random.uniform(low, high)), self.low), self.high)
        if self.spread == "uniform":
            return float(random.uniform(self.low, self.high))
        middle, deviation = (self.low + self.high) / 2, (self.high - self.low) / 6
        while True:
            value = float(random.normal(middle, deviation))
            if self.low <= value <= self.high:
                return value


def length_tolerance(length: float) -> float:
    """How much longer than its nominal length [m] a cable may be made [m], IPC/WHMA-A-620, Table 11-1."""
    return next((more for up_to, more in LENGTH_TOLERANCE if length <= up_to), LONG * length)


def longer(scene: Scene) -> Variation:
    """The length of a cable within the tolerance of its making."""
    length = Parameter(field="cable.length", how="add")
    return Variation(length, 0.0, length_tolerance(scene.rod.length))


def held_within(scene: Scene, place: str, distance: float, angle: float) -> list[Variation]:
    """An end or a support, ``start``, ``end`` or ``supports[0]``, within ``distance`` [m] along each axis of the
    world and within ``angle`` [rad] about each of its own axes that it holds."""
    holder = Parameter(field=place, how="move", axis=(1, 0, 0)).at(scene)
    if isinstance(holder, Free) or not hasattr(holder, "position"):
        raise ProblemError(place, "holds nothing, so it has no tolerance")
    axes = ("d1", "d2", "d3") if isinstance(holder, (Clamped, Clamp)) else ()
    if isinstance(holder, (Swivel, Sleeve)):
        axes = ("d1", "d2")
    moves = [
        Parameter(field=place, how="move", axis=axis) for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1))
    ]
    turns = [Parameter(field=place, how="turn", axis=axis) for axis in axes]
    found = [Variation(each, -distance, distance) for each in moves if distance]
    return found + [Variation(each, -angle, angle) for each in turns if angle]
