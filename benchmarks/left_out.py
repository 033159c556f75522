# SPDX-License-Identifier: LGPL-2.1-or-later
"""What leaving a part out of the model saves, and what it would cost where the part is needed."""

import time
from dataclasses import dataclass, replace

import numpy as np
from scipy.interpolate import CubicSpline

from benchmarks.cases import seed_paper, tilted
from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.geometry import rotation
from freecad_cable.problem import Box, Clamp, Ring, Scene, Swivel

REPEATS = 5
AXIAL = 385.0
"""EA [N] of Table 1's section, E π d²/4 with E = 10 MPa, d = 7 mm."""


@dataclass(frozen=True)
class LeftOut:
    """One part and one scene."""

    part: str
    scene: str
    needed: str
    """whether the scene needs it: yes or no"""
    with_it: float
    """[s] of a solve that keeps the part, solvers built"""
    without: float
    """[s] of one that leaves it out"""
    error: float
    """largest distance between nodes of the two, relative to the length"""


def rows() -> list[LeftOut]:
    """Every part on a scene that does not need it and, where leaving it out could be wrong, on one that does."""
    paper, found = seed_paper(0.73), []

    def compare(part, name, needed, with_it, without, start=None):
        (a, with_time), (b, without_time) = _timed(with_it), _timed(without, start)
        error = np.linalg.norm(_places(a) - _places(b), axis=1).max() / a.scene.rod.length
        needed = "yes" if needed else "no"
        found.append(LeftOut(part, name, needed, with_time, without_time, float(error)))

    loose = replace(paper, end=_swivel(paper))
    compare("torsion", "Table 1, swivel at the end", False, _keeping(loose, "torsion"), loose)
    compare("torsion", "Table 1", True, paper, loose)
    compare("gravity", "Table 1", True, paper, replace(paper, gravity=(0.0, 0.0, 0.0)))
    stretchy = _stretching(paper, 1e4 * AXIAL)
    compare("stretch", "Table 1, EA 10⁴ times", False, _keeping(stretchy, "stretch"), stretchy)
    soft = _stretching(paper, AXIAL / 100)
    compare("stretch", "Table 1, a hundredth of EA", True, soft, paper)
    taut = tilted(1.001, 1.0)
    compare("stretch", "taut, EA L²/EI = 10⁵", True, _stretching(taut, 1e5), taut)
    far = tuple(
        Box([2 + 0.2 * (i % 20), 0.2 * (i // 20), 0.0], [1, 0, 0, 0], [0.1] * 3) for i in range(200)
    )
    compare("obstacles", "Table 1, 200 boxes out of reach", False, _near(paper, far), paper)
    free = find_equilibrium(paper)
    ring = Ring(free.position[12], rotation.tangent(free.quaternion[12]), 0.02)
    compare(
        "support", "Table 1 through an idle ring", False, replace(paper, supports=(ring,)), paper
    )
    clamped = replace(paper, supports=tuple(_clamp(free, k) for k in (8, 16, 24)))
    moved = replace(clamped, end=replace(paper.end, position=paper.end.position + [0.002, 0, 0]))
    compare("unchanged stretches", "Table 1 with 3 clamps, end moved", False, moved, moved, clamped)
    return found


def _keeping(scene, part) -> Scene:
    return replace(scene, options=replace(scene.options, keep=(part,)))


def _near(scene, obstacles) -> Scene:
    """All obstacles are given; what is out of reach is left out by the core."""
    return replace(scene, obstacles=obstacles)


def _stretching(scene, axial) -> Scene:
    return replace(scene, rod=replace(scene.rod, axial_stiffness=axial))


def _swivel(scene) -> Swivel:
    return Swivel(scene.end.position, rotation.tangent(scene.end.quaternion))


def _clamp(solution, node) -> Clamp:
    return Clamp(
        solution.position[node],
        solution.quaternion[node],
        arc_length=float(solution.arc_length[node]),
    )


def _timed(scene, before=None):
    """(solution, least time of some repeats [s]); ``before`` is a scene whose solution is at hand."""
    start = None if before is None else find_equilibrium(before)
    best = np.inf
    for _ in range(REPEATS + 1):
        begin = time.perf_counter()
        solution = find_equilibrium(scene, start=start).raise_for_status()
        best = min(best, time.perf_counter() - begin)
    return solution, best


def _places(solution):
    """Positions at even arc lengths."""
    s = np.linspace(0, solution.arc_length[-1], 201)
    return CubicSpline(solution.arc_length, solution.position)(s)
