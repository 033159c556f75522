# SPDX-License-Identifier: LGPL-2.1-or-later
"""Piecewise quintic functions with given values and derivatives at their knots, and their B-splines.

Farin, Curves and Surfaces for CAGD, 5th ed., chapters 5 to 8.
"""

from dataclasses import dataclass

import numpy as np

DEGREE = 5

BINOMIALS = {4: (1, 4, 6, 4, 1), 5: (1, 5, 10, 10, 5, 1)}


@dataclass(frozen=True, eq=False)
class Quintic:
    """A C2 function of one parameter with values in d dimensions (quintic Hermite interpolation).

    parameter (n,) increasing; value, first, second (n, d): the function and its derivatives there.
    """

    parameter: np.ndarray
    value: np.ndarray
    first: np.ndarray
    second: np.ndarray

    @property
    def step(self):
        """(n-1,) lengths of the spans."""
        return np.diff(self.parameter)

    def thinned(self, tolerance) -> "Quintic":
        """The function from as few of its knots as keep it within ``tolerance`` (d,) at the others.

        Spans are halved until they fit. Poles that say nothing new would make every later operation on
        the shape slow.
        """
        spans = [(0, len(self.parameter) - 1)]
        for span in spans:
            spans += _halves(*span)
        # All at once, because that is quicker than one after the other as they are needed.
        start, end = np.array(spans).T
        knot = np.concatenate([np.arange(a + 1, b) for a, b in spans])
        span = np.repeat(np.arange(len(spans)), end - start - 1)
        begin = self.parameter[start]
        share = (self.parameter[knot] - begin[span]) / (self.parameter[end] - begin)[span]
        value = np.einsum("nk,nkd->nd", bernstein(DEGREE, share), self.bezier(start, end)[span])
        off = (np.abs(value - self.value[knot]) > tolerance).any(axis=1)
        misfits = {spans[k] for k in span[off].tolist()}
        chosen = spans[:1]
        for span in chosen:
            chosen += _halves(*span) if span in misfits else []
        keep = sorted({spans[0][1], *(a for a, _ in chosen)})
        return Quintic(*(x[keep] for x in vars(self).values()))

    def cut(self, ratio) -> "list[Quintic]":
        """The function in as few pieces as are each at most ``ratio`` times as long as their shortest span."""
        ends, shortest = [0], np.inf
        for k, step in enumerate(self.step):
            shortest = min(shortest, step)
            if self.parameter[k + 1] - self.parameter[ends[-1]] > ratio * shortest:
                ends.append(k)
                shortest = step
        ends.append(len(self.step))
        return [
            Quintic(*(x[a : b + 1] for x in vars(self).values()))
            for a, b in zip(ends[:-1], ends[1:], strict=True)
        ]

    def bezier(self, start=slice(None, -1), end=slice(1, None)):
        """(m, 6, d) Bézier points of the spans between the knots ``start`` (m,) and ``end`` (m,)."""
        h = (self.parameter[end] - self.parameter[start])[:, None]
        f0, f1 = self.value[start], self.value[end]
        g0, g1 = h / 5 * self.first[start], h / 5 * self.first[end]
        c0, c1 = h**2 / 20 * self.second[start], h**2 / 20 * self.second[end]
        return np.stack([f0, f0 + g0, f0 + 2 * g0 + c0, f1 - 2 * g1 + c1, f1 - g1, f1], axis=1)

    def at(self, share):
        """Value and first derivative, each (n-1, m, d), at the shares (m,) in 0…1 of every span."""
        points = self.bezier()
        slopes = DEGREE * np.diff(points, axis=1) / self.step[:, None, None]
        return (
            np.einsum("mk,nkd->nmd", bernstein(DEGREE, share), points),
            np.einsum("mk,nkd->nmd", bernstein(DEGREE - 1, share), slopes),
        )

    def poles(self):
        """(3n, d) B-spline poles for knots of multiplicity 3, at the ends 6.

        With a, b, c neighbouring knots the poles about b are the blossoms f(a,a,b,b,b) and f(b,b,b,c,c),
        which are Bézier points, and f(a,b,b,b,c) between them, which extends the span a…b to c.
        """
        p, h = self.bezier(), self.step
        extended = (1 + h[1:] / h[:-1])[:, None]
        middle = p[:-1, 3] + extended * (p[:-1, 4] - p[:-1, 3])
        about = np.stack([p[:-1, 3], middle, p[1:, 2]], axis=1).reshape(-1, p.shape[2])
        return np.concatenate([p[0, :3], about, p[-1, 3:]])


def joined(pieces, continuity):
    """Knots, multiplicities and poles of one B-spline through ``pieces`` that meet end to start.

    ``continuity`` 0: they meet in value; 1: in the first derivative as well.
    """
    knots, multiplicities, poles = [], [], []
    for piece in pieces:
        inner = [3] * (len(piece.parameter) - 2)
        multiplicities += [DEGREE - continuity, *inner]
        knots += piece.parameter[:-1].tolist()
        own = piece.poles()
        poles.append(own[1 if poles and continuity else 0 : -1])
    knots.append(float(pieces[-1].parameter[-1]))
    multiplicities[0] = DEGREE + 1
    return knots, [*multiplicities, DEGREE + 1], np.concatenate([*poles, own[-1:]])


def bernstein(degree, share):
    """(m, degree + 1) Bernstein polynomials at ``share`` (m,)."""
    share = np.asarray(share, float)
    rising = np.vander(share, degree + 1, increasing=True)
    return BINOMIALS[degree] * rising * np.vander(1 - share, degree + 1)


def _halves(a, b):
    """The halves of a span between the knots a and b, if there is a knot inside."""
    middle = (a + b) // 2
    return [(a, middle), (middle, b)] if a < middle else []
