# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a peer is asked and what it answers: plain numbers in SI units that go through files, because peers live in
processes of their own, beside a NumPy of their own."""

import json
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path

import numpy as np

from freecad_cable.geometry import rotation


@dataclass(frozen=True)
class Nodes:
    """A shape: arc lengths (n+1,), positions (n+1, 3), quaternions (n+1, 4), and, of a shape in equilibrium, force and
    moment (n+1, 3) that the part beyond exerts on the part before."""

    arc_length: np.ndarray
    position: np.ndarray
    quaternion: np.ndarray
    force: np.ndarray | None = None
    moment: np.ndarray | None = None


@dataclass(frozen=True)
class Task:
    """A rod clamped at its start; at its end clamped, or free (no position)."""

    length: float
    radius: float
    bending: float
    """EI [N m²]"""
    torsion: float
    """GJ [N m²]"""
    axial: float
    """EA [N]; of peers that cannot do without stretch and shear"""
    shear: float
    """GA [N]"""
    mass: float
    """per length [kg/m]"""
    gravity: np.ndarray
    start_position: np.ndarray
    start_quaternion: np.ndarray
    end_position: np.ndarray | None
    end_quaternion: np.ndarray | None
    start: Nodes
    """where to start, on a finer mesh than asked for; a peer makes of it what it can"""
    near: bool
    """whether ``start`` is the answer of a rod that neither stretches nor shears, and not a guess"""
    elements: int
    """for peers that do not choose by themselves"""
    tolerance: float
    """for those that do"""
    variant: str
    """which of its ways a peer with several is to go"""
    steps: int
    """load steps, of peers that are led to the task"""

    def start_at(self, arc_length):
        """Positions (m, 3) and quaternions (m, 4) of the start at arc lengths (m,), linear in between; beyond the ends
        straight on."""
        s, frames = self.start.arc_length, self.start.quaternion
        position, quaternion = (
            np.stack([np.interp(arc_length, s, column) for column in values.T], axis=1)
            for values in (self.start.position, frames)
        )
        quaternion /= np.linalg.norm(quaternion, axis=1)[:, None]
        beyond = arc_length - np.clip(arc_length, 0, self.length)
        return position + beyond[:, None] * rotation.tangent(quaternion), quaternion

    @property
    def arc_length(self) -> np.ndarray:
        """(elements+1,), even"""
        return np.linspace(0, self.length, self.elements + 1)


@dataclass(frozen=True)
class Found:
    """Nodes of a peer's answer."""

    arc_length: np.ndarray
    position: np.ndarray
    unknowns: int
    """how many numbers it solved for"""
    build: float = 0.0
    """[s] spent on what a next solve would not have to do again; it does not count"""
    remark: str = ""
    seconds: float = field(default=0.0)
    """[s] of the quickest solve, without ``build``; whoever calls the peer takes it"""


def write(path: Path, what):
    path.write_text(json.dumps(asdict(what), default=np.ndarray.tolist), encoding="utf-8")


def read_task(path: Path) -> Task:
    task = Task(**_arrays(json.loads(path.read_text(encoding="utf-8"))))
    return replace(task, start=Nodes(**_arrays(task.start)))


def read_found(path: Path) -> Found:
    return Found(**_arrays(json.loads(path.read_text(encoding="utf-8"))))


def _arrays(given):
    return {
        name: np.array(value, float) if isinstance(value, list) else value
        for name, value in given.items()
    }
