# SPDX-License-Identifier: LGPL-2.1-or-later
"""An equilibrium known exactly, or to a stated error, in the arrays of a ``Solution``."""

from dataclasses import dataclass, replace

import numpy as np

from ..result import Energy


@dataclass(frozen=True, kw_only=True, eq=False)
class RodState:
    """A rod in equilibrium at arc lengths (m,), world frame, units as given (SI for a scene)."""

    arc_length: np.ndarray
    """(m,) unstretched"""
    position: np.ndarray
    """(m, 3)"""
    quaternion: np.ndarray
    """(m, 4) scalar first; R(q) e_i = d_i, d3 the normal of the section"""
    force: np.ndarray
    """(m, 3) what the part beyond exerts on the part before"""
    moment: np.ndarray
    """(m, 3) in the same sense"""
    energy: Energy
    """of the whole rod, from its start to its last arc length"""
    error: float = 0.0
    """bound or estimate of the largest position error; 0 for a closed form"""

    def at(self, arc_length) -> "RodState":
        """The state at some of its own arc lengths (k,). Errors: ``ValueError`` at any other."""
        wanted = np.asarray(arc_length, float)
        place = np.abs(self.arc_length[:, None] - wanted).argmin(axis=0)
        if np.abs(self.arc_length[place] - wanted).max() > 1e-9 * self.arc_length[-1]:
            raise ValueError("the state is known at its own arc lengths only; ask for some of them")
        arrays = ("arc_length", "position", "quaternion", "force", "moment")
        return replace(self, **{name: getattr(self, name)[place] for name in arrays})


def in_plane(angle):
    """Quaternions (m, 4) with d3 = (cos, 0, sin) of the angles (m,) and d2 = y.

    With them κ2 = −dθ/ds, and the moment of a rod bent in this plane is −EI dθ/ds along y.
    """
    half = (np.pi / 2 - np.asarray(angle)) / 2
    zero = np.zeros_like(half)
    return np.stack((np.cos(half), zero, np.sin(half), zero), axis=-1)


def vectors(x=0.0, y=0.0, z=0.0, *, count):
    """(count, 3) from components that are numbers or (count,)."""
    return np.stack([np.broadcast_to(value, (count,)) for value in (x, y, z)], axis=-1)
