# SPDX-License-Identifier: LGPL-2.1-or-later
"""The seed paper's Table 1 (Du, Jiang, Xiong, Sci Rep 12, 2022) as a fixture: one cable, four lengths."""

import pytest

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
