# SPDX-License-Identifier: LGPL-2.1-or-later
"""Supports: what holds a cable on its way. All are one normal form (Du, Jiang, Xiong, Sci Rep 12, 2022): a rule for the
position of a section, a rule for its orientation, and an arc length that is given or free.

A support with a free arc length lets the cable slide through it without friction.
"""

from dataclasses import dataclass, field
from typing import ClassVar

import numpy as np

from .checked import direction, number, vector


@dataclass(frozen=True, eq=False)
class Support:
    """Common to all supports: a section of the cable is at ``position`` (3,) [m]."""

    kind: ClassVar[str]
    position: np.ndarray
    arc_length: float | None = field(default=None, kw_only=True)
    """[m] from the start of the unstretched cable to the held section; None: the cable slides"""
    place: str = field(default="supports", kw_only=True)
    """how error messages name it"""

    def __post_init__(self):
        object.__setattr__(self, "position", vector(f"{self.place}.position", self.position))
        if self.arc_length is not None:
            given = number(f"{self.place}.arc_length", self.arc_length, above=0, unit="m")
            object.__setattr__(self, "arc_length", given)

    @property
    def slides(self) -> bool:
        return self.arc_length is None


@dataclass(frozen=True, eq=False)
class Clamp(Support):
    """Holds the whole frame: unit quaternion (4,), scalar first, normalised on input; d3 along the cable."""

    kind = "clamp"
    quaternion: np.ndarray

    def __post_init__(self):
        super().__post_init__()
        unit = direction(f"{self.place}.quaternion", self.quaternion, 4)
        object.__setattr__(self, "quaternion", unit)


@dataclass(frozen=True, eq=False)
class Sleeve(Support):
    """Holds the unit tangent (3,), along the cable; the cable may twist in it."""

    kind = "sleeve"
    tangent: np.ndarray

    def __post_init__(self):
        super().__post_init__()
        unit = direction(f"{self.place}.tangent", self.tangent)
        object.__setattr__(self, "tangent", unit)


@dataclass(frozen=True, eq=False)
class Clip(Sleeve):
    """A sleeve that grips: meant for a given arc length."""

    kind = "clip"


@dataclass(frozen=True, eq=False)
class Ring(Support):
    """A round hole: the section is in the plane through ``position`` normal to ``axis`` (3,), and within ``radius`` [m]
    less the cable's radius of its centre. The cable may pass it at any angle, in either direction."""

    kind = "ring"
    axis: np.ndarray
    radius: float

    def __post_init__(self):
        super().__post_init__()
        object.__setattr__(self, "axis", direction(f"{self.place}.axis", self.axis))
        checked = number(f"{self.place}.radius", self.radius, above=0, unit="m")
        object.__setattr__(self, "radius", checked)


SUPPORTS = {kind.kind: kind for kind in (Clamp, Sleeve, Clip, Ring)}
