# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rods that may turn without anything changing: one of a family of solutions is found all the same."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from freecad_cable.geometry import curves, rotation
from freecad_cable.problem import Clamped, Free, Pinned, Rod, Scene, Swivel
from freecad_cable.reference.elastica import clamped_elastica, pinned_elastica
from freecad_cable.reference.held import symmetries
from freecad_cable.reference.strong_form import equilibrium

S = np.linspace(0, 1, 21)
HUMP = clamped_elastica(S, 0.5)


def end(kind, i, place):
    """What holds the node i of the hump between clamps on the x axis."""
    position, quaternion = HUMP.position[i], HUMP.quaternion[i]
    return {
        "clamped": lambda: Clamped(position, quaternion, place=place),
        "swivel": lambda: Swivel(position, (1, 0, 0), place=place),
        "pinned": lambda: Pinned(position, place=place),
        "free": lambda: Free(place=place),
    }[kind]()


def scene(start, end, weight=0.0, bending=1.0):
    rod = Rod(
        length=1.0,
        radius=1e-3,
        mass_per_length=weight,
        bending_stiffness=bending,
        torsional_stiffness=1.0,
    )
    return Scene(rod=rod, start=start, end=end, gravity=(0, 0, -1))


def start_from(position, quaternion):
    return SimpleNamespace(
        arc_length=S, position=position, quaternion=quaternion, force=None, moment=None
    )


def test_the_hump_between_clamps_on_one_line():
    """It may lie in any plane through the line, and its energy does not know which."""
    noise = np.random.default_rng(1).normal(scale=1e-3, size=(21, 7))
    quaternion = HUMP.quaternion + noise[:, 3:]
    quaternion /= np.linalg.norm(quaternion, axis=1, keepdims=True)
    problem = scene(end("clamped", 0, "start"), end("clamped", -1, "end"))
    found = equilibrium(problem, start_from(HUMP.position + noise[:, :3], quaternion)).at(S)
    height = np.hypot(found.position[:, 1], found.position[:, 2])
    assert np.abs(height - HUMP.position[:, 2]).max() < 1e-11
    assert found.energy.total == pytest.approx(HUMP.energy.total, rel=1e-12)


def test_a_figure_eight_pinned_in_one_point():
    """m = 0.826114765985, P = 21.549087443518 EI/L²; three turns and its spin are free."""
    state = pinned_elastica(S, 2 * math.asin(math.sqrt(0.826114765985)))
    noise = rotation.exponential(np.random.default_rng(6).normal(scale=1e-3, size=(21, 3)))
    pin = state.position[0]
    start = start_from(state.position, rotation.multiply(noise, state.quaternion))
    found = equilibrium(scene(Pinned(pin, place="start"), Pinned(pin)), start)
    pull = np.linalg.norm(found.force, axis=1)
    assert pull == pytest.approx(21.549087443518, abs=1e-9)  # m is given to 1e-12


def test_a_rod_on_swivels():
    """It may spin: its frames depend on the start, its centreline does not, and it carries no torque."""
    ends = Swivel((0, 0, 0), (1, 0, 0), place="start"), Swivel((0.6, 0.1, 0.2), (0, 1, 0))
    problem = scene(*ends, weight=400.0)
    curve = curves.hermite(0 * S[:3], (1, 0, 0), (0.6, 0.1, 0.2), (0, 1, 0), 1.0, (0, 0, -100))
    position, tangent = curve.at(S)
    frames = rotation.transport(rotation.from_tangent(tangent[0]), tangent)
    random, found = np.random.default_rng(5), []
    for _ in range(3):
        noise = rotation.exponential(random.normal(scale=1e-2, size=(21, 3)))
        turned = rotation.exponential((0, 0, random.uniform(-3, 3)))
        quaternion = rotation.multiply(rotation.multiply(frames, noise), turned)
        found.append(equilibrium(problem, start_from(position, quaternion)))
    for one in found:
        assert np.abs(one.at(S).position - found[0].at(S).position).max() < 1e-11
        torque = (one.moment * rotation.tangent(one.quaternion)).sum(axis=1)
        assert np.abs(torque).max() < 1e-10
    assert np.abs(found[0].quaternion[0] - found[1].quaternion[0]).max() > 0.01


@pytest.mark.parametrize(
    "count, first, last, weight, bending",
    [
        (0, "clamped", "clamped", 0, (1, 2)),
        (1, "clamped", "clamped", 0, 1),
        (0, "clamped", "clamped", 1, 1),
        (1, "clamped", "pinned", 0, 1),
        (2, "swivel", "pinned", 0, 1),
        (1, "swivel", "swivel", 0, (1, 2)),
        (1, "pinned", "pinned", 1, 1),
        (0, "pinned", "pinned", 1, (1, 2)),
        (1, "clamped", "free", 0, 1),
    ],
)
def test_how_many(count, first, last, weight, bending):
    """Ends on the x axis and held along it, weight along z; a load along y leaves the spin at most."""
    problem = scene(end(first, 0, "start"), end(last, -1, "end"), weight, bending)
    assert symmetries(problem, ()) == count
    spin = bending == 1 and first != "clamped"
    assert symmetries(problem, [np.array([0, 1, 0])]) == spin
