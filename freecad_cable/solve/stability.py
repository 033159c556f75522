# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether an equilibrium is a minimum: the second variation of the energy on admissible variations.

The states of the program follow from its controls and from what the start leaves free, so a variation is a
vector of those; the Hessian of the Lagrangian is gathered onto them stage by stage, what the end conditions
forbid is projected out, and the smallest eigenvalue decides. The reduced matrix is dense but well
conditioned: it belongs to kinematics, not to the (stiff) equations of equilibrium.
"""

import numpy as np
from scipy.linalg import eigh, null_space, qr

from ..transcription.nlp import Nlp

ZERO = 1e-6
"""Smallest eigenvalue, relative to the largest, that counts as negative below. A circle of solutions
(a symmetric cable that may turn) has eigenvalues of about 1e-12; an unstable cable a step past its critical
load has more than this in all cases of the tests."""


def lowest_mode(nlp: Nlp, x, parameters, multipliers):
    """(relative eigenvalue, variation of the decision vector) of the least stable admissible variation."""
    hessian, jacobian = (part.sparse() for part in nlp.second_variation(x, parameters, multipliers))
    hessian, jacobian = hessian.tocsr(), jacobian.tocsr()
    basis = _admissible(nlp, jacobian)
    reduced = basis.T @ (hessian @ basis)
    values, vectors = eigh((reduced + reduced.T) / 2)
    return float(values[0] / np.abs(values).max()), basis @ vectors[:, 0]


def _admissible(nlp, jacobian):
    """(len x, free) basis of the variations that satisfy all rows to first order."""
    sizes = nlp.stage_sizes
    nx = sizes[0][0]
    first_rows = jacobian[nx : nx + sizes[0][2], : nx + sizes[0][1]].toarray()
    free = null_space(first_rows) if len(first_rows) else np.eye(nx + sizes[0][1])
    columns = free.shape[1] + sum(nu for _, nu, _ in sizes[1:])
    basis = np.zeros((jacobian.shape[1], columns))
    basis[: len(free), : free.shape[1]] = free
    row, col, used = 0, 0, free.shape[1]
    for k, (nx, nu, ng) in enumerate(sizes[:-1]):
        if k:
            basis[col + nx : col + nx + nu, used : used + nu] = np.eye(nu)
            used += nu
        following = col + nx + nu
        gap = jacobian[row : row + sizes[k + 1][0], col:following].toarray()
        basis[following : following + sizes[k + 1][0], :used] = -gap @ basis[col:following, :used]
        row += sizes[k + 1][0] + ng
        col = following
    ends = jacobian[row:, col:].toarray() @ basis[col:]
    if len(ends):
        q, r = qr(ends.T)[:2]
        rank = int(np.sum(np.abs(np.diag(r)) > 1e-10 * np.abs(r).max()))
        basis = basis @ q[:, rank:]
    return basis
