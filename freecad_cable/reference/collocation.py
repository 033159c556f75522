# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two-point boundary value problems y' = f(y) by Gauss–Legendre collocation and sparse Newton
steps.

Ascher, Mattheij and Russell, Numerical Solution of Boundary Value Problems (1995), chapters 5 and
7; the damping is Deuflhard's natural monotonicity test, chapter 8. k stages have order 2k at the
nodes and keep quadratic invariants, such as the norm of a quaternion.
"""

import math
from dataclasses import dataclass

import numpy as np
from numpy.polynomial import legendre
from scipy.sparse import bsr_matrix, csr_matrix, diags, eye, hstack, vstack
from scipy.sparse.linalg import splu

ORBIT = 1e-6
"""Singular value of the scaled matrix up to which it may belong to a symmetry: near a solution that
may turn freely it is of the size of the residual."""

MISSED = 1e-9
"""Largest residual that may be left because no correction on the orbits can remove it."""


class NoSolutionError(ArithmeticError):
    """Newton's method does not converge from this start."""


@dataclass(frozen=True, eq=False)
class Collocated:
    """A solution: mesh (n+1,), nodes (n+1, d) and stages (n, k, d)."""

    mesh: np.ndarray
    nodes: np.ndarray
    stages: np.ndarray


@dataclass(frozen=True, eq=False)
class Gauss:
    """The Runge–Kutta coefficients of k Gauss stages on [0, 1]."""

    places: np.ndarray
    """(k,)"""
    weights: np.ndarray
    """(k,)"""
    matrix: np.ndarray
    """(k, k) integrals of the Lagrange polynomials from 0 to the stages"""

    @classmethod
    def of(cls, stages: int) -> "Gauss":
        x, w = legendre.leggauss(stages)
        integrals = legendre.legval(x, legendre.legint(np.eye(stages), lbnd=-1)).T
        return cls((1 + x) / 2, w / 2, integrals / 2 @ _to_legendre(stages))

    def at(self, place, slopes):
        """∫ from 0 to ``place`` of the polynomial through the slopes (n, k, d): (n, d), for a unit step."""
        k = len(self.places)
        integrals = legendre.legval(2 * place - 1, legendre.legint(np.eye(k), lbnd=-1)) / 2
        return np.einsum("j,njd->nd", integrals @ _to_legendre(k), slopes)

    def tail(self, slopes):
        """(n,) the size of the last Legendre coefficient of the slopes (n, k, d)."""
        return np.abs(np.einsum("j,njd->nd", _to_legendre(len(self.places))[-1], slopes))


def _to_legendre(stages):
    """The matrix from values at the Gauss points to Legendre coefficients."""
    x, w = legendre.leggauss(stages)
    return (np.arange(stages)[:, None] + 0.5) * legendre.legvander(x, stages - 1).T * w


def solve(rate, start, end, guess: Collocated, gauss: Gauss, scale, symmetries=0) -> Collocated:
    """The solution near ``guess``.

    ``rate(y)`` (..., d) gives f and its Jacobian, ``start(y)`` and ``end(y)`` the conditions at the
    ends and theirs, together d; ``scale`` (d,) is the size of the unknowns. ``symmetries`` is the
    number of independent motions that take solutions to solutions; of such a family it finds the
    one near the guess. Errors: ``NoSolutionError``.
    """
    step = np.diff(guess.mesh)
    nodes, stages = guess.nodes, guess.stages

    def residuals(nodes, stages):
        slope = rate(stages)[0]
        return (
            start(nodes[0])[0],
            stages - nodes[:-1, None] - step[:, None, None] * (gauss.matrix @ slope),
            np.diff(nodes, axis=0) - step[:, None] * np.einsum("j,njd->nd", gauss.weights, slope),
            end(nodes[-1])[0],
        )

    damping = 1.0
    for _ in range(60):
        newton = _Newton(rate, start, end, nodes, stages, step, gauss, scale, symmetries)
        correction = newton.solve(residuals(nodes, stages))
        size = _size(correction, scale)
        while True:
            trial = nodes + damping * correction[0], stages + damping * correction[1]
            next_size = _size(newton.solve(residuals(*trial)), scale)
            stagnant = size < 1e-8 and next_size > size / 2
            if damping == 1.0 and (size < 1e-11 or stagnant):
                if newton.missed > MISSED:
                    raise NoSolutionError("the conditions at the ends contradict each other")
                return Collocated(guess.mesh, *trial)
            if next_size <= (1 - damping / 4) * size:
                break
            damping /= 2
            if damping < 1e-5:
                raise NoSolutionError(f"Newton's method stopped at a correction of {size:.1e}")
        nodes, stages = trial
        damping = min(1.0, 2 * damping)
    raise NoSolutionError(f"Newton's method did not end; its last correction was {size:.1e}")


def _size(correction, scale):
    return math.sqrt(max(np.mean((part / scale) ** 2) for part in correction))


class _Newton:
    """One linearisation, factored: stages are eliminated element by element, nodes solved together."""

    def __init__(self, rate, start, end, nodes, stages, step, gauss, scale, symmetries):
        n, k, d = stages.shape
        jacobian = rate(stages)[1]
        coupled = np.einsum("n,jl,nlab->njalb", step, gauss.matrix, jacobian)
        local = np.eye(k * d) - coupled.reshape(n, k * d, k * d)
        self.inverse = np.linalg.inv(local)
        self.spread = self.inverse @ np.tile(np.eye(d), (k, 1))
        self.sum = np.einsum("n,j,njab->najb", step, gauss.weights, jacobian).reshape(n, d, k * d)
        self.shape = n, k, d
        self.scale = np.tile(scale, n + 1)
        self._factor(start(nodes[0])[1], np.eye(d) + self.sum @ self.spread, end(nodes[-1])[1])
        self._find_orbits(symmetries)

    def _factor(self, first, transfer, last):
        n, _, d = self.shape
        size = (n + 1) * d
        elements = eye(n * d, size, k=d) - bsr_matrix(
            (transfer, np.arange(n), np.arange(n + 1)), shape=(n * d, size)
        )
        unscaled = vstack(
            (
                hstack((csr_matrix(first), csr_matrix((len(first), n * d)))),
                elements,
                hstack((csr_matrix((len(last), n * d)), csr_matrix(last))),
            )
        ) @ diags(self.scale)
        self.weight = abs(unscaled).max(axis=1).toarray().ravel()
        self.matrix = (diags(1 / self.weight) @ unscaled).tocsc()
        # An orbit of a symmetry makes the matrix singular; the shift lets it be factored all the
        # same.
        self.factors = splu((self.matrix + 1e-15 * eye(size)).tocsc())

    def _find_orbits(self, symmetries):
        """Bases of the null space, right and left, by inverse iteration."""
        size = len(self.weight)
        self.right = self.left = np.zeros((size, 0))
        if symmetries == 0:
            return
        left = np.linalg.qr(np.random.default_rng(0).normal(size=(size, symmetries)))[0]
        for _ in range(3):
            right = np.linalg.qr(self.factors.solve(left))[0]
            left = np.linalg.qr(self.factors.solve(right, trans="T"))[0]
        u, singular, v = np.linalg.svd(left.T @ (self.matrix @ right))
        null = singular < ORBIT
        self.right, self.left = right @ v[null].T, left @ u[:, null]

    def solve(self, residual):
        """The Newton correction of nodes and stages for a residual (start, stages, nodes, end)."""
        n, k, d = self.shape
        particular = -(self.inverse @ residual[1].reshape(n, k * d, 1))
        nodes = -residual[2] + (self.sum @ particular)[:, :, 0]
        rhs = np.concatenate((-residual[0], nodes.ravel(), -residual[3])) / self.weight
        outside = self.left @ (self.left.T @ rhs)
        self.missed = np.abs(outside).max()
        rhs = rhs - outside
        solution = self.factors.solve(rhs)
        solution += self.factors.solve(rhs - self.matrix @ solution)
        solution -= self.right @ (self.right.T @ solution)
        correction = (solution * self.scale).reshape(n + 1, d)
        stages = particular + self.spread @ correction[:-1, :, None]
        return correction, stages.reshape(n, k, d)
