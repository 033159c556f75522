# SPDX-License-Identifier: LGPL-2.1-or-later
"""The seed paper's Table 1 (Du, Jiang, Xiong, Sci Rep 12, 2022) as a fixture: one cable, four lengths. And how far an
answer is from a better one."""

import numpy as np
import pytest
from scipy.interpolate import CubicHermiteSpline

from freecad_cable.geometry import rotation
from freecad_cable.options import SolveOptions
from freecad_cable.problem import Clamped, Rod, Scene, round_section


@pytest.fixture(params=(0.55, 0.64, 0.73, 0.82))
def length(request):
    """[m]"""
    return request.param


@pytest.fixture
def table_1():
    """Radius 3.5 mm, 1160 kg/m³ (the paper's 1.16 kg/cm³ read as g/cm³), E = 10 MPa, G = 20 MPa."""

    def scene(length=0.73, **options):
        return Scene(
            rod=Rod(length=length, **round_section(0.007, 10e6, 20e6, 1160.0)),
            start=Clamped([0, 0, 0], [0.7071, 0.7071, 0, 0], place="start"),
            end=Clamped([0.16, -0.235, 0.33], [0.5, 0.5, 0.5, 0.5]),
            gravity=[0, 0, -9.81],
            options=SolveOptions(**options),
        )

    return scene


@pytest.fixture
def distance():
    """Largest distance [m] of a node of a solution from its place on a better one, whose mesh is another."""

    def from_better(solution, best):
        frames = rotation.tangent(best.quaternion)
        place = CubicHermiteSpline(best.arc_length, best.position, frames)(solution.arc_length)
        return np.linalg.norm(place - solution.position, axis=1).max()

    return from_better
