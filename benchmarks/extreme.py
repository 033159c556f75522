# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scenes at the edge of what a cable can be, by family, and random ones.

Unless a family says otherwise: EI = L = 1 (so the weight per length is the ratio w L³/EI), GJ = 0.8, both ends
clamped, gravity along −z, the chord along x, and end tangents nearly along it but in no plane (``cases.TILTED``).
"""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product

import numpy as np

from benchmarks.cases import GRAVITY, TILTED
from freecad_cable.geometry import rotation
from freecad_cable.problem import Clamped, Free, Pinned, Rod, Scene, Swivel

X, Y, Z = np.eye(3)

WEIGHTS = (0.0, 1.0, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7)
LENGTHS = (1.00001, 1.0001, 1.001, 1.01, 1.1, 1.5, 2.0, 5.0, 20.0, 50.0)
"""Length over chord."""
STIFFNESS_RATIOS = (1e-4, 1e-3, 1e-2, 0.1, 1.0, 10.0, 1e2, 1e3, 1e4)
STRETCHES = (1e1, 1e2, 1e3, 1e4, 1e6, 1e8, 1e10, 1e12)
"""EA L²/EI"""
METRES = (1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0, 1e3)
RANDOM = 1000


@dataclass(frozen=True)
class Extreme:
    """``row`` and ``column`` name its cell in the picture of its family."""

    family: str
    row: str
    column: str
    scene: Scene


def rod(weight=0.0, length=1.0, bending=1.0, **section) -> Rod:
    """``weight``: w L³/EI; ``length`` [m]; ``bending`` (EI) [N m²]."""
    usual = {"bending_stiffness": bending, "torsional_stiffness": 0.8 * bending}
    mass = weight * bending / length**3 / GRAVITY
    # So thin that a bend as sharp as mechanics makes it never runs through itself.
    return Rod(length=length, radius=1e-9 * length, mass_per_length=mass, **(usual | section))


def clamped(tangent, place, turn=0.0, position=(0, 0, 0)) -> Clamped:
    """``turn`` [rad] about the tangent."""
    frame = rotation.multiply(
        rotation.from_tangent(np.asarray(tangent, float)),
        np.array([np.cos(turn / 2), 0, 0, np.sin(turn / 2)]),
    )
    return Clamped(position, frame, place=place)


def tilted(length_ratio, cable: Rod, tangents=TILTED, turn=0.0) -> Scene:
    chord = cable.length / length_ratio if length_ratio else 0.0
    first, last = tangents
    return Scene(
        rod=cable,
        start=clamped(first, "start"),
        end=clamped(last, "end", turn, [chord, 0, 0]),
    )


def families() -> Iterator[Extreme]:
    """All of them, in the order of the pictures."""
    for ratio, weight in product(LENGTHS, WEIGHTS):
        yield Extreme("weight", f"{ratio:g}", f"{weight:g}", tilted(ratio, rod(weight)))
    for (name, tangents), weight in product(_closed().items(), (0.0, 10.0, 1e3, 1e5)):
        yield Extreme("chord 0", name, f"{weight:g}", tilted(None, rod(weight), tangents))
    for (name, tangents), ratio, weight in product(
        _turned().items(), (1.01, 1.2, 3.0), (0.0, 30.0, 3e3)
    ):
        column = f"{ratio:g}, {weight:g}"
        yield Extreme("orientation", name, column, tilted(ratio, rod(weight), tangents))
    for turns, ratio, weight in product(
        (-3, -2, -1, -0.5, 0.5, 1, 2, 3), (1.01, 1.2, 2.0), (0.0, 30.0)
    ):
        # A clamp does not count turns; a rod that is straight when twisted does.
        twisted = rod(weight, natural_curvature=(0, 0, 2 * np.pi * turns))
        yield Extreme("twist", f"{turns:g}", f"{ratio:g}, {weight:g}", tilted(ratio, twisted))
    for ratio, length_ratio in product(STIFFNESS_RATIOS, (1.05, 1.5, 3.0)):
        cable = rod(30.0, torsional_stiffness=ratio)
        scene = tilted(length_ratio, cable, turn=1.5)
        yield Extreme("GJ/EI", f"{length_ratio:g}", f"{ratio:g}", scene)
        cable = rod(30.0, bending_stiffness=(ratio**0.5, ratio**-0.5))
        scene = tilted(length_ratio, cable, turn=1.5)
        yield Extreme("EI1/EI2", f"{length_ratio:g}", f"{ratio:g}", scene)
    for stretch, ratio, weight in product(STRETCHES, (0.95, 0.999, 1.0001, 1.2), (1.0, 1e3)):
        if ratio > 1 or (1 - ratio) * stretch < 1e6:  # a pull that no cable bears
            scene = tilted(ratio, rod(weight, axial_stiffness=stretch))
            yield Extreme("EA L²/EI", f"{ratio:g}, {weight:g}", f"{stretch:g}", scene)
    for metres, weight in product(METRES, (0.0, 30.0, 1e4)):
        scene = tilted(1.2, rod(weight, length=metres, bending=1e-3))
        yield Extreme("metres", f"{weight:g}", f"{metres:g}", scene)
    for (first, last), weight, ratio in product(_held(), (0.0, 30.0, 1e4), (1.05, 2.0)):
        if weight == 0 and "free" in (first, last):
            continue  # straight, whatever its length
        name = f"{first}, {last}"
        scene = _ends(first, last, ratio, rod(weight))
        yield Extreme("ends", name, f"{weight:g}, {ratio:g}", scene)


def _closed():
    """Tangents at the start and at the end of a cable whose ends meet."""
    return {"same": (X, X), "opposite": (X, -X), "across": (X, Z), "askew": (X, (0.2, 0.9, -0.4))}


def _turned():
    return {
        "collinear": (X, X),
        "parallel": (Z, Z),
        "away": (-X, -X),
        "antiparallel up": (Z, -Z),
        "antiparallel down": (-Z, Z),
        "facing": (X, -X),
        "back to back": (-X, X),
        "at right angles": (X, Y),
        "askew": (Y, Z),
    }


def _held():
    """Ends that hold a cable."""
    kinds = ("clamped", "swivel", "pinned", "free")
    for first, last in product(kinds, kinds):
        if "free" in (first, last) and {"clamped", "swivel", "pinned"}.isdisjoint((first, last)):
            continue
        yield first, last


def _ends(first, last, ratio, cable):
    places = ([0, 0, 0], [cable.length / ratio, 0, 0])
    return Scene(
        rod=cable,
        start=_end(first, places[0], TILTED[0], "start"),
        end=_end(last, places[1], TILTED[1], "end"),
    )


def _end(kind, position, tangent, place):
    if kind == "clamped":
        return clamped(tangent, place, position=position)
    if kind == "swivel":
        return Swivel(position, tangent, place=place)
    return Pinned(position, place=place) if kind == "pinned" else Free()


def random_scenes(count=RANDOM, seed=4) -> Iterator[Extreme]:
    """The same ones in every run; the first of them are those of a shorter run."""
    for k in range(count):
        draw = np.random.default_rng((seed, k))
        cable = rod(
            _log(draw, 1e-2, 1e5),
            length=_log(draw, 1e-2, 1e2),
            bending=_log(draw, 1e-5, 1e3),
        )
        section = {"torsional_stiffness": cable.bending_stiffness[0] * _log(draw, 0.05, 20)}
        if draw.random() < 0.3:
            bend = cable.bending_stiffness[0] * np.array([1.0, _log(draw, 0.05, 20)])
            section["bending_stiffness"] = tuple(bend)
        if draw.random() < 0.3:
            section["natural_curvature"] = tuple(draw.normal(size=3) * 2 / cable.length)
        cable = Rod(
            **{
                "length": cable.length,
                "radius": cable.radius,
                "mass_per_length": cable.mass_per_length,
                "bending_stiffness": tuple(cable.bending_stiffness),
                "torsional_stiffness": cable.torsional_stiffness,
            }
            | section
        )
        chord = cable.length / (1 + _log(draw, 1e-3, 20))
        way = _direction(draw)
        first, last = (str(kind) for kind in draw.choice(["clamped", "swivel", "pinned"], 2))
        scene = Scene(
            rod=cable,
            start=_end(first, [0, 0, 0], _direction(draw), "start"),
            end=_end(last, chord * way, _direction(draw), "end"),
        )
        yield Extreme("random", f"{k // 50}", f"{k}", scene)


def _log(draw, low, high):
    return float(np.exp(draw.uniform(np.log(low), np.log(high))))


def _direction(draw):
    vector = draw.normal(size=3)
    return vector / np.linalg.norm(vector)
