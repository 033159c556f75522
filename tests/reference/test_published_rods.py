# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rods without a closed form, whose numbers were published or found by other codes."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from freecad_cable.geometry import curves, rotation
from freecad_cable.problem import Clamped, Free, Pinned, Rod, Scene, round_section
from freecad_cable.reference.catenary import catenary
from freecad_cable.reference.strong_form import equilibrium

START = {"place": "start"}


def bent_arc(load, **rod):
    """Bathe and Bolourchi's 45° arc: radius 100, section 1 × 1, E = 10⁷, G = E/2, J = 1/6; load on the tip in z."""
    angle = np.linspace(0, math.pi / 4, 21)
    zero = np.zeros_like(angle)
    centre = np.stack((np.sin(angle), 1 - np.cos(angle), zero), axis=1) * 100
    about_z = rotation.exponential(np.stack((zero, zero, angle), axis=1))
    # d3 = x, d1 = z: the natural curvature is about d1.
    first = [0, math.sqrt(0.5), 0, math.sqrt(0.5)]
    state = SimpleNamespace(
        arc_length=100 * angle,
        position=centre,
        quaternion=rotation.multiply(about_z, first),
    )
    rod = Rod(
        length=100 * math.pi / 4,
        radius=0.5,
        mass_per_length=0,
        bending_stiffness=1e7 / 12,
        torsional_stiffness=1e7 / 12,
        natural_curvature=(0.01, 0, 0),
        **rod,
    )
    problem = Scene(rod=rod, start=Clamped((0, 0, 0), first, **START), end=Free())
    for part in np.linspace(0.2, 1, 5) * load:
        force = np.array([0, 0, part])
        state.force = np.tile(force, (21, 1))
        state.moment = np.cross(state.position[-1] - state.position, force)
        found = equilibrium(problem, state, end_force=force)
        state.position = found.at(state.arc_length).position
        state.quaternion = found.at(state.arc_length).quaternion
    return found.position[-1]


def test_bent_arc_out_of_plane():
    """The published tips scatter by 0.5 %; these digits are another strong-form code's, and a
    finite element code of fourth order converges to them."""
    soft = {"axial_stiffness": 1e7, "shear_stiffness": 5e6}
    assert bent_arc(600, **soft) == pytest.approx(
        [47.1504385736, 15.6848005340, 53.4748587918], abs=1e-9
    )
    assert bent_arc(300, **soft) == pytest.approx(
        [58.7791224897, 22.2447809454, 40.1918916702], abs=1e-9
    )
    assert bent_arc(600) == pytest.approx([47.1512944003, 15.6850781622, 53.4685984423], abs=1e-9)


# length: energy [J], smallest bend radius [m], force [N] and moment [N m] at the end, middle [m]
TABLE = {
    "-z": {
        0.55: (0.050928978775, 0.059790156, (-0.0573997, 0.0451486, 0.1345188)),
        0.64: (0.052127358827, 0.054239745, (-0.0563825, 0.0448441, 0.1559586)),
        0.73: (0.050253567709, 0.050743386, (-0.0497237, 0.0423163, 0.1865051)),
        0.82: (0.045556855607, 0.048178894, (-0.0435621, 0.0400347, 0.2173700)),
    },
    "-y": {
        0.55: (-0.025017422117, 0.092455388, (-0.0678755, 0.1501311, 0.0178706)),
        0.64: (-0.037325654915, 0.073485328, (-0.0726346, 0.1560141, 0.0114904)),
        0.73: (-0.052693004759, 0.064969148, (-0.0677570, 0.1589658, 0.0113582)),
        0.82: (-0.070718369586, 0.059920046, (-0.0619724, 0.1652434, 0.0112447)),
    },
}


@pytest.mark.parametrize("down", TABLE)
def test_cable_of_du_et_al(down):
    """The four cables of table 1 of Du et al. (2022), 7 mm thick, E = 10 MPa, G = 20 MPa, 1160
    kg/m³.

    The lowest equilibria, to all digits that another strong-form code printed of them. It gets from
    one length to the next in steps.
    """
    section = round_section(0.007, 1e7, 2e7, 1160)
    stiffness = section["bending_stiffness"]
    held = {
        "start": Clamped((0, 0, 0), (0.7071, 0.7071, 0, 0), **START),
        "end": Clamped((0.16, -0.235, 0.33), (0.5, 0.5, 0.5, 0.5)),
    }
    gravity = np.array({"-z": (0, 0, -9.81), "-y": (0, -9.81, 0)}[down])
    state = transported(held, 0.55)
    for length in (0.55, 0.58, 0.61, 0.64, 0.67, 0.7, 0.73, 0.76, 0.79, 0.82):
        state.arc_length = state.arc_length * (length / state.arc_length[-1])
        problem = Scene(rod=Rod(length=length, **section), **held, gravity=gravity)
        found = equilibrium(problem, state)
        state = shape_of(found, state.arc_length)
        if length not in TABLE[down]:
            continue
        energy, radius, force = TABLE[down][length]
        assert found.energy.total == pytest.approx(energy, abs=0.6e-12)
        assert found.force[-1] == pytest.approx(force, abs=0.6e-7)
        bent = np.cross(found.moment, rotation.tangent(found.quaternion))
        tightest = np.linalg.norm(bent, axis=1).max() / stiffness
        assert 1 / tightest == pytest.approx(radius, abs=0.6e-9)


def shape_of(found, arc_length):
    there = found.at(arc_length)
    return SimpleNamespace(
        arc_length=arc_length,
        position=there.position,
        quaternion=there.quaternion,
        force=None,
        moment=None,
    )


def transported(held, length):
    """A curve of the length between the ends, with a frame carried along, turned evenly into the end."""
    start, end = held["start"], held["end"]
    tangents = rotation.tangent(start.quaternion), rotation.tangent(end.quaternion)
    curve = curves.hermite(start.position, tangents[0], end.position, tangents[1], length)
    s = np.linspace(0, length, 31)
    position, tangent = curve.at(s)
    frames = rotation.transport(start.quaternion, tangent)
    missing = rotation.logarithm(rotation.multiply(rotation.conjugate(frames[-1]), end.quaternion))
    return SimpleNamespace(
        arc_length=s,
        position=position,
        quaternion=rotation.multiply(frames, rotation.exponential(s[:, None] / length * missing)),
        force=None,
        moment=None,
    )


def little_stiffness(start, end, bending):
    rod = Rod(
        length=1.5,
        radius=1e-3,
        mass_per_length=1.0,
        bending_stiffness=bending,
        torsional_stiffness=bending,
    )
    return Scene(rod=rod, start=start, end=end, gravity=(0, 0, -1))


def test_catenary_with_little_stiffness():
    """Span 1, length 1.5, weight 1, on pins and on horizontal clamps, where it has layers of width √(EI/T)."""
    s = 0.75 * (1 - np.cos(np.linspace(0, math.pi, 41)))
    state = catenary(s, 1.0, 0.0, 1.0)
    pins = Pinned((0, 0, 0), **START), Pinned((1, 0, 0))
    found = equilibrium(little_stiffness(*pins, 1e-4), state)
    assert found.force[:, 0] == pytest.approx(0.307620406504, abs=1e-11)
    steep = math.atan(state.force[-1, 2] / state.force[-1, 0])
    for angle in steep * np.array([0.75, 0.5, 0.25, 0]):
        down, up = math.pi / 4 + angle / 2, math.pi / 4 - angle / 2
        clamps = (
            Clamped((0, 0, 0), (math.cos(down), 0, math.sin(down), 0), **START),
            Clamped((1, 0, 0), (math.cos(up), 0, math.sin(up), 0)),
        )
        found = equilibrium(little_stiffness(*clamps, 1e-3), found.at(s))
    assert found.force[:, 0] == pytest.approx(0.254975088552, abs=1e-11)
    assert found.position[:, 2].min() == pytest.approx(-0.503280078797, abs=1e-11)
    assert np.abs(found.moment[0]) == pytest.approx([0, 0.031932441756, 0], abs=1e-11)
