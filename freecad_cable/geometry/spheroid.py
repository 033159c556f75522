# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a curve of given length can be that is held at one or two points, and how far that is from boxes."""

from dataclasses import dataclass

import numpy as np

ROUNDS = 40
"""Projections to and fro. Most boxes are decided by the first two; the rest count as near."""
NEWTON_STEPS = 8
THINNEST = 1e-6
"""Least ratio of the half axes: a taut curve is given this much room, so that nothing divides by zero."""


@dataclass(frozen=True, eq=False)
class Spheroid:
    """All x with |x − a| + |x − b| ≤ L, or |x − a| ≤ L: an ellipsoid of revolution, half axes ``long`` ≥ ``short``."""

    center: np.ndarray
    """(3,)"""
    axis: np.ndarray
    """(3,) unit"""
    long: float
    short: float

    @classmethod
    def of(cls, length, a, b=None) -> "Spheroid":
        """Of a curve of ``length`` through a (3,) and b (3,), or through a only; taken as |b − a| if less."""
        a = np.asarray(a, float)
        if b is None:
            return cls(a, np.array([0.0, 0.0, 1.0]), length, length)
        chord = np.asarray(b, float) - a
        apart = np.linalg.norm(chord)
        axis = chord / apart if apart > 0 else np.array([0.0, 0.0, 1.0])
        length = max(length, apart)
        short = np.sqrt((length - apart) * (length + apart)) / 2
        return cls(a + chord / 2, axis, length / 2, max(short, THINNEST * length / 2))

    def support(self, directions):
        """Greatest n·x (m,) over all x in it, for directions n (m, 3), unit."""
        along = directions @ self.axis
        return directions @ self.center + np.hypot(
            self.long * along, self.short * np.sqrt(np.maximum(1 - along**2, 0.0))
        )

    def nearest(self, points):
        """Its points (m, 3) nearest to points (m, 3).

        Newton's method for the multiplier t ≥ 0 of (A p / (t + A²))² + (B q / (t + B²))² = 1, from the left, where it
        is monotone. Eberly, "Distance from a point to an ellipse, an ellipsoid, or a hyperellipsoid", Geometric Tools.
        """
        away = points - self.center
        along = away @ self.axis
        across = away - along[:, None] * self.axis
        p, q = self.long * np.abs(along), self.short * np.linalg.norm(across, axis=1)
        aa, bb = self.long**2, self.short**2
        t = np.maximum(np.maximum(p - aa, q - bb), 0.0)
        for _ in range(NEWTON_STEPS):
            f, g = (p / (t + aa)) ** 2, (q / (t + bb)) ** 2
            t = t + np.maximum(f + g - 1, 0.0) / (2 * (f / (t + aa) + g / (t + bb)) + 1e-300)
        along, across = along * (aa / (t + aa)), across * (bb / (t + bb))[:, None]
        return self.center + along[:, None] * self.axis + across

    def far_from(self, bounds, margin):
        """(k,) whether every point of boxes with corners ``bounds`` (k, 2, 3), which may be infinite, is farther than
        ``margin`` away.

        True only with a plane that parts the two by more than the margin, found by projecting between box and
        spheroid (Beck, Teboulle, "A fast iterative shrinkage-thresholding algorithm", SIAM J Imaging Sci 2, 2009, for
        the momentum). What is not decided after some rounds, being all but at the margin, counts as near.
        """
        bounds = np.asarray(bounds, float)
        far = np.zeros(len(bounds), bool)
        open_ = np.arange(len(bounds))
        last = in_box = np.clip(self.center, bounds[:, 0], bounds[:, 1])
        for k in range(ROUNDS):
            low, high = bounds[open_, 0], bounds[open_, 1]
            # Projecting to and fro is a proximal gradient step; from a point ahead it needs the root of the steps.
            inside = self.nearest(in_box + k / (k + 3) * (in_box - last))
            last, in_box = in_box, np.clip(inside, low, high)
            gap = in_box - inside
            apart = np.linalg.norm(gap, axis=1)
            normal = gap / np.maximum(apart, 1e-300)[:, None]
            parted = _least(normal, low, high) - self.support(normal) > margin
            far[open_[parted]] = True
            undecided = ~parted & (apart > margin)
            open_, last, in_box = open_[undecided], last[undecided], in_box[undecided]
            if not len(open_):
                break
        return far


def _least(normal, low, high):
    """Least n·x (m,) over boxes, for one direction n (m, 3) each."""
    with np.errstate(invalid="ignore"):
        products = normal * np.where(normal > 0, low, high)
    return np.where(normal == 0, 0.0, products).sum(axis=1)
