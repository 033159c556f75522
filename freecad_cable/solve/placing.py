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
from .leaving import Near, leave

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
LOOKS = 5
"""Looks for the nearest place between two samples."""


def places(around_it, look, reach, leaving=False, pushed=None) -> Places | None:
    """Of the elements of a shape, where they keep away from obstacles within ``reach``; None if nothing is.
    ``leaving``: whether what is inside an obstacle is to leave it. ``pushed``: where obstacles pushed at last (see
    ``arms.Pushed``), which is kept: of two features that each alone let the cable into the obstacle at the other,
    both may be wanted."""
    fine, begin, elements = look.fine, look.begin, np.arange(len(look.begin) - 1)
    allowed = _allowed(around_it, look)
    beside = allowed.min(axis=1, initial=np.inf) < max(reach, around_it.keep)
    found, allowed = [look.found[i] for i in np.flatnonzero(beside)], allowed[beside]
    if not found:
        return None
    last_held = np.searchsorted(begin, around_it.held(fine)[-1])
    where = np.tile(np.where(elements < last_held, begin[:-1], begin[1:]), (len(found), 1))
    if leaving:
        # What is thinner than an element may be inside it alone.
        deepest = _deepest(allowed, begin)
        inside = np.take_along_axis(allowed, deepest, axis=1) < -around_it.keep
        where = np.where(inside, deepest, where)
    sites = _Sites.at(look.curve, fine.arc_length[np.tile(where, (2, 1))])
    gap = np.take_along_axis(allowed, where, axis=1)
    gap = np.concatenate([gap, np.full_like(gap, np.inf)])
    features, slides = np.tile(contact.NONE, (*gap.shape, 1)), np.zeros(gap.shape)

    def put(row, there, others, given, bend):
        sites.put((row, there), others)
        features[row, there], slides[row, there] = given, 1 / bend
        gap[row, there] = contact.value(others.position, given)

    for row, near in enumerate(found):
        there = np.flatnonzero(gap[row] < reach)
        what = near.of(where[row, there])
        features[row, there] = contact.parameters(what, around_it.keep)
        if leaving:
            inside = Near(near.obstacle, there, what)
            left = np.where(gap[row] < reach, gap[row], np.inf)
            leave(features[row], inside, sites.position[row], left, around_it)
            continue
        own = _pointed(around_it, look, near, allowed[row])
        if own is not None:
            # Nodes that are as near as the nearest place would share its force, and not slide.
            for place, nearest in zip(
                own[1].arc_length, contact.value(own[1].position, own[2]), strict=True
            ):
                beside = np.abs(sites.arc_length[row] - place) < around_it.radius
                gap[row, beside & (gap[row] < nearest + EVEN * around_it.radius)] = np.inf
            put(row, *own)
        kept = _kept(around_it, look, near, pushed, features[row])
        if kept is not None:
            put(row + len(found), *kept)
    near = gap < reach
    count = int(near.sum(axis=0).max(initial=0))
    if count == 0:
        return None
    count = next(n for n in (1, 2, MOST) if n >= min(count, MOST))
    order = np.argsort(gap, axis=0)[:count]
    order = np.pad(order, ((0, count - len(order)), (0, 0)), mode="edge").T
    elements = elements[:, None]
    unused = ~near[order, elements]
    unused[:, 1:] |= order[:, 1:] == order[:, :-1]
    which = np.tile(around_it.indices[[each.obstacle for each in found]], 2)
    return Places(
        np.where(unused[..., None], contact.NONE, features[order, elements]),
        sites.position[order, elements],
        sites.ahead[order, elements],
        sites.arc_length[order, elements] - fine.arc_length[begin[:-1], None],
        np.where(unused, 0.0, slides[order, elements]),
        np.where(unused, -1, which[order]),
    )


def _allowed(around_it, look):
    """(obstacles, samples) gaps of a look, infinite at and beside what is held."""
    gaps, s, begin = look.gaps.copy(), look.fine.arc_length, look.begin
    for node in around_it.held(look.fine):
        k = np.searchsorted(begin, node)
        beside = s[begin[[max(k - 1, 0), min(k + 1, len(begin) - 1)]]]
        share = BESIDE_HELD if np.isinf(gaps[:, node]).all() else 0.0
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
    """Elements (m,) to which an obstacle is nearest at a place, and these (see ``_nearest``); None if there are
    none. ``gap`` (samples,)."""
    fine = look.fine
    before, here, after = gap[:-2], gap[1:-1], gap[2:]
    # Where a neighbour is infinite, nothing is known of the place between; inside, the way out is not along a normal.
    lowest = (here <= before) & (here < after) & (np.abs(here) < around_it.keep)
    samples = 1 + np.flatnonzero(lowest & np.isfinite(before) & np.isfinite(after))
    if not len(samples):
        return None
    sites = _Sites.at(look.curve, fine.arc_length[samples])
    normals = [near.of(samples + side).normal for side in (-1, 0, 1)]
    ends = [fine.arc_length[samples + side] for side in (-1, 1)]
    slopes = [
        (normal * _Sites.at(look.curve, end).ahead).sum(axis=1)
        for normal, end in zip(normals[::2], ends, strict=True)
    ]
    own = ((normals[2] - normals[0]) * sites.ahead).sum(axis=1) / (ends[1] - ends[0])
    bend = own + (normals[1] * sites.aside).sum(axis=1)
    pointed = (own > 0) & (bend > POINTED * own) & (slopes[0] < 0) & (slopes[1] > 0)
    if not pointed.any():
        return None
    ends, slopes = ([each[pointed] for each in pair] for pair in (ends, slopes))
    sites, features, bend = _nearest(
        around_it, near, look.curve, sites.of(pointed), ends, slopes, POINTED * own[pointed]
    )
    nodes = fine.arc_length[look.begin]
    elements = np.searchsorted(nodes, sites.arc_length, "right") - 1
    # Of several on one element the nearest; the others are kept once they push.
    order = np.argsort(contact.value(sites.position, features))
    elements, first = np.unique(elements[order].clip(0, len(nodes) - 2), return_index=True)
    first = order[first]
    return elements, sites.of(first), features[first], bend[first]


def _kept(around_it, look, near, pushed, features):
    """Elements (m,) that an obstacle pushed at last with another feature than one of those (n, 12) that they are given
    now, and where, with what and with which bend of the gap."""
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
    nodes = look.fine.arc_length[look.begin[elements]]
    sites = _Sites.at(look.curve, nodes + pushed.beyond[kept][first])
    slides = pushed.slides[kept][first]
    bend = np.divide(1.0, slides, out=np.full_like(slides, np.inf), where=slides > 0)
    return elements, sites, pushed.features[kept][first], bend


@dataclass(frozen=True, eq=False)
class _Sites:
    """Places on a cable: ``arc_length`` (…), ``position`` (…, 3) and its derivatives ``ahead`` and ``aside``."""

    arc_length: np.ndarray
    position: np.ndarray
    ahead: np.ndarray
    aside: np.ndarray

    @classmethod
    def at(cls, curve, arc_length) -> "_Sites":
        """Of a curve (see ``Look``)."""
        slope = curve(arc_length, 1)
        ahead = slope / np.linalg.norm(slope, axis=-1)[..., None]
        return cls(arc_length, curve(arc_length), ahead, curve(arc_length, 2))

    def of(self, which) -> "_Sites":
        """Some of them."""
        return _Sites(*(each[which] for each in vars(self).values()))

    def put(self, index, others):
        """Others in place of some."""
        for own, other in zip(vars(self).values(), vars(others).values(), strict=True):
            own[index] = other

    def along(self, features):
        """(m,) slope of the gap along the cable, and its bend: that of the feature itself, and of both."""
        steepest = contact.slope(self.position, features)
        own = (self.ahead * contact.bent(self.ahead, features)).sum(axis=1)
        slope = (steepest * self.ahead).sum(axis=1)
        return slope, own, own + (steepest * self.aside).sum(axis=1)


def _nearest(around_it, near, curve, sites, ends, slopes, least):
    """(sites, features (m, 12), bend of the gap (m,), at ``least`` so much) where an obstacle is nearest between two
    ``ends`` (m,), from ``sites`` between them; there the gap has these ``slopes`` (m,), negative and positive."""
    (low, high), (falls, rises) = ends, slopes
    for looks in range(1, LOOKS + 1):
        what = around_it.nearest_of(near.obstacle, sites.position)
        features = contact.parameters(what, around_it.keep)
        slope, own, bend = sites.along(features)
        place, before = sites.arc_length, slope < 0
        low, falls = np.where(before, place, low), np.where(before, slope, falls)
        high, rises = np.where(before, high, place), np.where(before, rises, slope)
        # Facets have one slope each: the place is at the edge between two of them.
        share = falls / np.minimum(falls - rises, -1e-300)
        then = low + share.clip(0.1, 0.9) * (high - low)
        newton = place - slope / np.where(bend > 0, bend, np.inf)
        then = np.where((own > 0) & (low <= newton) & (newton <= high), newton, then)
        if looks == LOOKS or (np.abs(then - place) < SAME * around_it.radius).all():
            break
        sites = _Sites.at(curve, then)
    return sites, features, np.maximum(bend, least)
