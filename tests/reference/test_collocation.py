# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gauss–Legendre collocation of boundary value problems with known solutions."""

import math

import numpy as np
import pytest

from freecad_cable.reference.collocation import Collocated, Gauss, NoSolutionError, solve


def test_two_stages_are_hammer_and_hollingsworth():
    """Hairer, Nørsett and Wanner, Solving Ordinary Differential Equations I, table II.7.3."""
    gauss, root = Gauss.of(2), math.sqrt(3) / 6
    assert gauss.places == pytest.approx([0.5 - root, 0.5 + root], abs=1e-15)
    assert gauss.weights == pytest.approx([0.5, 0.5], abs=1e-15)
    expected = np.array([[0.25, 0.25 - root], [0.25 + root, 0.25]])
    assert np.abs(gauss.matrix - expected).max() < 1e-15


@pytest.mark.parametrize("stages", range(1, 8))
def test_integrals_are_exact_for_polynomials(stages):
    gauss = Gauss.of(stages)
    power = stages - 1
    values = gauss.places**power
    assert gauss.matrix @ values == pytest.approx(gauss.places**stages / stages, abs=1e-15)
    read = gauss.at(0.3, values[None, :, None])
    assert read == pytest.approx(0.3**stages / stages, abs=1e-15)
    # xᵏ⁻¹ on [0, 1] has the Legendre coefficient (k−1)!² / (2k−2)! of degree k−1.
    tail = math.factorial(power) ** 2 / math.factorial(2 * power)
    assert gauss.tail(values[None, :, None])[0, 0] == pytest.approx(tail, abs=1e-15)


def pendulum(y):
    """θ'' = −sin θ as y = (θ, θ')."""
    value = np.stack((y[..., 1], -np.sin(y[..., 0])), axis=-1)
    jacobian = np.zeros((*y.shape, 2))
    jacobian[..., 0, 1] = 1
    jacobian[..., 1, 0] = -np.cos(y[..., 0])
    return value, jacobian


def at(index, target):
    row = np.eye(2)[[index]]
    return lambda y: (y[[index]] - target, row)


def swing(elements, stages, target=1.0, guess=1.0):
    gauss = Gauss.of(stages)
    nodes = np.full((elements + 1, 2), guess)
    start = Collocated(
        np.linspace(0, 2, elements + 1), nodes, np.full((elements, stages, 2), guess)
    )
    return solve(pendulum, at(0, 0.0), at(0, target), start, gauss, np.ones(2))


@pytest.mark.parametrize("stages", [1, 2, 3])
def test_nodes_are_of_order_two_k(stages):
    """Halving the step divides the error by 4ᵏ; a tenth of a power is left for the next term."""
    exact = swing(64, 5).nodes[::16, 1]
    coarse, fine = swing(4, stages).nodes[:, 1], swing(8, stages).nodes[::2, 1]
    order = math.log2(np.abs(coarse - exact).max() / np.abs(fine - exact).max())
    assert order == pytest.approx(2 * stages, abs=0.1)


def test_energy_of_the_pendulum_is_kept():
    """Gauss keeps quadratic invariants only, but at order 10 the energy stays to rounding."""
    theta, speed = swing(32, 5).nodes.T
    energy = speed**2 / 2 - np.cos(theta)
    assert np.ptp(energy) < 1e-14


def test_a_family_of_solutions_gives_the_one_near_the_guess():
    """θ' = ω = const., only θ' is held: θ is free, and stays about where the guess has it."""

    def rate(y):
        jacobian = np.zeros((*y.shape, 2))
        jacobian[..., 0, 1] = 1
        return np.stack((y[..., 1], 0 * y[..., 1]), axis=-1), jacobian

    for guess in (0.0, 5.0):
        nodes, stages = np.full((9, 2), guess), np.full((8, 2, 2), guess)
        start = Collocated(np.linspace(0, 1, 9), nodes, stages)
        found = solve(rate, at(1, 3.0), at(1, 3.0), start, Gauss.of(2), np.ones(2), 1).nodes
        assert found[:, 1] == pytest.approx(3.0, abs=1e-12)
        assert found[:, 0].mean() == pytest.approx(guess, abs=1e-9)
        assert np.diff(found[:, 0]) == pytest.approx(3 / 8, abs=1e-12)


def test_no_solution_is_said():
    """θ' = θ² + 1 cannot go from 0 to 1 and stay below over a length of 10."""

    def rate(y):
        jacobian = np.zeros((*y.shape, 2))
        jacobian[..., 0, 0] = 2 * y[..., 0]
        return np.stack((y[..., 0] ** 2 + 1, 0 * y[..., 1]), axis=-1), jacobian

    nodes, stages = np.zeros((9, 2)), np.zeros((8, 2, 2))
    start = Collocated(np.linspace(0, 10, 9), nodes, stages)
    with pytest.raises(NoSolutionError):
        solve(rate, at(0, 0.0), at(1, 0.0), start, Gauss.of(2), np.ones(2))
