# SPDX-License-Identifier: LGPL-2.1-or-later
"""A clamp at a given arc length cuts a cable in two that know nothing of each other: each stretch is solved alone, and
one that has not changed since an earlier solution is not solved again."""

from dataclasses import fields, is_dataclass, replace

import numpy as np

from ..geometry import rotation
from ..geometry.self_contact import self_penetrations
from ..problem import Clamp, Clamped, Free, Scene
from ..result import Balance, Energy, Load, Solution
from ..status import Status
from .earlier import curvature

DEEP = 0.01
"""Depth, in radii, to which a cable may be in itself."""


def cuts(scene: Scene) -> list[int]:
    """Indices of the supports that hold position and frame at a given arc length."""
    return [
        i for i, each in enumerate(scene.supports) if isinstance(each, Clamp) and not each.slides
    ]


def solved(scene: Scene, solve, start: Solution | None) -> Solution:
    """The solution of a scene with cuts, from those of its stretches. ``solve(scene, start=None)`` finds one."""
    scenes, found, kept = _split(scene), [], 0
    apart = start is not None and len(start.stretches) == len(scenes)
    before = start.stretches if apart else _cut(start, scene)
    for part, earlier in zip(scenes, before, strict=True):
        if apart and earlier.status.success and _same(part, earlier.scene):
            found.append(replace(earlier, anew=False))
            kept += 1
        else:
            found.append(solve(part, start=earlier))
        if found[-1].position is None:
            where = f"between {part.start.place} and {part.end.place}"
            message = f"The stretch {where}: {found[-1].message}"
            return replace(found[-1], scene=scene, message=message, stretches=())
    return _joined(scene, found, kept)


def touch(solution) -> bool:
    """Whether one stretch runs through another: then they are no longer independent."""
    if not solution.status.success:
        return False
    scene, held = solution.scene, list(solution.support_nodes)
    held += [0] * (not isinstance(scene.start, Free))
    held += [len(solution.arc_length) - 1] * (not isinstance(scene.end, Free))
    nodes = solution.arc_length, solution.position, solution.quaternion
    found = self_penetrations(*nodes, scene.rod.radius, sorted(held))
    return any(depth > DEEP * scene.rod.radius for depth, _, _ in found)


def _split(scene) -> list[Scene]:
    rod, at = scene.rod, cuts(scene)
    places = [0.0, *(scene.supports[i].arc_length for i in at), rod.length]
    clamps = [
        Clamped(each.position, each.quaternion, place=each.place)
        for each in (scene.supports[i] for i in at)
    ]
    holders = [scene.start, *clamps, scene.end]
    between = [-1, *at, len(scene.supports)]
    scenes = []
    for k, (first, last) in enumerate(zip(holders, holders[1:], strict=False)):
        a, b = places[k : k + 2]
        supports = tuple(
            each if each.slides else replace(each, arc_length=each.arc_length - a)
            for each in scene.supports[between[k] + 1 : between[k + 1]]
        )
        options = scene.options
        share = (b - a) / rod.length
        elements = options.elements and max(4, round(options.elements * share))
        tolerance = min(options.tolerance / share, 0.1)
        scenes.append(
            replace(
                scene,
                rod=replace(rod, length=b - a),
                start=first,
                end=last,
                supports=supports,
                options=replace(options, tolerance=tolerance, elements=elements),
            )
        )
    return scenes


def _cut(start, scene) -> list[Solution | None]:
    """The parts of an earlier solution that is one piece, as starts for the stretches of a scene; without their own
    scenes, so not as answers."""
    at = cuts(scene)
    if start is None or start.position is None or len(start.support_nodes) != len(scene.supports):
        return [None] * (len(at) + 1)
    before = _split(start.scene) if cuts(start.scene) == at else _split(scene)
    ends = [0, *(start.support_nodes[i] for i in at), len(start.arc_length) - 1]
    held, parts = [-1, *at, len(scene.supports)], []
    for k, (a, b) in enumerate(zip(ends, ends[1:], strict=False)):
        inside = slice(held[k] + 1, held[k + 1])
        span = start.arc_length[[a, b]]
        names = "position", "quaternion", "force", "moment", "curvature"
        nodes = {name: getattr(start, name)[a : b + 1].copy() for name in names}
        if k > 0:
            _beyond(nodes, start.support_reactions[at[k - 1]], scene.rod)
        parts.append(
            replace(
                start,
                **nodes,
                scene=before[k],
                arc_length=start.arc_length[a : b + 1] - span[0],
                support_nodes=tuple(node - a for node in start.support_nodes[inside]),
                support_reactions=start.support_reactions[inside],
                contacts=tuple(
                    each for each in start.contacts if span[0] <= each.arc_length <= span[1]
                ),
            )
        )
    return parts


def _beyond(nodes, reaction, rod):
    """At the first of some nodes, what is just beyond the support there."""
    nodes["force"][0] -= reaction.force
    nodes["moment"][0] -= reaction.moment
    nodes["curvature"][0] = curvature(rod, nodes["quaternion"][0], nodes["moment"][0])


def _same(a, b) -> bool:
    """Whether two statements say the same."""
    if a is b:
        return True
    if type(a) is not type(b):
        return False
    if is_dataclass(a):
        return all(_same(getattr(a, f.name), getattr(b, f.name)) for f in fields(a))
    if isinstance(a, tuple):
        return len(a) == len(b) and all(map(_same, a, b))
    return bool(np.array_equal(a, b))


def _joined(scene, parts, kept) -> Solution:
    lengths = [part.scene.rod.length for part in parts]
    offsets = np.concatenate([[0.0], np.cumsum(lengths)[:-1]])

    def nodes(name, shift=0.0):
        arrays = [getattr(part, name) + shift * a for part, a in zip(parts, offsets, strict=True)]
        return np.concatenate([arrays[0], *(array[1:] for array in arrays[1:])])

    firsts = np.concatenate([[0], np.cumsum([len(part.arc_length) - 1 for part in parts])])
    reactions, places = list(parts[0].support_reactions), list(parts[0].support_nodes)
    for part, before, first in zip(parts[1:], parts, firsts[1:], strict=False):
        reactions.append(_sum(before.end_reaction, part.start_reaction))
        reactions += part.support_reactions
        places += [int(first), *(int(first) + node for node in part.support_nodes)]
    bends = [
        (part.min_bend_radius[0], part.min_bend_radius[1] + a)
        for part, a in zip(parts, offsets, strict=True)
    ]
    worst = max(parts, key=lambda part: list(Status).index(part.status))
    message = worst.message
    if not worst.status.success:
        where = f"between {worst.scene.start.place} and {worst.scene.end.place}"
        message = f"The stretch {where}: {worst.message}"
    clearances = [part.min_clearance for part in parts if part.min_clearance is not None]
    return Solution(
        scene=scene,
        status=worst.status,
        message=message,
        arc_length=nodes("arc_length", 1.0),
        position=nodes("position"),
        quaternion=rotation.continuous(nodes("quaternion")),
        force=nodes("force"),
        moment=nodes("moment"),
        curvature=nodes("curvature"),
        energy=_energy(scene, parts),
        start_reaction=parts[0].start_reaction,
        end_reaction=parts[-1].end_reaction,
        support_reactions=tuple(reactions),
        support_nodes=tuple(places),
        min_bend_radius=min(bends),
        formed=tuple(
            replace(piece, start=piece.start + a, end=piece.end + a)
            for part, a in zip(parts, offsets, strict=True)
            for piece in part.formed
        ),
        contacts=tuple(
            replace(
                contact,
                arc_length=contact.arc_length + a,
                other_arc_length=None
                if contact.other_arc_length is None
                else contact.other_arc_length + a,
            )
            for part, a in zip(parts, offsets, strict=True)
            for contact in part.contacts
        ),
        min_clearance=min(clearances, default=None),
        anew=any(part.anew for part in parts),
        stable=all(part.stable for part in parts),
        position_error=max(part.position_error for part in parts),
        balance=Balance(
            max(part.balance.moment for part in parts), max(part.balance.force for part in parts)
        ),
        left_out=_left_out(parts, kept),
        kept=tuple(dict.fromkeys(word for part in parts for word in part.kept)),
        solver=_effort(parts),
        stretches=tuple(parts),
    )


def _sum(a: Load, b: Load) -> Load:
    return Load(a.force + b.force, a.moment + b.moment)


def _energy(scene, parts):
    """Each part measures gravity from its own start."""
    origin = parts[0].position[0]
    lift = sum(
        -scene.weight @ (part.position[0] - origin) * part.scene.rod.length for part in parts
    )
    energies = [part.energy for part in parts]
    return Energy(
        sum(e.bending for e in energies),
        sum(e.torsion for e in energies),
        sum(e.stretch for e in energies),
        sum(e.gravity for e in energies) + float(lift),
    )


def _left_out(parts, kept):
    sentences = dict.fromkeys(sentence for part in parts for sentence in part.left_out)
    found = [
        f"what the {len(parts)} stretches between clamps have to do with each other: each is solved alone (exact)"
    ]
    if kept:
        found.append(f"{kept} of {len(parts)} stretches: unchanged since the last solution (exact)")
    return (*sentences, *found)


def _effort(parts):
    efforts = [part.solver for part in parts]
    total = {
        name: sum(effort[name] for effort in efforts)
        for name in ("elements", "iterations", "build_time", "solve_time")
    }
    return {"name": efforts[0]["name"], "scheme": efforts[0]["scheme"]} | total
