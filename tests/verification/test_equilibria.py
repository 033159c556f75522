# SPDX-License-Identifier: LGPL-2.1-or-later
"""The stable equilibria of the seed paper's Table 1, against a search that shares nothing with ours: 18 pose homotopies
and 80 random starts of an exact boundary value solver a case; energies in J from the start point."""

from dataclasses import replace

import numpy as np
import pytest

from freecad_cable.equilibrium import find_equilibria

KNOWN = {
    (0.55, "z"): (0.050928978775, 0.1327909145, 0.1878665567),
    (0.64, "z"): (0.052127358827, 0.1114970100, 0.1137033824),
    (0.73, "z"): (0.050253567709, 0.0938544534),
    (0.82, "z"): (0.045556855607, 0.0785790621),
    (0.64, "y"): (-0.037325654915, 0.0105576434),
}


@pytest.mark.parametrize("case", KNOWN, ids=str)
def test_all_known_equilibria_are_found(table_1, case):
    length, axis = case
    gravity = (0.0, 0.0, -9.81) if axis == "z" else (0.0, -9.81, 0.0)
    found = find_equilibria(replace(table_1(length), gravity=gravity))
    assert all(solution.status.success and solution.stable for solution in found)
    energies = [solution.energy.total for solution in found]
    # A position error of 1e-4 L changes an energy by its square, and by more where a loop is tight.
    assert energies == pytest.approx(KNOWN[case], abs=2e-4 * np.abs(KNOWN[case]).max())
