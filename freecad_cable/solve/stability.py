# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether an equilibrium is a minimum: the second variation of the energy on admissible variations.

Two readings of the same Hessian. ``proven`` adds a penalty on all rows that hold: if that matrix, a band, has a
Cholesky factor, the second variation is positive (Finsler's lemma), and most answers pass. Where it has none,
``lowest_mode`` decides by the smallest eigenvalue and gives the variation that leaves a saddle.
"""

from functools import lru_cache

import casadi as ca
import numpy as np
from scipy.linalg import eigh, null_space, qr
from scipy.linalg.lapack import dpbtrf
from scipy.sparse import csr_matrix

from ..transcription.nlp import Nlp, build
from ..transcription.numeric import Numeric

ZERO = 1e-6
"""Smallest eigenvalue, relative to the largest, that counts as negative below. A circle of solutions
(a symmetric cable that may turn) has eigenvalues of about 1e-12; an unstable cable a step past its critical
load has more than this in all cases of the tests."""
PENALTY = 1e8
"""On the rows that hold, against elastic energies of order one; larger values lose digits, smaller ones prove less (of
144 scenes of `benchmarks/extreme.py`, 1e6 left ten more to ``lowest_mode`` than 1e8, and 1e9 two fewer)."""


def proven(nlp: Nlp, x, parameters, multipliers, acting) -> bool:
    """Whether the second variation is shown to be positive; False proves nothing. ``acting`` (rows,): the rows that
    hold; the others are bounds that do not act."""
    if nlp.structure.links:
        return False
    evaluate, places, width = _penalised(nlp.structure)
    # Next states in their own scale: the gap of a soft strain counts as much as that of a stiff one.
    stiffness = parameters[list(nlp.structure.strains)]
    weights = np.where(acting, PENALTY, 0.0) * np.append(1.0, stiffness)[nlp.strains_carried]
    band = np.zeros((len(x), width))
    (band.reshape(-1)[places],) = evaluate(x, parameters, multipliers, weights)
    return dpbtrf(band.T, lower=1, overwrite_ab=1)[1] == 0


@lru_cache(maxsize=64)
def _penalised(structure):
    """Function (x, p, λ, weights of rows) → nonzeros of the lower triangle of the Hessian of the Lagrangian with a
    penalty on rows, where they go in a band, column by column, and its width."""
    nlp = build(structure)
    factor, lam = nlp.multipliers
    weights = ca.MX.sym("w", lam.shape)
    matrix = nlp.hessian + nlp.jacobian.T @ ca.diag(weights) @ nlp.jacobian
    matrix = ca.substitute(ca.tril(matrix), factor, 1)
    rows, columns = (np.array(index) for index in matrix.sparsity().get_triplet())
    function = ca.Function("penalised", [nlp.x, nlp.p, lam, weights], [matrix.nz[:]])
    width = int((rows - columns).max()) + 1
    return Numeric(function), width * columns + rows - columns, width


def _scale(nlp, parameters):
    """Of the variables: 1/√stiffness of strains. Then all elastic energies are alike, and one stiff in stretch or twist
    does not hide another that buckles."""
    softness = 1 / np.sqrt(parameters[list(nlp.structure.strains)])
    return np.where(nlp.numbers.strain_of >= 0, softness[nlp.numbers.strain_of], 1.0)


class SecondVariation:
    """Hessian and Jacobian of a converged program as dense blocks, one a stage, scaled (see ``_scale``)."""

    def __init__(self, nlp: Nlp, x, parameters, multipliers, acting):
        """``acting`` as for ``proven``."""
        values = nlp.second_variation(x, parameters, 1.0, multipliers)
        hessian, jacobian = (
            (*place, value) for place, value in zip(nlp.places, values, strict=True)
        )
        self.nx, self.nu, ng = (np.array(column) for column in zip(*nlp.stage_sizes, strict=True))
        self.scale = _scale(nlp, parameters)
        self.columns = np.concatenate([[0], np.cumsum(self.nx + self.nu)])
        self.gaps = np.append(self.nx[1:], 0)
        rows = nlp.row_starts
        jacobian = (*jacobian[:2], np.where(acting[jacobian[0]], jacobian[2], 0.0))
        self.links = self.coupling = None
        if nlp.structure.links:
            jacobian, hessian = self._linked(jacobian, hessian, rows[-1], len(nlp.equality))
        self.rows = self._blocks(*jacobian, rows, np.diff(rows).max())
        self.curvature = self._blocks(*hessian, self.columns, (self.nx + self.nu).max())
        self.sides = ng

    def _linked(self, jacobian, hessian, first, height):
        """Takes out what couples distant stages: the rows of links, and the Hessian between stages."""
        (i, j, slope), (row, col, bent) = jacobian, hessian
        there, size = i >= first, self.columns[-1]
        scaled = slope * self.scale[j], bent * self.scale[row] * self.scale[col]
        self.links = csr_matrix(
            (scaled[0][there], (i[there] - first, j[there])), (height - first, size)
        )
        stages = [np.searchsorted(self.columns, each, "right") for each in (row, col)]
        across = stages[0] != stages[1]
        self.coupling = csr_matrix((scaled[1][across], (row[across], col[across])), (size, size))
        return tuple(a[~there] for a in jacobian), tuple(a[~across] for a in hessian)

    def _blocks(self, row, col, values, starts, height):
        """(stages, height, width): each stage's rows over its own variables and the next stage's state."""
        blocks = np.zeros((len(self.nx), height, 2 * self.nx.max() + self.nu.max()))
        stage = np.searchsorted(starts, row, "right") - 1
        values = values * self.scale[col]
        if starts is self.columns:
            values = values * self.scale[row]
        blocks[stage, row - starts[stage], col - self.columns[stage]] = values
        return blocks

    def _side(self, k, own):
        """Rows of a stage beside its gap, over its variables; zero for bounds that do not act."""
        return self.rows[k, self.gaps[k] : self.gaps[k] + self.sides[k], :own]

    def _next_scale(self, k):
        there = self.columns[k + 1]
        return self.scale[there : there + self.nx[k + 1], None]

    def lowest_mode(self):
        """(relative eigenvalue, variation of the decision vector) of the least stable admissible variation."""
        basis = self._admissible()
        reduced = np.zeros((basis.shape[1],) * 2)
        for k in range(len(self.nx)):
            own = slice(self.columns[k], self.columns[k + 1])
            size = self.nx[k] + self.nu[k]
            reduced += basis[own].T @ self.curvature[k, :size, :size] @ basis[own]
        if self.coupling is not None:
            reduced += basis.T @ (self.coupling @ basis)
        values, vectors = eigh((reduced + reduced.T) / 2)
        return float(values[0] / np.abs(values).max()), self.scale * (basis @ vectors[:, 0])

    def _admissible(self):
        """(len x, free) basis of the variations that satisfy all rows to first order: the states follow from
        the controls and from what the start leaves free; what the end forbids is projected out."""
        own = self.columns[1]
        side = self._side(0, own)
        free = null_space(side) if len(side) else np.eye(own)
        basis = np.zeros((self.columns[-1], free.shape[1] + self.nu[1:].sum()))
        basis[:own, : free.shape[1]] = free
        used = free.shape[1]
        for k in range(len(self.nx) - 1):
            here, there = self.columns[k], self.columns[k + 1]
            if k:
                control = slice(used, used + self.nu[k])
                basis[here + self.nx[k] : there, control] = np.eye(self.nu[k])
                used += self.nu[k]
            lead = -self.rows[k, : self.gaps[k], : self.nx[k] + self.nu[k]] / self._next_scale(k)
            basis[there : there + self.nx[k + 1], :used] = lead @ basis[here:there, :used]
        held = [
            self._side(k, self.nx[k] + self.nu[k]) @ basis[self.columns[k] : self.columns[k + 1]]
            for k in range(1, len(self.nx))
            if self.sides[k]
        ]
        if self.links is not None:
            held.append(self.links @ basis)
        if held and (held := np.vstack(held)).any():
            q, r, _ = qr(held.T, pivoting=True)
            rank = int(np.sum(np.abs(np.diag(r)) > 1e-10 * np.abs(r).max()))
            basis = basis @ q[:, rank:]
        return basis
