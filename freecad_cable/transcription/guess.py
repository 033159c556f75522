# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the iteration starts: a smooth curve of the right length between the ends, with frames along it."""

import numpy as np
from scipy.integrate import trapezoid

from ..geometry import rotation
from ..geometry.curves import catenary, hermite
from ..geometry.guess import perpendicular
from ..problem import Clamped, Pinned, Scene
from .scaling import Scaling
from .shape import Shape
from .waypoints import breaks, waypoints

HEAVY = 50.0
"""Weight ratio w L³/EI above which a hanging chain is nearer to the cable than a spline (measured: from a
spline the iteration begins to fail at about 1e4, from a catenary below about 10 it takes longer)."""

LEAN = 1e-3
"""Sideways disturbance of a start, in cable lengths: a start that is exactly symmetric converges to a saddle
with success. Far larger than rounding, far smaller than what changes the iteration count."""


def guess(scene: Scene, scaling: Scaling, arc_length, *, turns=0, chain=None, sag=None) -> Shape:
    """Nodes at ``arc_length`` (n+1,) in [0, 1], those of the supports among them, that satisfy the end conditions,
    nearly in equilibrium.

    The frames carry as little twist as the ends allow, plus ``turns`` full turns. ``chain`` chooses
    between a hanging chain and a spline (None: by weight); ``sag`` (3,) sends the slack elsewhere than gravity.
    """
    position, tangent = _curve(scene, scaling, arc_length, chain, sag)
    start = scene.start
    first = start.quaternion if isinstance(start, Clamped) else rotation.from_tangent(tangent[0])
    quaternion = rotation.transport(first, tangent)
    return rolled(scene, scaling, arc_length, position, quaternion, turns)


def rolled(scene, scaling, arc_length, position, quaternion, turns=0) -> Shape:
    """Frames without twist (n+1, 4) rolled about their tangents so that they satisfy the ends, the twist spread
    evenly beside the natural one."""
    start = scene.start
    natural_twist = scene.rod.natural_curvature[2] * scaling.length
    if isinstance(scene.end, Clamped):
        last = rotation.multiply(rotation.conjugate(quaternion[-1]), scene.end.quaternion)
        roll = 2 * np.arctan2(last[3], last[0])
        if isinstance(start, Clamped):
            roll = roll - natural_twist
            roll = (roll + np.pi) % (2 * np.pi) - np.pi + natural_twist + 2 * np.pi * turns
            spin = roll * arc_length
        else:
            spin = roll + natural_twist * (arc_length - 1)
    else:
        spin = natural_twist * arc_length
    spin = np.outer(spin, (0.0, 0.0, 1.0))
    joints = np.searchsorted(arc_length, np.array(breaks(scene, scaling)) - 1e-12)
    return Shape.from_frames(
        arc_length,
        position,
        rotation.multiply(quaternion, rotation.exponential(spin)),
        [int(node) for node in joints],
    )


def roll_mismatch(scene: Scene, shape: Shape) -> float:
    """Twist [rad] that the frames of a guess carry beyond the natural one."""
    total = trapezoid(shape.strain[:, 2], shape.arc_length)
    return float(total - scene.rod.natural_curvature[2] * scene.rod.length)


def hangs(scaling: Scaling) -> bool:
    """Whether a guess is a chain by default."""
    return scaling.weight_ratio > HEAVY


def _curve(scene, scaling, arc_length, chain, sag):
    """Position and tangent (n+1, 3): a curve between each two places that hold the cable, and its free ends."""
    weight = scene.weight * scaling.length**3 / np.sqrt(np.prod(scene.rod.bending_stiffness))
    held = waypoints(scene, scaling)
    pieces = []
    if not isinstance(scene.start, Pinned):
        first = held[0]
        whole = len(held) == 1 and isinstance(scene.end, Pinned)
        here = arc_length if whole else arc_length[arc_length < first.arc_length]
        tangent = None if first.tangent is None else -first.tangent
        position, tangent = _hanging(first.position, tangent, weight, first.arc_length - here)
        pieces.append((position, -tangent))
    for k, (a, b) in enumerate(zip(held, held[1:], strict=False)):
        last = k == len(held) - 2
        inside = (arc_length >= a.arc_length) & (
            (arc_length <= b.arc_length) if last else (arc_length < b.arc_length)
        )
        pieces.append(_between(a, b, arc_length[inside], weight, chain, sag))
    if not isinstance(scene.end, Pinned):
        last = held[-1]
        here = arc_length[
            arc_length > last.arc_length if len(held) > 1 else arc_length >= last.arc_length
        ]
        pieces.append(_hanging(last.position, last.tangent, weight, here - last.arc_length))
    position, tangent = (np.vstack(part) for part in zip(*pieces, strict=True))
    return position, tangent


def _between(a, b, arc_length, weight, chain, sag):
    length = b.arc_length - a.arc_length
    length = max(length, float(np.linalg.norm(b.position - a.position)) * (1 + 1e-9))
    sag = weight if sag is None else sag
    if np.linalg.norm(weight) * length**3 > HEAVY if chain is None else chain:
        down = sag if sag.any() else perpendicular(b.position - a.position)
        curve = catenary(a.position, b.position, length, down)
    else:
        curve = hermite(a.position, a.tangent, b.position, b.tangent, length, bulge=sag)
    share = (arc_length - a.arc_length) / (b.arc_length - a.arc_length)
    position, tangent = curve.at(share * curve.length)
    lean = LEAN * length * np.sin(np.pi * share) ** 2
    return position + np.outer(lean, _sideways(position)), tangent


def _sideways(position):
    """Unit vector most nearly normal to the plane of the points (m, 3)."""
    return np.linalg.svd(position - position.mean(axis=0), full_matrices=True)[2][2]


def _hanging(origin, tangent, weight, arc_length):
    """A curve from ``origin`` that leaves along ``tangent`` and bends towards the weight; (position, tangent).

    It turns over the gravito-bending length (EI/w)^(1/3), the scale on which weight wins over bending.
    """
    ratio = np.linalg.norm(weight)
    if ratio == 0:
        tangent = np.array([0.0, 0.0, 1.0]) if tangent is None else tangent
        return origin + np.outer(arc_length, tangent), np.tile(tangent, (len(arc_length), 1))
    down = weight / ratio
    tangent = down if tangent is None else tangent
    reach = 2 / max(ratio, 1e-3) ** (1 / 3)
    turn = rotation.logarithm(rotation.shortest_arc(tangent, down))
    fine = np.linspace(0, max(arc_length.max(initial=0.0), 1e-9), 401)
    share = 1 - np.exp(-fine / reach)
    tangents = rotation.rotate(rotation.exponential(np.outer(share, turn)), tangent)
    middle = (tangents[1:] + tangents[:-1]) / 2 * np.diff(fine)[:, None]
    points = origin + np.vstack([np.zeros(3), np.cumsum(middle, axis=0)])
    pick = lambda columns: np.stack(  # noqa: E731
        [np.interp(arc_length, fine, column) for column in columns.T], axis=1
    )
    tangents = pick(tangents)
    return pick(points), tangents / np.linalg.norm(tangents, axis=1)[:, None]
