# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cubic splines through few nodes."""

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

from freecad_cable.geometry import cubic


@pytest.mark.parametrize("nodes", [2, 3, 4, 5, 33])
def test_as_scipy_has_them(nodes):
    draw = np.random.default_rng(nodes)
    x, y = np.cumsum(draw.uniform(0.2, 1.0, nodes)), draw.normal(size=(nodes, 2))
    spline = CubicSpline(x, y)
    # Condition numbers below a hundred, and rounding.
    assert cubic.slopes(x, y) == pytest.approx(spline(x, 1), abs=1e-12)
    fine = np.interp(np.arange(4 * nodes - 3) / 4, np.arange(nodes), x)
    assert cubic.between(x, y, 4) == pytest.approx(spline(fine), abs=1e-12)
