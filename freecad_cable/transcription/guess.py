# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the iteration starts: a smooth curve of the right length between the ends, with frames along it."""

from dataclasses import replace

import numpy as np
from scipy.integrate import trapezoid

from ..geometry import rotation
from ..geometry.curves import catenary, hermite
from ..geometry.guess import perpendicular
from ..geometry.layers import Layered
from ..problem import Clamped, Pinned, Scene
from .scaling import Scaling
from .shape import Shape
from .waypoints import breaks, waypoints

HEAVY = 50.0
"""Weight ratio w L³/EI above which a hanging chain is nearer to the cable than a spline (measured: from a
spline the iteration begins to fail at about 1e4, from a catenary below about 10 it takes longer)."""

NARROW = 0.05
"""Width of a layer, relative to the length, below which a first mesh gathers nodes there."""

TAUT = 0.02
"""Slack, relative to the length, below which a cable without weight may bend in layers only: with larger ones it bends
over a tenth of its length at least."""

ROLLS = 24
"""Angles of an end that lets the cable roll, among which a guess chooses."""

LADEN = 400.0
"""Weight ratio from which a slack cable may bend in layers only: they are √(EI/T) wide, about a twentieth of it."""

STRETCHED = 0.01
"""Stretch from which a cable is no longer near to one that does not stretch."""

LEAN = 1e-3
"""Sideways disturbance of a start, in cable lengths: a start that is exactly symmetric converges to a saddle
with success. Far larger than rounding, far smaller than what changes the iteration count."""


def guess(scene: Scene, scaling: Scaling, arc_length, *, chain=None, sag=None, layered=()) -> Shape:
    """Nodes at ``arc_length`` (n+1,) in [0, 1], those of the supports among them, that satisfy the end conditions,
    nearly in equilibrium.

    The frames carry as little twist as the ends allow (see ``turned``). ``chain`` chooses between a hanging chain and a
    spline (None: by weight); ``sag`` (3,) sends the slack elsewhere than gravity.
    ``layered`` are the stretches that bend in layers only (see ``layers``); of a cable that is one such stretch
    forces and moments are known too.
    """
    position, tangent, force = _curve(scene, scaling, arc_length, chain, sag, layered)
    start = scene.start
    first = start.quaternion if isinstance(start, Clamped) else rotation.from_tangent(tangent[0])
    quaternion = rotation.transport(first, tangent)
    shape = rolled(scene, scaling, arc_length, position, quaternion)
    if force is None:
        return shape
    force = force * scaling.stiffness(scene.rod)[:2].prod() ** 0.5
    return _loaded(scene, scaling, replace(shape, force=force))


def holds_turns(scene: Scene) -> bool:
    """Whether a cable keeps the full turns that it has: both of its ends are clamped."""
    return isinstance(scene.start, Clamped) and isinstance(scene.end, Clamped)


def turned(scene: Scene, scaling: Scaling, shape: Shape, turns: int) -> Shape:
    """A guess for a cable that ``holds_turns``, with so many full turns more, spread evenly."""
    spin = np.outer(2 * np.pi * turns * shape.arc_length, (0.0, 0.0, 1.0))
    frames = rotation.multiply(shape.quaternion, rotation.exponential(spin))
    joints = [joint.node for joint in shape.joints]
    other = Shape.from_frames(shape.arc_length, shape.position, frames, joints)
    return (
        other if shape.force is None else _loaded(scene, scaling, replace(other, force=shape.force))
    )


def _loaded(scene, scaling, shape):
    """A guess whose forces are known, with the moments of its curvature."""
    bend = shape.strain[:, :3] - scene.rod.natural_curvature * scaling.length
    moment = scaling.stiffness(scene.rod)[:3] * bend
    return replace(shape, moment=np.einsum("kij,kj->ki", rotation.matrix(shape.quaternion), moment))


def layers(scene: Scene, scaling: Scaling) -> list[Layered | None]:
    """Of each stretch between held places, how it bends if it is so heavy or taut that it may do so in layers only."""
    weight = _weight(scene, scaling)
    held = waypoints(scene, scaling)
    found = []
    for a, b in zip(held, held[1:], strict=False):
        length = b.arc_length - a.arc_length
        slack = 1 - np.linalg.norm(b.position - a.position) / length
        plain = slack > TAUT and np.linalg.norm(weight) * length**3 < LADEN
        stretch = (
            None if plain else Layered(a.position, a.tangent, b.position, b.tangent, length, weight)
        )
        found.append(stretch if stretch is None or _hardly_stretches(scene, stretch) else None)
    return found


def hold(layered) -> list[Layered]:
    """Those of the stretches from ``layers`` that do bend in layers only."""
    return [each for each in layered if each is not None and each.valid]


def _hardly_stretches(scene, stretch):
    rod = scene.rod
    if rod.axial_stiffness is None or not stretch.valid:
        return True
    pull = np.linalg.norm(stretch.pull) * np.sqrt(np.prod(rod.bending_stiffness)) / rod.length**2
    return pull < STRETCHED * rod.axial_stiffness


def gathered_at(scene: Scene, scaling: Scaling, layered) -> list[tuple[float, float]]:
    """(arc length, width) of the bending layers that are narrow; ``layered`` as from ``layers``."""
    held, weight = waypoints(scene, scaling), np.linalg.norm(_weight(scene, scaling))
    found = []
    for a, b, stretch in zip(held, held[1:], layered, strict=False):
        if stretch is not None:
            found += zip((a.arc_length, b.arc_length), stretch.widths, strict=True)
    for holder, end, there in ((held[0], scene.start, 0.0), (held[-1], scene.end, 1.0)):
        below = abs(there - holder.arc_length)
        if not isinstance(end, Pinned) and holder.tangent is not None and weight * below > 0:
            found.append((holder.arc_length, (weight * below) ** -0.5))
    return [(place, width) for place, width in found if width is not None and width < NARROW]


def _weight(scene, scaling):
    """(3,) w L³/EI with its direction"""
    return scene.weight * scaling.length**3 / np.sqrt(np.prod(scene.rod.bending_stiffness))


def rolled(scene, scaling, arc_length, position, quaternion) -> Shape:
    """Frames without twist (n+1, 4) rolled about their tangents so that they satisfy the ends, the twist spread
    evenly beside the natural one."""
    natural_twist = scene.rod.natural_curvature[2] * scaling.length
    clamped = [isinstance(end, Clamped) for end in (scene.start, scene.end)]
    roll = 0.0
    if clamped[1]:
        last = rotation.multiply(rotation.conjugate(quaternion[-1]), scene.end.quaternion)
        roll = 2 * np.arctan2(last[3], last[0]) - natural_twist
        roll = (roll + np.pi) % (2 * np.pi) - np.pi
    spin = _spin(scene, scaling, arc_length, quaternion, clamped, roll) + natural_twist * arc_length
    spin = np.outer(spin, (0.0, 0.0, 1.0))
    joints = np.searchsorted(arc_length, np.array(breaks(scene, scaling)) - 1e-12)
    return Shape.from_frames(
        arc_length,
        position,
        rotation.multiply(quaternion, rotation.exponential(spin)),
        [int(node) for node in joints],
    )


def _spin(scene, scaling, arc_length, quaternion, clamped, roll):
    """(n+1,) turn of the frames beside the natural twist: from 0 at a clamped start to ``roll`` at a clamped end,
    evenly. An end that lets the cable roll gets the turn with which it bends most willingly."""
    rod = scene.rod
    natural = rod.natural_curvature * scaling.length
    if all(clamped) or (rod.isotropic and not natural[:2].any()):
        return roll * (arc_length if clamped[0] else np.ones_like(arc_length))
    turns = rotation.logarithm(
        rotation.multiply(rotation.conjugate(quaternion[:-1]), quaternion[1:])
    )
    steps, middle = np.diff(arc_length), (arc_length[1:] + arc_length[:-1]) / 2
    bend = (turns[:, 0] + 1j * turns[:, 1]) / steps
    tries = np.linspace(-np.pi, np.pi, ROLLS, endpoint=False)
    first = np.zeros(1) if clamped[0] else tries
    # A start that may roll may be turned by more or less than the end is from it.
    last = roll + 2 * np.pi * np.arange(-1, 2) if clamped[1] else tries
    first, change = (each.ravel() for each in np.meshgrid(first, last, indexing="ij"))
    if clamped[1]:
        change = change - first
    angle = first[:, None] + change[:, None] * middle + natural[2] * middle
    seen = bend * np.exp(-1j * angle) - (natural[0] + 1j * natural[1])
    stiffness = rod.stiffness
    energy = (stiffness[0] * seen.real**2 + stiffness[1] * seen.imag**2) @ steps
    best = np.argmin(energy + stiffness[2] * change**2)
    return first[best] + change[best] * arc_length


def roll_mismatch(scene: Scene, shape: Shape) -> float:
    """Twist [rad] that the frames of a guess carry beyond the natural one."""
    total = trapezoid(shape.strain[:, 2], shape.arc_length)
    return float(total - scene.rod.natural_curvature[2] * scene.rod.length)


def hangs(scaling: Scaling) -> bool:
    """Whether a guess is a chain by default."""
    return scaling.weight_ratio > HEAVY


def _curve(scene, scaling, arc_length, chain, sag, layered):
    """Position and tangent (n+1, 3): a curve between each two places that hold the cable, and its free ends; and the
    force per EI (n+1, 3), None if it is not known everywhere."""
    weight = _weight(scene, scaling)
    held = waypoints(scene, scaling)
    if chain is False or sag is not None or len(layered) != len(held) - 1:
        layered = [None] * (len(held) - 1)
    pieces, force = [], None
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
        if layered[k] is None or not layered[k].valid:
            pieces.append(_between(a, b, arc_length[inside], weight, chain, sag))
            continue
        position, tangent, pull = layered[k].at(arc_length[inside] - a.arc_length)
        pieces.append((position, tangent))
        force = pull if len(pull) == len(arc_length) else None
    if not isinstance(scene.end, Pinned):
        last = held[-1]
        here = arc_length[
            arc_length > last.arc_length if len(held) > 1 else arc_length >= last.arc_length
        ]
        pieces.append(_hanging(last.position, last.tangent, weight, here - last.arc_length))
    position, tangent = (np.vstack(part) for part in zip(*pieces, strict=True))
    return position, tangent, force


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
