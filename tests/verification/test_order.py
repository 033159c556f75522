# SPDX-License-Identifier: LGPL-2.1-or-later
"""Observed order of convergence of each scheme, against the exact solver."""

import numpy as np
import pytest

from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.reference.strong_form import equilibrium

MESHES = {"helix": (32, 64, 128), "magnus": (16, 32, 64)}
ORDER = {"helix": 2, "magnus": 4}


@pytest.mark.parametrize("scheme", ["helix", "magnus"])
def test_order(table_1, scheme):
    errors, energies = [], []
    for elements in MESHES[scheme]:
        solution = find_equilibrium(table_1(0.73, scheme=scheme, elements=elements))
        exact = equilibrium(solution.scene, solution, tolerance=1e-12).at(solution.arc_length)
        errors.append(np.linalg.norm(solution.position - exact.position, axis=1).max())
        energies.append(abs(solution.energy.total - exact.energy.total))
    for series in (errors, energies):
        slopes = -np.diff(np.log2(series))
        assert slopes == pytest.approx(ORDER[scheme], abs=0.3)


def test_helix_elements_bound_the_energy_from_above(table_1, length):
    """They are a conforming Ritz method: no mesh can have less energy than the equilibrium."""
    exact = None
    for elements in (8, 16, 32):
        solution = find_equilibrium(table_1(length, scheme="helix", elements=elements))
        exact = exact or equilibrium(solution.scene, solution, tolerance=1e-12)
        assert solution.energy.total > exact.energy.total
