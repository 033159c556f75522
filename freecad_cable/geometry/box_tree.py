# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which of many things is nearest, found through a tree of boxes around them."""

import numpy as np

BRANCHES = 8
"""A wide tree has few levels, and each level costs a dozen NumPy calls."""
LEAF = 8
"""Most things in a leaf."""
ALONE = 12
"""Most things of which to ask each is quicker than any tree: a box has so many triangles."""
MANY = 6
"""Nodes that are left of a level for a point, from which it is worth while to bound what the next leaves."""
MOST_PAIRS = 1 << 17
"""Bound on pairs of point and node held at a time, for memory."""


class BoxTree:
    """A complete tree over n things, each within the hull of its k ``corners`` (n, k, 3).

    ``axes`` (n, 3): unit vectors along which the things are flat, or about which they are thin. Around a leaf lies a
    cylinder with that axis: a tighter bound than a box for what is slanted.
    """

    def __init__(self, corners, axes):
        depth = 0
        while len(corners) > max(ALONE, LEAF * BRANCHES**depth):
            depth += 1
        leaves = BRANCHES**depth
        size = -(-len(corners) // leaves)
        low, high = corners.min(axis=1), corners.max(axis=1)
        middle = (low + high) / 2
        # Things are repeated to fill the last leaves, which does no harm to a least distance.
        groups = np.resize(np.arange(len(corners)), (1, leaves * size))
        while len(groups) < leaves:
            widest = np.ptp(middle[groups], axis=1).argmax(axis=1)
            half = groups.shape[1] // 2
            order = np.argpartition(middle[groups, widest[:, None]], half, axis=1)
            groups = np.take_along_axis(groups, order, axis=1).reshape(-1, half)
        self._things = groups
        self._drums = _drums(corners[groups].reshape(leaves, -1, 3), axes[groups])
        low, high = low[groups].min(axis=1), high[groups].max(axis=1)
        self._levels = []
        while len(low) > 1:
            low, high = low.reshape(-1, BRANCHES, 3), high.reshape(-1, BRANCHES, 3)
            self._levels.insert(0, (low, high))
            low, high = low.min(axis=1), high.max(axis=1)
        self._size = max(np.abs(low).max(), np.abs(high).max())

    def nearest(self, points, squared):
        """(m,) index of the thing that is nearest to each point (m, 3).

        ``squared(points (p, 3), things (p,))`` gives the squared distances (p,) of things.
        """
        node = np.zeros(len(points), int)
        if not self._levels:
            return self._in_leaves(points, node, squared)[1]
        for low, high in self._levels:
            gap = to_boxes(points, low[node], high[node])
            node = BRANCHES * node + gap.argmin(axis=1)
        # Some leaf near the point gives a bound; then every leaf that may hold a thing within it is looked into. Of a
        # point deep inside, where leaves are near on all sides, the boxes on the way down give better ones.
        bound = self._bound(points, node, squared)
        who, node = np.arange(len(points)), np.zeros(len(points), int)
        for low, high in self._levels:
            gap = to_boxes(points[who], low[node], high[node])
            if len(who) > MANY * len(points):
                within = surely_within(points[who], low[node], high[node]).min(axis=1)
                within = np.minimum.reduceat(within, _firsts(who))
                bound = np.minimum(bound, self._widened(points, within))
            pair, branch = np.nonzero(gap <= bound[who, None])
            who, node = who[pair], BRANCHES * node[pair] + branch
            if len(who) > MOST_PAIRS and len(points) > 1:
                halves = np.array_split(points, 2)
                return np.concatenate([self.nearest(half, squared) for half in halves])

        gap = self._to_drums(points[who], node)
        bound = np.minimum(bound, self._bound(points, node[_least(who, gap)], squared))
        near = gap <= bound[who]
        who, node = who[near], node[near]
        distance, thing = self._in_leaves(points[who], node, squared)
        return thing[_least(who, distance)]

    def _bound(self, points, leaves, squared):
        """Squared distances (m,) to the nearest in one leaf each, wide enough for rounding."""
        return self._widened(points, self._in_leaves(points, leaves, squared)[0])

    def _widened(self, points, squared):
        rounding = 1e-13 * (self._size + np.abs(points).max(initial=0.0))
        return (np.sqrt(squared) + rounding) ** 2

    def _in_leaves(self, points, leaves, squared):
        """The least squared distance (p,) to the things in one leaf each, and which thing (p,) has it."""
        things = self._things[leaves]
        count, size = things.shape
        distance = squared(np.repeat(points, size, axis=0), things.ravel()).reshape(count, size)
        best = distance.argmin(axis=1)
        row = np.arange(count)
        return distance[row, best], things[row, best]

    def _to_drums(self, points, leaves):
        """Squared distances (p,) of points (p, 3) from the cylinder around one leaf each."""
        hub, axis, half, rim = (part[leaves] for part in self._drums)
        away = points - hub
        along = np.einsum("pi,pi->p", away, axis)
        across = np.einsum("pi,pi->p", away, away) - along**2
        beyond = np.maximum(np.abs(along) - half, 0.0)
        aside = np.maximum(np.sqrt(np.maximum(across, 0.0)) - rim, 0.0)
        return beyond**2 + aside**2


def to_boxes(points, low, high):
    """Squared distances (p, b) of points (p, 3) from b boxes (p, b, 3) each, or (b, 3) for all."""
    points = points[:, None, :]
    gap = np.maximum(np.maximum(low - points, points - high), 0.0)
    return np.einsum("pbi,pbi->pb", gap, gap)


def surely_within(points, low, high):
    """Squared distances (p, b) within which something of what is in each of b boxes (p, b, 3) is, as every side of a
    hull touches something: the nearer side along one axis, at most the farther along the others (Roussopoulos, Kelley,
    Vincent, "Nearest neighbor queries", SIGMOD 1995)."""
    points = points[:, None, :]
    low, high = (low - points) ** 2, (high - points) ** 2
    near, far = np.minimum(low, high), np.maximum(low, high)
    return far.sum(axis=2) - (far - near).max(axis=2)


def _drums(corners, axes):
    """Centre (l, 3), axis (l, 3), half height (l,) and radius (l,) of cylinders around l leaves with all their corners
    (l, c, 3) and the axes (l, a, 3) of their things."""
    hub, axis = corners.mean(axis=1), axes.sum(axis=1)
    length = np.linalg.norm(axis, axis=1, keepdims=True)
    axis = np.where(length > 1e-6, axis / np.maximum(length, 1e-6), (0.0, 0.0, 1.0))
    away = corners - hub[:, None, :]
    along = np.einsum("lci,li->lc", away, axis)
    across = np.linalg.norm(away - along[:, :, None] * axis[:, None, :], axis=2)
    return hub, axis, np.abs(along).max(axis=1), across.max(axis=1)


def _least(who, values):
    """Of values (p,) in runs of equal ``who`` (p,): the place of the first least one in every run."""
    first = _firsts(who)
    least = np.flatnonzero(values == np.minimum.reduceat(values, first)[who])
    return least[np.diff(who[least], prepend=-1) > 0]


def _firsts(who):
    """Where runs of equal ``who`` (p,) begin."""
    return np.flatnonzero(np.diff(who, prepend=-1))
