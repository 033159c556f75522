# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a tube passes through itself."""

import numpy as np

from ..errors import DocumentError
from ..geometry import rotation

CHORDS = 4
"""Chords per span …"""

MOST_CHORDS = 1200
"""… and at most so many in all, because all pairs of them are looked at."""

LEAST_TURN = 2.5
"""[rad] A curve must turn by π to come back beside itself, and to bring an end face there a little less."""

PRESSED = 0.01
"""Share of the radius by which parts may overlap, so that touching is no overlap."""


def refuse_overlap(pieces, radius):
    """``DocumentError`` if the tube of ``radius`` [mm] about the centreline passes through itself.

    pieces: ``Quintic`` functions whose first three values are the centreline. The discs across the
    cable at two points cannot meet if the distance of the points exceeds what the discs reach
    towards each other: each its radius times the sine between its tangent and the line that joins
    the points. So neighbours along the cable do not count, nor two ends that meet face to face.
    """
    point, tangent, place = _samples(pieces)
    start, chord = point[:-1], np.diff(point, axis=0)
    length = np.linalg.norm(chord, axis=1)
    bend = np.arccos(np.clip(np.sum(tangent[1:] * tangent[:-1], axis=1), -1, 1))
    turn = np.concatenate(([0.0], np.cumsum(bend)))
    middle = start + chord / 2
    i, j = np.nonzero(turn[1:] - turn[:-1, None] >= LEAST_TURN)
    near = np.linalg.norm(middle[j] - middle[i], axis=1) < 2 * radius + (length[i] + length[j]) / 2
    i, j = i[near], j[near]
    if not len(i):
        return
    share_i, share_j = _closest(start[i], chord[i], start[j], chord[j])
    first, second = _between(point, i, share_i), _between(point, j, share_j)
    distance = np.linalg.norm(second - first, axis=1)
    reach = sum(
        np.linalg.norm(rotation.cross(second - first, _between(tangent, k, share)), axis=1)
        for k, share in ((i, share_i), (j, share_j))
    ) / np.maximum(distance, 1e-300)
    # Where the two points are one there is no line between them; they meet, but for the two ends.
    ends = (i == 0) & (share_i == 0) & (j == len(chord) - 1) & (share_j == 1)
    reach[(distance < 1e-6 * radius) & ~ends] = 2
    # The curve is off its chords by a sagitta of length × turn / 8.
    off = length * bend / 8
    depth = radius * reach * (1 - PRESSED) - distance - off[i] - off[j]
    k = int(np.argmax(depth))
    if depth[k] > 0:
        raise DocumentError(
            "The cable passes through itself: its points at "
            f"{_between(place[:, None], i, share_i)[k, 0]:.4g} mm and "
            f"{_between(place[:, None], j, share_j)[k, 0]:.4g} mm from its start are "
            f"{distance[k]:.3g} mm apart."
        )


def _between(samples, index, share):
    """Linear interpolation (m, d) in samples at index + share, both (m,)."""
    return samples[index] + share[:, None] * (samples[index + 1] - samples[index])


def _samples(pieces):
    """Points and unit tangents (m, 3) on the centreline and their parameters (m,), from end to end."""
    share = np.arange(CHORDS) / CHORDS
    values = [[x[..., :3].reshape(-1, 3) for x in piece.at(share)] for piece in pieces]
    point, tangent = (np.concatenate(x) for x in zip(*values, strict=True))
    place = np.concatenate(
        [(piece.parameter[:-1, None] + share * piece.step[:, None]).ravel() for piece in pieces]
    )
    some = slice(None, None, -(-len(place) // MOST_CHORDS))
    last = pieces[-1]
    point = np.concatenate([point[some], last.value[-1:, :3]])
    tangent = np.concatenate([tangent[some], last.first[-1:, :3]])
    tangent = tangent / np.linalg.norm(tangent, axis=1, keepdims=True)
    return point, tangent, np.concatenate([place[some], last.parameter[-1:]])


def _closest(p, u, q, v):
    """Shares (m,) of the nearest points of the segments p … p + u and q … q + v, all (m, 3).

    Ericson, Real-Time Collision Detection, 5.1.9.
    """
    uu, uv, vv = (np.einsum("nk,nk->n", a, b) for a, b in ((u, u), (u, v), (v, v)))
    uw, vw = (np.einsum("nk,nk->n", a, p - q) for a in (u, v))
    skew = uu * vv - uv**2
    parallel = skew <= 1e-12 * uu * vv
    share_p = np.where(
        parallel, 0.0, np.clip((uv * vw - vv * uw) / np.where(parallel, 1, skew), 0, 1)
    )
    share_q = np.clip((uv * share_p + vw) / vv, 0, 1)
    return np.clip((uv * share_q - uw) / uu, 0, 1), share_q
