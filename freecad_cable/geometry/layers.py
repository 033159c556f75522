# SPDX-License-Identifier: LGPL-2.1-or-later
"""A heavy or taut rod: a hanging chain, with a bending layer at each end that holds a direction.

Where the tension T is large against EI/L², bending matters only within some widths λ = √(EI/T) of the ends. There the
rod turns from its held direction into that of the chain as an infinite elastica does under tension (the separatrix of
Kirchhoff's pendulum; Love, *Mathematical Theory of Elasticity*, art. 263), with s from the end and φ between the two:

    tan(φ/4) = tan(φ₀/4) exp(−s/λ),   ∫ (1 − cos φ) ds = 4 λ sin²(φ/4),   ∫ sin φ ds = 2 λ sin(φ/2)

So the chain seems to hang from a place that much behind the end and aside of it. All in the limit λ ≪ L.
"""

import numpy as np
from scipy.optimize import brentq

from .curves import Chain, catenary
from .guess import perpendicular

LEAST = 1e-11
"""Slack, relative to the length, below which weight no longer decides the tension of a chain: the layers do."""
CLOSEST = 1e-5
"""Distance of the places, relative to the length, up to which both parts of the chain hang as one."""
STEPS = 20
"""Towards the direction of a rod without weight, which its layers turn by about their width."""
WIDEST = 0.1
"""Width of a layer, relative to the length, up to which there is one."""


class Layered:
    """``at(s)``: position and unit tangent (m, 3), and the force (m, 3) that the part beyond s exerts, per EI.

    ``widths``: of the two layers, None where there is none. ``valid``: whether the limit holds.
    """

    def __init__(self, start, first, end, last, length, weight):
        """From ``start`` to ``end`` (3,) with unit tangents ``first`` and ``last`` (3,) or None; ``length`` above the
        distance; ``weight`` (3,): per length and EI [1/length³]."""
        self.length, self.weight = length, weight
        self.places = np.asarray(start, float), np.asarray(end, float)
        self.held = first, last
        chord = self.places[1] - self.places[0]
        self.distance = float(np.linalg.norm(chord))
        self.valid, self.widths = False, (None, None)
        if not CLOSEST * length < self.distance < length:
            return
        self.heavy = weight.any() and self._missing(LEAST) > 0
        if self.heavy:
            share = brentq(lambda log: self._missing(np.exp(log)), np.log(LEAST), -1e-6, xtol=1e-4)
            self._missing(np.exp(share))
        else:
            self._stretch()
        self.widths = tuple(None if layer is None else layer.width for layer in self.layers)
        self.valid = all(width is None or width < WIDEST * length for width in self.widths)
        if self.valid and self.heavy:
            # Where it hangs lowest, the chain must not bend more sharply than a rod would.
            horizontal = self.pull - (self.pull @ weight) * weight / (weight @ weight)
            self.valid = np.linalg.norm(horizontal) ** 3 > weight @ weight

    def _missing(self, share):
        """Slack of the chain that hangs between the places seen, less ``share`` of the length; falls with it."""
        a, b = self.places
        chain = Chain(b - a, self.distance / (1 - share), self.weight)
        ends = np.array([chain.first, chain.last])
        tangents = chain.tangent(ends)
        pulls = (
            np.hypot(chain.size, ends)
            * np.linalg.norm(self.weight)
            * (1 - share)
            * self.length
            / self.distance
        )
        self.layers = _layers(tangents, pulls, self.held)
        self.pull = pulls[0] * tangents[0]
        return 1 - self._seen_distance() / self.length - share

    def _stretch(self):
        """Without weight: the tension that leaves just as much slack as the layers use up."""
        a, b = self.places
        for _ in range(STEPS):
            along = (b - a) / np.linalg.norm(b - a)
            used = sum(each.used for each in _layers((along, along), (1, 1), self.held) if each)
            if not used > 1e-12:
                self.layers, self.pull = [None, None], along
                return
            pull = (used / (self.length - self.distance)) ** 2
            self.layers, self.pull = _layers((along, along), (pull, pull), self.held), pull * along
            a, b = self._seen_places()

    def _seen_places(self):
        a, b = self.places
        first, last = self.layers
        return (
            a if first is None else a - first.offset(0.0),
            b if last is None else b - last.offset(0.0),
        )

    def _seen_distance(self):
        a, b = self._seen_places()
        return float(np.linalg.norm(b - a))

    def at(self, s):
        a, b = self._seen_places()
        if self.heavy:
            length = max(self.length, self._seen_distance() * (1 + 1e-9))
            chain = catenary(a, b, length, self.weight)
            position, tangent = chain.at(s / self.length * chain.length)
        else:
            position = a + (s / self.length)[:, None] * (b - a)
            tangent = np.tile((b - a) / np.linalg.norm(b - a), (len(s), 1))
        first, last = self.layers
        if first is not None:
            position, tangent = position + first.offset(s), first.turned(tangent, s)
        if last is not None:
            back = self.length - s
            position, tangent = position + last.offset(back), -last.turned(-tangent, back)
        force = self.pull - np.outer(s, self.weight)
        return position, tangent, force


def _layers(tangents, pulls, held):
    """Those at both ends; None where no direction is held."""
    return [
        None if direction is None else Layer(sign * tangent, pull, sign * np.asarray(direction))
        for tangent, pull, direction, sign in zip(tangents, pulls, held, (1, -1), strict=True)
    ]


class Layer:
    """Seen from its end: ``tangent`` of the chain and ``held`` direction, both away from the end."""

    def __init__(self, tangent, pull, held):
        self.width = 1 / np.sqrt(pull)
        cosine = float(np.clip(tangent @ held, -1, 1))
        side = held - cosine * tangent
        size = np.linalg.norm(side)
        self.angle = float(np.arctan2(size, cosine))
        self.along = tangent
        self.side = side / size if size > 1e-9 else perpendicular(tangent)
        self.axis = np.cross(self.along, self.side)

    @property
    def used(self):
        """Length that the layer uses up, in widths."""
        return 4 * np.sin(self.angle / 4) ** 2

    def _angle(self, s):
        return 4 * np.arctan(np.tan(self.angle / 4) * np.exp(-s / self.width))

    def offset(self, s):
        """From the chain to the rod, seen from the end, (..., 3)."""
        angle = np.asarray(self._angle(s))[..., None]
        return self.width * (
            4 * np.sin(angle / 4) ** 2 * self.along - 2 * np.sin(angle / 2) * self.side
        )

    def turned(self, tangent, s):
        """(m, 3) tangents, turned by the angle of the layer."""
        angle = np.asarray(self._angle(s))[:, None]
        across = np.cross(self.axis, tangent)
        lift = (tangent @ self.axis)[:, None] * self.axis
        return tangent * np.cos(angle) + across * np.sin(angle) + lift * (1 - np.cos(angle))
