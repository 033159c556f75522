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
    hessian, jacobian = nlp.second_variation(x, parameters, multipliers)
    basis = _admissible(nlp, jacobian.sparse().tocoo(), _softness(nlp, parameters))
    reduced = basis.T @ (hessian.sparse() @ basis)
    values, vectors = eigh((reduced + reduced.T) / 2)
    return float(values[0] / np.abs(values).max()), basis @ vectors[:, 0]


def _softness(nlp, parameters):
    """(m,) 1/√stiffness of the strains: in strains so scaled all elastic energies are alike, and one stiff
    in stretch or twist does not hide another that buckles."""
    return 1 / np.sqrt(parameters[list(nlp.structure.strains)])


def _admissible(nlp, jacobian, softness):
    """(len x, free) basis of the variations that satisfy all rows to first order."""
    sizes = nlp.stage_sizes
    nx, nu, ng = (np.array(column) for column in zip(*sizes, strict=True))
    columns = np.concatenate([[0], np.cumsum(nx + nu)])
    gaps = np.append(nx[1:], 0)
    rows = np.concatenate([[0], np.cumsum(gaps + ng)])
    # One dense block a stage: its rows, over its own state and control and the next state.
    blocks = np.zeros((len(sizes), (gaps + ng).max(), 2 * nx.max() + nu.max()))
    stage = np.searchsorted(rows, jacobian.row, "right") - 1
    blocks[stage, jacobian.row - rows[stage], jacobian.col - columns[stage]] = jacobian.data

    own = nx[0] + nu[0]
    first = blocks[0, gaps[0] : gaps[0] + ng[0], :own]
    free = null_space(first) if len(first) else np.eye(own)
    basis = np.zeros((jacobian.shape[1], free.shape[1] + nu[1:].sum()))
    free[7:] *= np.tile(softness, (own - 7) // len(softness))[:, None]
    basis[:own, : free.shape[1]] = free
    used = free.shape[1]
    for k in range(len(sizes) - 1):
        here, there = columns[k], columns[k + 1]
        if k:
            control = slice(used, used + nu[k])
            basis[here + nx[k] : there, control] = np.diag(softness)[: nu[k]]
            used += nu[k]
        gap = blocks[k, : gaps[k], : nx[k] + nu[k]]
        basis[there : there + nx[k + 1], :used] = -gap @ basis[here:there, :used]
    ends = blocks[-1, : ng[-1], : nx[-1]] @ basis[columns[-2] :]
    if len(ends):
        q, r = qr(ends.T)[:2]
        rank = int(np.sum(np.abs(np.diag(r)) > 1e-10 * np.abs(r).max()))
        basis = basis @ q[:, rank:]
    return basis
