# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed forms: each satisfies the equations of a rod, and has the numbers printed in the literature."""

import math

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

from freecad_cable.geometry import rotation
from freecad_cable.reference import buckling
from freecad_cable.reference.catenary import catenary, hanging_rod
from freecad_cable.reference.elastica import cantilever, clamped_elastica, pinned_elastica
from freecad_cable.reference.heavy import heavy_cantilever
from freecad_cable.reference.helix import helix, roll_up, twisted_rod

B, C = 2.0, 1.4
FINE = np.linspace(0, 1.5, 1501)
HELIX = {"bending_stiffness": B, "torsional_stiffness": C}

# state, weight per length, EA, (EI, GJ)
RODS = {
    "clamped": (clamped_elastica(FINE, 0.6, B), 0, math.inf, (B, C)),
    "clamped, ends crossed": (clamped_elastica(FINE, -0.3, B), 0, math.inf, (B, C)),
    "pinned": (pinned_elastica(FINE, 1.2, B), 0, math.inf, (B, C)),
    "cantilever": (cantilever(FINE, 5.0, B), 0, math.inf, (B, C)),
    "helix": (helix(FINE, 0.1, 8, 1.5, **HELIX), 0, math.inf, (B, C)),
    "helix, left-handed twist": (helix(FINE, 0.1, -5, -2.0, **HELIX), 0, math.inf, (B, C)),
    "roll-up": (roll_up(FINE, B), 0, math.inf, (B, C)),
    "twisted": (twisted_rod(FINE, 4.0, C), 0, math.inf, (B, C)),
    "heavy": (heavy_cantilever(FINE, 7.0, B), 7.0, math.inf, (B, C)),
    "catenary": (catenary(FINE, 1.0, 0.3, 2.0), 2.0, math.inf, (0, 0)),
    "elastic catenary": (catenary(FINE, 1.0, 0.3, 2.0, 20.0), 2.0, 20.0, (0, 0)),
    "elastic catenary, taut": (catenary(FINE, 1.51, 0.0, 2.0, 900.0), 2.0, 900.0, (0, 0)),
    "hanging": (hanging_rod(FINE, 2.0, 20.0), 2.0, 20.0, (0, 0)),
}

# The cubic spline's derivative errs by h³ y⁗/24 at its ends and less inside: h = 1e-3, and κ ≤ 20
# rad per length bounds the fourth derivative of tangents and positions by 20⁴ = 1.6e5, that of
# moments by EI κ⁴.
SLOPE = 1e-3**3 / 24 * 1.6e5


def slope(state, values):
    return CubicSpline(state.arc_length, values)(state.arc_length, 1)


@pytest.mark.parametrize("name", RODS)
def test_strains_and_balance(name):
    state, weight, axial, (bending, torsional) = RODS[name]
    frame = rotation.matrix(state.quaternion)
    tangent, along = frame[:, :, 2], slope(state, state.position)
    tension = (state.force * tangent).sum(axis=1)
    assert np.abs(along - tangent * (1 + tension / axial)[:, None]).max() < SLOPE
    assert np.abs(slope(state, state.force) + (0, 0, -weight)).max() < SLOPE
    assert np.abs(slope(state, state.moment) + np.cross(along, state.force)).max() < 10 * SLOPE
    spin = np.stack([slope(state, frame[:, :, i]) for i in range(3)], axis=2)
    material = frame.swapaxes(1, 2) @ spin
    curvature = np.stack((material[:, 2, 1], material[:, 0, 2], material[:, 1, 0]), axis=1)
    moment = (frame @ (curvature * (bending, bending, torsional))[:, :, None])[:, :, 0]
    assert np.abs(moment - state.moment).max() < 10 * SLOPE


@pytest.mark.parametrize("name", RODS)
def test_energy_is_the_integral_of_its_densities(name):
    """Against the integral of the spline through the samples: fourth order, h⁴ y⁗ L/100 < 1e-8."""
    state, weight, axial, (bending, torsional) = RODS[name]
    tangent = rotation.tangent(state.quaternion)
    torque = (state.moment * tangent).sum(axis=1)
    bent = (state.moment**2).sum(axis=1) - torque**2
    densities = {
        "bending": bent / (2 * bending or 1),
        "torsion": torque**2 / (2 * torsional or 1),
        "stretch": (state.force * tangent).sum(axis=1) ** 2 / (2 * axial),
        "gravity": weight * (state.position[:, 2] - state.position[0, 2]),
    }
    for kind, density in densities.items():
        integral = CubicSpline(FINE, density).integrate(0, FINE[-1])
        assert getattr(state.energy, kind) == pytest.approx(integral, abs=1e-8)


@pytest.mark.parametrize(
    "load, down, back, angle",
    [
        (1, 0.301720773800, 0.056433236283, 0.461351949712),
        (2, 0.493457480397, 0.160641720825, 0.781749831557),
        (5, 0.713791523612, 0.387628360724, 1.215368117612),
        (10, 0.810609024880, 0.554995597754, 1.430285538804),
    ],
)
def test_cantilever_of_bisshopp_and_drucker(load, down, back, angle):
    """Tabulated by Mattiasson, Int. J. Numer. Meth. Eng. 17 (1981) 145–153; further digits from the integrals."""
    state = cantilever(np.array([0.0, 0.5, 1.0]), load)
    assert state.position[-1] == pytest.approx([1 - back, 0, -down], abs=2e-12)
    tip = rotation.tangent(state.quaternion)[-1]
    assert math.atan2(-tip[2], tip[0]) == pytest.approx(angle, abs=2e-12)
    assert state.force[-1] == pytest.approx([0, 0, -load], abs=1e-12)
    assert state.moment[-1] == pytest.approx([0, 0, 0], abs=1e-12)


def test_clamped_elastica_of_half_the_length():
    state = clamped_elastica(np.array([0.0, 0.5, 1.0]), 0.5)
    assert state.position[-1] == pytest.approx([0.5, 0, 0], abs=1e-14)
    assert state.position[1] == pytest.approx([0.25, 0, 0.373306427445], abs=1e-12)
    assert state.force[0] == pytest.approx([-53.274112596243, 0, 0], abs=1e-11)
    assert state.moment[0] == pytest.approx([0, -9.943784324309, 0], abs=1e-11)
    assert state.energy.total == pytest.approx(22.802367046062, abs=1e-11)


def test_pinned_elastica_that_leaves_at_a_right_angle():
    """Its energy is 2π EI/L."""
    state = pinned_elastica(np.array([0.0, 0.5, 1.0]), math.pi / 2)
    assert state.position[-1] == pytest.approx([0.456946581044, 0, 0], abs=1e-12)
    assert state.position[1, 2] == pytest.approx(0.381379881751, abs=1e-12)
    assert state.force[0] == pytest.approx([-13.750371636041, 0, 0], abs=1e-11)
    assert state.energy.total == pytest.approx(2 * math.pi, rel=1e-14)


def test_roll_up_closes():
    state = roll_up(np.linspace(0, 1, 5))
    assert np.abs(state.position[-1] - state.position[0]).max() < 1e-15
    assert state.energy.total == pytest.approx(2 * math.pi**2, rel=1e-15)


@pytest.mark.parametrize(
    "rise, axial, pull, tension",
    [
        (0.0, math.inf, 0.308236469736, 0.810869731384),
        (0.3, math.inf, 0.316905698276, None),
        (0.0, 20.0, 0.292923300451, None),
        (0.3, 20.0, 0.299753182211, 0.953977002848),
    ],
)
def test_catenary_of_one_and_a_half(rise, axial, pull, tension):
    """Span 1, length 1.5, weight 1: horizontal force, and tension at the end; Irvine's equations by root finding."""
    state = catenary(np.array([0.0, 0.75, 1.5]), 1.0, rise, 1.0, axial)
    assert state.force[:, 0] == pytest.approx([pull] * 3, abs=1e-12)
    assert state.position[-1] == pytest.approx([1, 0, rise], abs=1e-12)
    if tension is not None:
        assert np.linalg.norm(state.force[-1]) == pytest.approx(tension, abs=1e-12)


@pytest.mark.parametrize(
    "load, x, drop",
    [
        (1, 0.991246395347, 0.123471401983),
        (10, 0.656353761239, 0.700199715514),
        (100, 0.159223382628, 0.937523935396),
        (1000, 0.045986454757, 0.981141269269),
    ],
)
def test_heavy_cantilever(load, x, drop):
    """Tip by another method: strong-form collocation of the spatial rod, order ten."""
    state = heavy_cantilever(np.array([0.0, 1.0]), load)
    assert state.position[-1] == pytest.approx([x, 0, -drop], abs=2e-12)


@pytest.mark.parametrize("load", [1e-3, 10, 1e4])
def test_heavy_cantilever_error_is_as_stated(load, monkeypatch):
    s = np.linspace(0, 1, 11)
    state = heavy_cantilever(s, load)
    monkeypatch.setattr("freecad_cable.reference.heavy.POINTS", 320)
    finer = heavy_cantilever(s, load)
    assert np.abs(state.position - finer.position).max() <= state.error


def test_greenhill_columns():
    """(9/4) j², j = 1.866350858873 the first zero of J₋₁/₃."""
    assert buckling.self_weight() == pytest.approx(9 / 4 * 1.866350858873**2, rel=1e-11)
    assert buckling.self_weight(2.0, 3.0) == pytest.approx(
        buckling.self_weight() * 3 / 8, rel=1e-14
    )


def test_twist_buckling():
    """Without tension tan x = x with x = M L/2EI; a long rod buckles at 2 √(T EI)."""
    torque = buckling.twist()
    assert math.tan(torque / 2) == pytest.approx(torque / 2, rel=1e-11)
    assert buckling.twist(20.0) == pytest.approx(11.800329535425, rel=1e-12)
    assert buckling.twist(400.0) == pytest.approx(40.496233340246, rel=1e-12)
    assert buckling.twist(1e6) == pytest.approx(2e3, rel=1e-5)
    scaled = buckling.twist(20.0 * 3 / 4, 2.0, 3.0)
    assert scaled == pytest.approx(buckling.twist(20.0) * 3 / 2, rel=1e-13)


def test_states_are_known_at_their_arc_lengths_only():
    state = roll_up(np.linspace(0, 1, 5))
    assert state.at([0.25, 1.0]).position.tolist() == state.position[[1, 4]].tolist()
    with pytest.raises(ValueError, match="arc lengths"):
        state.at([0.3])
