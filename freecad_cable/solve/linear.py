# SPDX-License-Identifier: LGPL-2.1-or-later
"""The linearised boundary value problem of a rod: sparse rows, collected piece by piece."""

import numpy as np
from scipy.sparse import bmat, csc_matrix, identity
from scipy.sparse.linalg import splu


class LinearProblem:
    """Unknowns: 12 a node, the nodes of one stretch after those of the other (a joint twice), then single ones."""

    def __init__(self, elements):
        """``elements``: how many each stretch has."""
        self.elements_of = elements
        self.begin = 12 * np.concatenate([[0], np.cumsum(np.array(elements) + 1)])
        self.size = int(self.begin[-1])
        self.rows, self.cols, self.data, self.right = [], [], [], []
        self.height = 0

    def unknowns(self, count):
        """Columns of new single unknowns."""
        self.size += count
        return np.arange(self.size - count, self.size)

    def node(self, stretch, index):
        """Columns (12,) of a node of a stretch; −1 is its last."""
        if index < 0:
            index += self.elements_of[stretch] + 1
        return self.begin[stretch] + 12 * index + np.arange(12)

    def add(self, blocks, right):
        """Rows Σ matrix · unknowns[columns] = right, for ``blocks`` of (matrix (k, c), columns (c,))."""
        for matrix, columns in blocks:
            i, j = np.nonzero(matrix)
            self.rows.append(self.height + i)
            self.cols.append(columns[j])
            self.data.append(matrix[i, j])
        self.right.append(np.atleast_1d(right))
        self.height += len(self.right[-1])

    def elements(self, transfer, defects):
        """Rows P b = Q a − P defect of all elements in order; P and Q are ``transfer``, (n, 12, 12)."""
        after, before = transfer
        first = np.concatenate(
            [
                begin + 12 * np.arange(count)
                for begin, count in zip(self.begin, self.elements_of, strict=False)
            ]
        )
        row, col = np.meshgrid(np.arange(12), np.arange(12), indexing="ij")
        rows = (12 * np.arange(len(after))[:, None, None] + row).ravel()
        self.rows += [self.height + rows] * 2
        self.cols += [(first[:, None, None] + shift + col).ravel() for shift in (0, 12)]
        self.data += [-before.ravel(), after.ravel()]
        self.right.append(-np.einsum("kij,kj->ki", after, defects).ravel())
        self.element_rows = self.height + 12 * np.arange(len(after))
        self.after = after
        self.height += 12 * len(after)

    def ends(self, first, last):
        """Six conditions (matrix (6, 12), values) on the first node and six on the last."""
        self.add([(first[0], self.node(0, 0))], first[1])
        self.add([(last[0], self.node(len(self.elements_of) - 1, -1))], last[1])

    def solve(self):
        """Corrections of the nodes, (count+1, 12) of each stretch."""
        matrix = csc_matrix(
            (np.concatenate(self.data), (np.concatenate(self.rows), np.concatenate(self.cols))),
            (self.size, self.size),
        )
        right = np.concatenate(self.right)
        try:
            # In order the matrix is a band, which no other order beats.
            answer = splu(matrix, permc_spec="NATURAL").solve(right)
            resolved = np.abs(answer).max() < 1e6 * np.abs(right).max() + 1e-300
        except RuntimeError:
            resolved = False
        if not resolved:
            answer = _shortest(matrix, right)
        nodes = answer[: self.begin[-1]].reshape(-1, 12)
        return np.split(nodes, self.begin[1:-1] // 12)


FREE = 1e-7
"""Singular value, relative to the largest entry, below which a direction is free. The strong form leaves about its
square in one that is, and takes up what is a hundred times as stiff to 1e-4."""


def _shortest(matrix, right):
    """A rod that may move as a whole (a circle of solutions) has no unique correction: the shortest of those that leave
    least, (AᵀA + δ²) x = Aᵀ b, written so that the condition of A is not squared."""
    delta = FREE * np.abs(matrix.data).max()
    size = len(right)
    both = bmat([[delta * identity(size), matrix], [matrix.T, -delta * identity(size)]], "csc")
    return splu(both).solve(np.concatenate([right, np.zeros(size)]))[size:]
