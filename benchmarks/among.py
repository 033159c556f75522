# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random scenes in which a cable meets obstacles, and how they end: through round holes in plates, and among solids.

Each is solved once, and how deep the cable is in an obstacle is found from the answer alone.
"""

from collections.abc import Callable, Iterable, Iterator
from contextlib import ExitStack
from dataclasses import dataclass, replace
from itertools import count, islice

import numpy as np
from scipy.interpolate import CubicHermiteSpline

from benchmarks.cases import GRAVITY, TABLE_1
from benchmarks.extreme import X, clamped
from benchmarks.guarded import Guarded
from benchmarks.outcomes import answered
from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.geometry import rotation
from freecad_cable.options import SolveOptions
from freecad_cable.problem import (
    Box,
    Cylinder,
    Mesh,
    Obstacle,
    Ring,
    Rod,
    Scene,
    Sphere,
    Swivel,
    round_section,
)
from freecad_cable.result import Solution

SCENES = 60
"""of each family"""
SEED = 5
LIMITED = SolveOptions(time_limit=20.0)
PATIENCE = 1.5 * LIMITED.time_limit
"""[s] after which the process of a solve is ended"""
FINER = 0.1
"""Tolerance of the answer that a true error is measured against, relative to that of the first"""
ANOTHER = 0.02
"""Distance, relative to the length, from which a finer answer is another equilibrium"""
HELD = 3.0
"""Places nearer than this to a held end, in radii, are not looked at: there its holder says where the cable is"""
SAMPLES = 40
"""Places looked at in a radius"""
LEFT_OUT = 0.01 + 1 / 128
"""Depth, in radii, that the solver leaves between nodes, and what an edge may enter between two of its samples"""


@dataclass(frozen=True)
class Drawn:
    """A scene and the number that it is drawn from."""

    family: str
    seed: int
    scene: Scene


@dataclass(frozen=True)
class Among:
    """One solve of one scene; errors relative to the length."""

    family: str
    seed: int
    status: str
    message: str = ""
    seconds: float | None = None
    """without the building of solvers, as far as it is known: not where a time limit struck"""
    elements: int | None = None
    contacts: int | None = None
    """places where the cable touches something"""
    rims: bool = False
    """whether the answer says that it enters the rim of a ring"""
    depth: float | None = None
    """in radii of the cable, largest of its surface in an obstacle; less than 0 where it keeps clear of all of them"""
    estimate: float | None = None
    finer: str = ""
    """how the finer solve ended that the true error is from; empty if none was asked for"""
    error: float | None = None
    """true; none where the finer solve did not succeed or led to another equilibrium"""
    finer_estimate: float | None = None
    """of the error of the finer answer, so of how well the true error is known"""


def scenes(number=SCENES) -> Iterator[Drawn]:
    """The same ones in every run; the first of each family are those of a shorter run."""
    for family, draw in FAMILIES.items():
        yield from islice(_drawn(family, draw), number)


def _drawn(family, draw: Callable[[np.random.Generator], Scene | None]):
    for seed in count():
        scene = draw(np.random.default_rng((SEED, seed)))
        if scene is not None:
            yield Drawn(family, seed, scene)


def plates(draw) -> Scene:
    """A cable through rings in 1 to 3 plates one behind the other, each ring in a hole as wide as it is."""
    radius = 0.5 * 10 ** draw.uniform(-3.0, -2.2)
    hole, thickness = radius * draw.uniform(1.3, 3.5), radius * draw.uniform(0.3, 3.0)
    pitch = radius * draw.uniform(30.0, 100.0)
    way = [np.zeros(3)]
    supports, obstacles = [], []
    for i in range(draw.integers(1, 4)):
        way.append(_beyond(draw, way, pitch))
        axis = draw.choice([1, 1, -1]) * _nearly(draw, X, 0.15)
        supports.append(Ring(way[-1], axis, hole, place=f"supports[{i}]"))
        # The ring is at one of the two rims of the hole.
        low = draw.choice([-thickness, 0.0])
        corners = draw.choice([16, 24, 32, 48])
        solid = plate(supports[-1], hole + 12 * radius, (low, low + thickness), corners)
        obstacles.append(Mesh(*solid, place=f"obstacles[{i}]"))
    way.append(_beyond(draw, way, pitch))
    shortest = np.linalg.norm(np.diff(way, axis=0), axis=1).sum()
    young = 10 ** draw.uniform(8.0, 10.0)
    section = round_section(2 * radius, young, 0.4 * young, 3000.0)
    hold = draw.choice([clamped, _swivel])
    return Scene(
        rod=Rod(length=shortest * (1 + 10 ** draw.uniform(-2.3, -0.7)), **section),
        start=hold(_nearly(draw, X, 0.3), "start", position=way[0]),
        end=hold(_nearly(draw, X, 0.3), "end", position=way[-1]),
        supports=supports,
        obstacles=obstacles,
        gravity=[0, 0, -GRAVITY],
        options=LIMITED,
    )


def plate(ring: Ring, half_width, heights, corners) -> tuple[np.ndarray, np.ndarray]:
    """(vertices (n, 3), triangles (t, 3)) of a square plate between two heights along the axis of a ring, with a hole
    that has so many corners on its circle."""
    angle = np.linspace(0, 2 * np.pi, corners, endpoint=False)
    circle = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    outline = circle / np.abs(circle).max(axis=1)[:, None]
    frame = rotation.matrix(rotation.from_tangent(ring.axis))
    loops = [
        ring.position + size * loop @ frame[:, :2].T + height * ring.axis
        for height in heights
        for size, loop in ((ring.radius, circle), (half_width, outline))
    ]
    here = np.arange(corners)
    after = np.roll(here, -1)
    triangles = []
    # Bottom, top, the wall of the hole and the sides: each a band between two of the loops.
    for a, b in np.multiply(corners, ((1, 0), (2, 3), (0, 2), (3, 1))):
        triangles.append(np.stack([a + here, b + here, a + after], axis=1))
        triangles.append(np.stack([b + here, b + after, a + after], axis=1))
    return np.concatenate(loops), np.concatenate(triangles)


def obstacles(draw) -> Scene | None:
    """A cable that would pass through 1 or 2 solids if they were not there; whether it is long enough to get past them
    is not asked. None if this draw has no such scene."""
    length, radius = 0.3, 0.0035
    along = _unit(draw.normal(size=3))
    chord = along * length * draw.uniform(0.45, 0.95)
    bending = 10 ** draw.uniform(-4.0, -2.0)
    free = Scene(
        rod=Rod(
            length=length,
            radius=radius,
            mass_per_length=0.04,
            bending_stiffness=bending,
            torsional_stiffness=bending * draw.uniform(0.4, 1.0),
        ),
        start=clamped(_nearly(draw, along, 0.8), "start", draw.uniform(-1, 1)),
        end=clamped(_nearly(draw, along, 0.8), "end", draw.uniform(-1, 1), chord),
        gravity=[0, 0, -GRAVITY],
        options=LIMITED,
    )
    solution = find_equilibrium(free)
    if not solution.status.success:
        return None
    shape = curve(solution)
    cable = shape(np.linspace(0, length, 1000))
    solids = []
    for i in range(draw.integers(1, 3)):
        center = shape(length * draw.uniform(0.2, 0.8)) + 0.015 * draw.normal(size=3)
        solids.append(_solid(draw, center, f"obstacles[{i}]"))
    met = all(solid.nearest(cable).distance.min() < radius for solid in solids)
    apart = all(solid.nearest(cable[[0, -1]]).distance.min() > HELD * radius for solid in solids)
    return replace(free, obstacles=solids) if met and apart else None


FAMILIES = {"plates": plates, "obstacles": obstacles}


def outcomes(drawn: Iterable[Drawn], every: int) -> Iterator[Among]:
    """A row for each, in order and one at a time; the true error of one in ``every``."""
    first = (TABLE_1[0].scene,)
    known = (find_equilibrium(*first),)
    with ExitStack() as stack:
        solve = stack.enter_context(Guarded(find_equilibrium, PATIENCE, first))
        truth = stack.enter_context(Guarded(true_error, PATIENCE, known))
        for number, each in enumerate(drawn):
            solve.ready()
            yield outcome(each, solve, None if number % every else truth)


def outcome(drawn: Drawn, solve=find_equilibrium, truth=None) -> Among:
    """``solve`` finds the equilibrium, ``truth`` the true error of one; those that may hang want to be guarded."""
    row, solution = answered(Among(drawn.family, drawn.seed, ""), drawn.scene, solve)
    if solution is None or solution.position is None:
        return row
    row = replace(
        row,
        contacts=len(solution.contacts),
        rims=any("rims of rings" in sentence for sentence in solution.left_out),
        depth=depth(solution),
        estimate=solution.position_error / drawn.scene.rod.length,
    )
    if truth is None or not solution.status.success:
        return row
    try:
        finer, apart, estimate = truth(solution)
    except Exception as error:  # noqa: BLE001  Whatever goes wrong with a problem is its row.
        return replace(row, finer=type(error).__name__)
    return replace(row, finer=finer, error=apart, finer_estimate=estimate)


def true_error(solution: Solution) -> tuple[str, float | None, float | None]:
    """How the same cable ends with a finer tolerance, and relative to the length the largest distance of a node from
    the finer curve and the finer estimate; none of both if that is no answer, or another."""
    scene = solution.scene
    options = replace(scene.options, tolerance=FINER * scene.options.tolerance)
    finer = find_equilibrium(replace(scene, options=options), start=solution)
    if not finer.status.success:
        return finer.status.name, None, None
    apart = np.linalg.norm(curve(finer)(solution.arc_length) - solution.position, axis=1)
    error = float(apart.max()) / scene.rod.length
    if error > ANOTHER:
        return finer.status.name, None, None
    return finer.status.name, error, finer.position_error / scene.rod.length


def depth(solution: Solution) -> float:
    """Largest, of the cable's surface in the obstacles, in its radii: from cubics through the nodes."""
    radius, length = solution.scene.rod.radius, solution.arc_length[-1]
    places = np.arange(HELD * radius, length - HELD * radius, radius / SAMPLES)
    cable = curve(solution)(places)
    nearest = min(solid.nearest(cable).distance.min() for solid in solution.scene.obstacles)
    return float(1 - nearest / radius)


def curve(solution: Solution) -> CubicHermiteSpline:
    """(3,) [m] at any arc length [m]"""
    tangent = rotation.tangent(solution.quaternion)
    return CubicHermiteSpline(solution.arc_length, solution.position, tangent)


def _solid(draw, center, place) -> Obstacle:
    kind = draw.choice(["box", "sphere", "cylinder", "thin plate"])
    turn = _unit(draw.normal(size=4))
    if kind == "box":
        return Box(center, turn, draw.uniform(0.01, 0.1, size=3), place=place)
    if kind == "sphere":
        return Sphere(center, draw.uniform(0.005, 0.04), place=place)
    if kind == "cylinder":
        half = _unit(draw.normal(size=3)) * draw.uniform(0.02, 0.1)
        return Cylinder(center - half, center + half, draw.uniform(0.003, 0.03), place=place)
    return Box(center, turn, [0.1, 0.1, 0.002], place=place)


def _swivel(tangent, place, position) -> Swivel:
    return Swivel(position, tangent, place=place)


def _beyond(draw, way, pitch):
    """The next point of a way along x, which strays from it by a part of the pitch."""
    return np.append(len(way) * pitch, 0.15 * pitch * draw.normal(size=2))


def _nearly(draw, direction, spread):
    return _unit(direction + spread * draw.normal(size=3))


def _unit(vector):
    return vector / np.linalg.norm(vector)
