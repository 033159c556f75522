# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a cable keeps away from what a look at it has found.

Along a surface the first node of each element does so, or the last up to an end that is free: places that were chosen
anew wherever the cable is a little in the surface would take turns. At a place where a feature bends away from the
cable (an edge, a corner, a rim) it is the nearest of the element.
"""

from dataclasses import dataclass

import numpy as np

from ..transcription import contact
from ..transcription.arms import Places
from .leaving import leave
from .looking import Near

MOST = 4
"""Places on an element."""
POINTED = 0.5
"""Share of the bend of a surface that a cable does not follow where it touches it at a place."""
BESIDE_HELD = 0.25
"""Share of an element next to a node that is held where no place keeps away from anything: it could hardly move."""
SAME = 0.01
"""Distance of places, in radii of the cable, that are one."""
EVEN = 1e-3
"""Difference of gaps, in radii of the cable, by which features are two."""
LOOKS = 8
"""Looks for the nearest place between two samples."""


def places(around_it, look, reach, leaving=False, pushed=None) -> Places | None:
    """Of the elements of a shape, where they keep away from obstacles within ``reach``; None if nothing is.
    ``leaving``: whether what is inside an obstacle is to leave it. ``pushed``: where obstacles pushed at last (see
    ``arms.Pushed``), which is kept: of two features that each alone let the cable into the obstacle at the other,
    both may be wanted."""
    fine, begin = look.fine, look.begin
    allowed = _allowed(around_it, look)
    beside = allowed.min(axis=1, initial=np.inf) < max(reach, around_it.keep)
    found, allowed = [look.found[i] for i in np.flatnonzero(beside)], allowed[beside]
    if not found:
        return None
    last_held = np.searchsorted(begin, around_it.held(fine)[-1])
    where = np.where(np.arange(len(begin) - 1) < last_held, begin[:-1], begin[1:])
    where = np.tile(where, (len(found), 1))
    # What is thinner than an element may be inside it alone.
    deepest = _deepest(allowed, begin)
    inside = np.take_along_axis(allowed, deepest, axis=1) < -around_it.keep
    where = np.where(inside, deepest, where)
    sites = _Sites.at(look.shape, fine.arc_length[np.tile(where, (2, 1))])
    gap = np.take_along_axis(allowed, where, axis=1)
    gap = np.concatenate([gap, np.full_like(gap, np.inf)])

    def put(row, there, others):
        sites.put((row, there), others)
        gap[row, there] = contact.value(others.position, others.features)

    for row, near in enumerate(found):
        there = np.flatnonzero(gap[row] < reach)
        what = near.of(where[row, there])
        sites.features[row, there] = contact.parameters(what, around_it.keep)
        if leaving or inside[row].any():
            given = Near(near.obstacle, there, what)
            leave(sites.features[row], given, sites.position[row], around_it)
        if leaving:
            continue
        if (pointed := _pointed(around_it, look, near, allowed[row])) is not None:
            # Nodes that are as near as the nearest place would share its force, and not slide.
            nearest = contact.value(pointed[1].position, pointed[1].features)
            away = np.abs(sites.arc_length[row] - pointed[1].arc_length[:, None])
            as_near = gap[row] < nearest[:, None] + EVEN * around_it.radius
            gap[row, ((away < around_it.radius) & as_near).any(axis=0)] = np.inf
            put(row, *pointed)
        kept = _kept(around_it, look, near, pushed, sites.features[row])
        if kept is not None:
            put(row + len(found), *kept)
    order = _order(gap, reach)
    if order is None:
        return None
    elements = np.arange(len(order))[:, None]
    chosen = sites.of((order, elements))
    unused = gap[order, elements] >= reach
    unused[:, 1:] |= order[:, 1:] == order[:, :-1]
    which = np.tile(around_it.indices[[each.obstacle for each in found]], 2)
    return Places(
        np.where(unused[..., None], contact.NONE, chosen.features),
        chosen.position,
        chosen.ahead,
        chosen.arc_length - fine.arc_length[begin[:-1], None],
        np.where(unused, 0.0, chosen.slides),
        np.where(unused, -1, which[order]),
    )


def _order(gap, reach):
    """(n, c) which of so many gaps (m, n) within ``reach`` are the smallest of each element, as many as the element
    with the most has, or ``MOST``; the last once more where there are fewer. None if none is."""
    count = int((gap < reach).sum(axis=0).max())
    if count == 0:
        return None
    count = next(n for n in (1, 2, MOST) if n >= min(count, MOST))
    order = np.argsort(gap, axis=0)[:count]
    return np.pad(order, ((0, count - len(order)), (0, 0)), mode="edge").T


def _allowed(around_it, look):
    """(obstacles, samples) gaps of a look, infinite at and beside what is held."""
    gaps, s, begin = look.gaps.copy(), look.fine.arc_length, look.begin
    at_rims = around_it.at_rims(look.fine)
    for node in around_it.held(look.fine):
        k = np.searchsorted(begin, node)
        beside = s[begin[[max(k - 1, 0), min(k + 1, len(begin) - 1)]]]
        share = 0.0 if node in at_rims else BESIDE_HELD
        low, high = s[node] + share * (beside - s[node])
        gaps[:, (s >= low) & (s <= high)] = np.inf
    return gaps


def _deepest(gaps, begin):
    """(obstacles, n) sample of each element with the smallest gap"""
    least = np.minimum.reduceat(gaps[:, :-1], begin[:-1], axis=1)
    samples = np.arange(begin[-1])
    there = gaps[:, :-1] == np.repeat(least, np.diff(begin), axis=1)
    return np.minimum.reduceat(np.where(there, samples, begin[-1]), begin[:-1], axis=1)


def _pointed(around_it, look, near, gap):
    """Elements (m,) to which an obstacle is nearest at a place, and these; None if there are none. ``gap``
    (samples,)."""
    s, shape = look.fine.arc_length, look.shape
    before, here, after = gap[:-2], gap[1:-1], gap[2:]
    # Where a neighbour is infinite, nothing is known of the place between; inside, the way out is not along a normal.
    lowest = (here <= before) & (here < after) & (np.abs(here) < around_it.keep)
    samples = 1 + np.flatnonzero(lowest & np.isfinite(before) & np.isfinite(after))
    if not len(samples):
        return None
    low, sites, high = (_Sites.at(shape, s[samples + side]) for side in (-1, 0, 1))
    normals = [near.of(samples + side).normal for side in (-1, 0, 1)]
    falls, rises = (
        (normal * end.ahead).sum(axis=1)
        for normal, end in zip(normals[::2], (low, high), strict=True)
    )
    turned = ((normals[2] - normals[0]) * sites.ahead).sum(axis=1)
    own = turned / (high.arc_length - low.arc_length)
    bend = own + (normals[1] * sites.aside).sum(axis=1)
    pointed = (own > 0) & (bend > POINTED * own) & (falls < 0) & (rises > 0)
    if not pointed.any():
        return None
    ends = [
        (end.arc_length[pointed], slope[pointed]) for end, slope in ((low, falls), (high, rises))
    ]
    sites = _nearest(around_it, near, shape, sites.of(pointed), *ends, POINTED * own[pointed])
    elements, _ = shape.elements_at(sites.arc_length)
    # Of several on one element the nearest; the others are kept once they push.
    order = np.argsort(contact.value(sites.position, sites.features))
    elements, first = np.unique(elements[order], return_index=True)
    return elements, sites.of(order[first])


def _kept(around_it, look, near, pushed, features):
    """Elements (m,) that an obstacle pushed at last with another feature than one of those (n, 12) that they are given
    now, and where and with what."""
    if pushed is None:
        return None
    kept = pushed.owners == around_it.indices[near.obstacle]
    now, even = contact.value(pushed.position, features[pushed.elements]), EVEN * around_it.radius
    kept &= np.abs(pushed.gap - now) > even
    if not kept.any():
        return None
    # One that the surface has left is none any more: it would keep the cable away for ever.
    there = around_it.nearest_of(near.obstacle, pushed.position[kept]).distance - around_it.keep
    kept[kept] = there < pushed.gap[kept] + even
    if not kept.any():
        return None
    elements, first = np.unique(pushed.elements[kept], return_index=True)
    sites = _Sites.at(look.shape, pushed.arc_length[kept][first])
    sites.features[:], sites.slides[:] = pushed.features[kept][first], pushed.slides[kept][first]
    return elements, sites


@dataclass(frozen=True, eq=False)
class _Sites:
    """Places on a cable: ``arc_length`` (…), ``position`` (…, 3) and its derivatives ``ahead`` and ``aside``; and what
    they keep away from, ``features`` (…, 12) and ``slides`` (…) as in ``Places``."""

    arc_length: np.ndarray
    position: np.ndarray
    ahead: np.ndarray
    aside: np.ndarray
    features: np.ndarray
    slides: np.ndarray

    @classmethod
    def at(cls, shape, arc_length) -> "_Sites":
        """Of a shape, that keep away from nothing: by its cubic, for its frames turn evenly between nodes."""
        elements, share = shape.elements_at(arc_length)
        position, slope, bend = shape.cubic(elements, share)
        return cls(
            arc_length,
            position,
            slope / np.linalg.norm(slope, axis=-1)[..., None],
            bend / shape.steps[elements][..., None] ** 2,
            np.tile(contact.NONE, (*arc_length.shape, 1)),
            np.zeros(arc_length.shape),
        )

    def of(self, which) -> "_Sites":
        """Some of them."""
        return _Sites(*(each[which] for each in vars(self).values()))

    def put(self, index, others):
        """Others in place of some."""
        for own, other in zip(vars(self).values(), vars(others).values(), strict=True):
            own[index] = other

    def along(self):
        """(m,) slope of the gap along the cable, and its bend: that of the feature itself, and of both."""
        steepest = contact.slope(self.position, self.features)
        own = (self.ahead * contact.bent(self.ahead, self.features)).sum(axis=1)
        slope = (steepest * self.ahead).sum(axis=1)
        return slope, own, own + (steepest * self.aside).sum(axis=1)


def _nearest(around_it, near, shape, sites, begin, end, least) -> _Sites:
    """Where an obstacle is nearest, from ``sites`` between ``begin`` and ``end``: arc lengths (m,) and the slopes (m,)
    of the gap there, negative and positive. Its bend is ``least`` (m,) at least."""
    (low, falls), (high, rises) = begin, end
    last = np.full(len(low), -1)
    for looks in range(1, LOOKS + 1):
        what = around_it.nearest_of(near.obstacle, sites.position)
        sites.features[:] = contact.parameters(what, around_it.keep)
        slope, own, bend = sites.along()
        place, before = sites.arc_length, slope < 0
        low, falls = np.where(before, place, low), np.where(before, slope, falls)
        high, rises = np.where(before, high, place), np.where(before, rises, slope)
        # Facets have one slope each: the place is at the edge between two of them, and where that is on one side twice
        # the slopes tell nothing.
        share = falls / np.minimum(falls - rises, -1e-300)
        share = np.where(before == last, 0.5, share.clip(0.1, 0.9))
        then, last = low + share * (high - low), before
        newton = place - slope / np.where(bend > 0, bend, np.inf)
        then = np.where((own > 0) & (low <= newton) & (newton <= high), newton, then)
        if looks == LOOKS or (np.abs(then - place) < SAME * around_it.radius).all():
            break
        sites = _Sites.at(shape, then)
    sites.slides[:] = 1 / np.maximum(bend, least)
    return sites
