# SPDX-License-Identifier: LGPL-2.1-or-later
"""End conditions. At both ends the tangent d3 points from the start of the cable to its end."""

from dataclasses import dataclass, field
from typing import ClassVar

import numpy as np

from .checked import direction, vector


@dataclass(frozen=True, eq=False)
class End:
    """Common to all end conditions; ``place`` is ``start`` or ``end`` and is used in error messages."""

    kind: ClassVar[str]
    place: str = field(default="end", kw_only=True)


@dataclass(frozen=True, eq=False)
class Free(End):
    """Holds nothing."""

    kind = "free"


@dataclass(frozen=True, eq=False)
class Pinned(End):
    """Holds the position (3,) [m]; the cable may turn any way."""

    kind = "pinned"
    position: np.ndarray

    def __post_init__(self):
        object.__setattr__(self, "position", vector(f"{self.place}.position", self.position))


@dataclass(frozen=True, eq=False)
class Swivel(Pinned):
    """Holds the position and the unit tangent (3,); the cable may twist."""

    kind = "swivel"
    tangent: np.ndarray

    def __post_init__(self):
        super().__post_init__()
        object.__setattr__(self, "tangent", direction(f"{self.place}.tangent", self.tangent))


@dataclass(frozen=True, eq=False)
class Clamped(Pinned):
    """Holds the position and the whole frame: unit quaternion (4,), scalar first, normalised on input."""

    kind = "clamped"
    quaternion: np.ndarray

    def __post_init__(self):
        super().__post_init__()
        object.__setattr__(
            self, "quaternion", direction(f"{self.place}.quaternion", self.quaternion, 4)
        )
