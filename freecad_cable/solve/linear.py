# SPDX-License-Identifier: LGPL-2.1-or-later
"""The linearised boundary value problem of a rod: a band with a border, collected piece by piece."""

import numpy as np
from scipy.linalg.lapack import dgbsv
from scipy.sparse import bmat, csc_matrix, identity
from scipy.sparse.linalg import splu


def solved(transfer, defects, first, last):
    """Corrections (n+1, 12) of the nodes of a rod without joints, as a ``LinearProblem`` of its ``elements`` and its
    ``ends`` has them, or None: a band with blocks in the same places, whichever rod it is."""
    after, before = transfer
    count, size, beside = len(after), 12 * (len(after) + 1), 17
    width, diagonal = 3 * beside + 1, 2 * beside
    band = np.zeros((size, width))  # a column of the matrix in each row

    def blocks(row, column, height, number=1):
        """(number, 12, height) transposed blocks from ``row`` and ``column`` on, each 12 farther than the last."""
        begin, strides = column * (width - 1) + row + diagonal, (96 * width, 8 * width - 8, 8)
        return np.ndarray((number, 12, height), float, band, 8 * begin, strides)

    blocks(6, 0, 12, count)[:] = -before.swapaxes(1, 2)
    blocks(6, 12, 12, count)[:] = after.swapaxes(1, 2)
    blocks(0, 0, 6)[:] = first[0].T
    blocks(size - 6, size - 12, 6)[:] = last[0].T
    defects = (after @ defects[:, :, None]).ravel()
    right = np.concatenate([first[1], -defects, last[1]])
    *_, found, singular = dgbsv(beside, beside, band.T, right, overwrite_ab=1)
    return None if singular or _runaway(found, right) else found.reshape(-1, 12)


def _runaway(found, right):
    """Whether a correction says that the matrix is singular but for rounding."""
    return not np.abs(found).max() < 1e6 * np.abs(right).max() + 1e-300


class LinearProblem:
    """Unknowns: 12 a node, the nodes of one stretch after those of the other (a joint twice), then single ones. Near
    each other along the rod they make a band; what all elements share and as many rows make its border."""

    def __init__(self, elements):
        """``elements``: how many each stretch has."""
        self.elements_of = elements
        self.begin = 12 * np.concatenate([[0], np.cumsum(np.array(elements) + 1)])
        self.size = int(self.begin[-1])
        self.rows, self.cols, self.data, self.right = [], [], [], []
        self.height = 0
        # Where on the rod rows and columns are, in columns of nodes; in the border they are nowhere.
        self.at_rows, self.at_cols = [], np.arange(self.size)

    def unknowns(self, count, at=np.inf):
        """Columns of new single unknowns, ``at`` these of a node or in the border."""
        self.size += count
        self.at_cols = np.append(self.at_cols, np.full(count, np.max(at) + 0.5))
        return np.arange(self.size - count, self.size)

    def node(self, stretch, index):
        """Columns (12,) of a node of a stretch; −1 is its last."""
        if index < 0:
            index += self.elements_of[stretch] + 1
        return self.begin[stretch] + 12 * index + np.arange(12)

    def add(self, blocks, right, border=False):
        """Rows Σ matrix · unknowns[columns] = right, for ``blocks`` of (matrix (k, c), columns (c,))."""
        for matrix, columns in blocks:
            i, j = np.nonzero(matrix)
            self.rows.append(self.height + i)
            self.cols.append(columns[j])
            self.data.append(matrix[i, j])
        self.right.append(np.atleast_1d(right))
        beside = [self.at_cols[columns].mean() for _, columns in blocks]
        middle = np.inf if border else np.mean(beside)
        self.at_rows.append(np.full(len(self.right[-1]), middle))
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
        self.at_rows.append(np.repeat(first + 11.5, 12))
        self.element_rows = self.height + 12 * np.arange(len(after))
        self.after = after
        self.height += 12 * len(after)

    def add_to(self, rows, column, values):
        """Entries (k,) more, in rows (k,) that are there."""
        self.rows.append(rows)
        self.cols.append(np.full(len(rows), column))
        self.data.append(values)

    def ends(self, first, last):
        """Six conditions (matrix (6, 12), values) on the first node and six on the last."""
        self.add([(first[0], self.node(0, 0))], first[1])
        self.add([(last[0], self.node(len(self.elements_of) - 1, -1))], last[1])

    def solve(self):
        """Corrections of the nodes, (count+1, 12) of each stretch."""
        rows, cols, data, right = map(np.concatenate, (self.rows, self.cols, self.data, self.right))
        row_order = np.argsort(np.concatenate(self.at_rows), kind="stable")
        col_order = np.argsort(self.at_cols, kind="stable")
        rows, cols = np.argsort(row_order)[rows], np.argsort(col_order)[cols]
        right = right[row_order]
        ordered = _banded(rows, cols, data, right, np.isfinite(self.at_cols).sum())
        if ordered is None or _runaway(ordered, right):
            ordered = _shortest(csc_matrix((data, (rows, cols))), right)
        answer = np.empty(self.size)
        answer[col_order] = ordered
        nodes = answer[: self.begin[-1]].reshape(-1, 12)
        return np.split(nodes, self.begin[1:-1] // 12)


def _banded(rows, cols, data, right, width):
    """Of a matrix whose first ``width`` columns and rows are a band and the others its border; None if the band is
    singular."""
    inside = (rows < width) & (cols < width)
    i, j = rows[inside], cols[inside]
    below, above = (i - j).max(), (j - i).max()
    band = np.zeros((2 * below + above + 1, width), order="F")
    band[below + above + i - j, j] = data[inside]
    total = len(right)
    border = np.zeros((total, total - width))
    beside = cols >= width
    border[rows[beside], cols[beside] - width] = data[beside]
    *_, found, singular = dgbsv(
        below, above, band, np.column_stack([right[:width], border[:width]])
    )
    if singular:
        return None
    if width == total:
        return found[:, 0]
    under = np.zeros((total - width, width))
    beneath = (rows >= width) & (cols < width)
    under[rows[beneath] - width, cols[beneath]] = data[beneath]
    try:
        shared = np.linalg.solve(
            border[width:] - under @ found[:, 1:], right[width:] - under @ found[:, 0]
        )
    except np.linalg.LinAlgError:
        return None
    return np.concatenate([found[:, 0] - found[:, 1:] @ shared, shared])


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
