# SPDX-License-Identifier: LGPL-2.1-or-later
"""From what a cable links to as obstacles to those of its scene: solids, wherever parts, assemblies and links put
them, and other cables. Of a part or an assembly what is visible counts."""

import math
from dataclasses import dataclass

import numpy as np
import Part
from FreeCAD import Matrix

from ..errors import DocumentError, ProblemError
from ..problem import Free, Scene, Tube
from ..problem.surroundings import in_reach
from ..shape import obstacle
from ..shape.centreline import centreline
from ..shape.units import from_si, vectors_to_si
from .complaint import OBSTACLE, in_properties
from .observer import dependents
from .property_table import wrong
from .read_held import read_held
from .reference import is_plain_group, pairs, refuse_stray, shape_at
from .similarity import similarity
from .stored_solution import nodes

CROWDED = 0.1
"""Depth, in radii of the cable, above which it is no longer a matter of rounding."""

SAGITTA = 1 / 20
"""Distance of a tube from the cable that it stands for, as a share of the cable's radius."""


@dataclass(frozen=True)
class Run:
    """A cable, where a part, an assembly or a link puts it."""

    label: str
    cable: object
    matrix: Matrix

    @property
    def scale(self) -> float:
        """Errors: ``DocumentError`` if a link stretches or mirrors it."""
        return similarity(self.label, self.matrix)[1]


@dataclass(frozen=True)
class Piece:
    """A solid on the way to an obstacle; triangles are made only of those in reach."""

    label: str
    shape: Part.Shape
    placed: obstacle.Placed

    @property
    def bounds(self) -> np.ndarray:
        return self.placed.bounds


def read_obstacles(cable, held: Scene) -> tuple:
    """The obstacles that the cable of a scene without them may reach. Errors: ``DocumentError``."""
    found = _all(cable)
    near = in_reach(held, found)
    return tuple(
        _stated(cable, each, held.rod.radius)
        for each, is_near in zip(found, near, strict=True)
        if is_near
    )


def read_boxes(cable) -> list:
    """(2, 3) [m] corners of a box around each obstacle, also of those that the cable cannot reach. Errors:
    ``DocumentError``."""
    return [each.bounds for each in _all(cable)]


def _all(cable):
    given, followers = pairs(cable.Obstacles), [cable, *dependents(cable)]
    try:
        refuse_stray(cable, given)
        return [each for pair in given for each in _read(pair, followers)]
    except DocumentError as error:
        raise wrong(cable, "Obstacles", str(error)) from None


def _read(pair, followers):
    root = pair[0]
    if any(obj is root for obj in followers):
        raise DocumentError(
            f"has {root.Label}, which follows from the cable itself, so neither can be first; "
            "of two cables, only one can have the other as an obstacle."
        )
    found = [tube(each) if isinstance(each, Run) else each for each in pieces(*pair)]
    if not found:
        raise DocumentError(f"has {root.Label}, which has no solid; choose parts with solids.")
    return found


def pieces(root, way):
    """The solids and cables at the end of a way down from ``root``, as ``Piece`` and ``Run``. Errors:
    ``DocumentError``."""
    obj = root.getSubObject(way, retType=1) if way else root
    if obj is None:
        raise DocumentError(f"has {way} of {root.Label}, which was deleted or moved.")
    source = obj.getLinkedObject(True)
    if hasattr(source, "NodePosition"):
        yield Run(obj.Label, source, root.getSubObject(way, retType=4))
    elif source.isDerivedFrom("Part::Feature") and (
        obj is source or not getattr(obj, "ElementCount", 0)
    ):
        for solid, placed in obstacle.solids(source.FullName, shape_at(root, way)):
            yield Piece(obj.Label, solid, placed)
    else:
        for step in obj.getSubObjects():
            child = obj.getSubObject(step, retType=1)
            # What is in a plain group is in the container, too.
            if child and not is_plain_group(child) and _is_visible(obj, step, child):
                yield from pieces(root, way + step)


def _is_visible(parent, step, child):
    shown = parent.isElementVisible(step.rstrip("."))
    return child.Visibility if shown < 0 else bool(shown)


def tube(run) -> Tube:
    """A cable as what another one must not enter. Errors: ``DocumentError`` if it is not solved, or stretched."""
    cable = run.cable
    if not cable.SolvedInputs:
        raise DocumentError(cable.Status or f"{cable.Label} is not solved; recompute it.")
    radius = read_held(cable).rod.radius
    curve = centreline(nodes(cable))
    # A chord of length h is h²/8R off an arc of radius R.
    chord = math.sqrt(8 * SAGITTA * from_si("length", radius) * cable.SmallestBendRadius.Value)
    count = 2 + int(curve.length() / chord)
    points = [run.matrix.multVec(point) for point in curve.discretize(Number=count)]
    return Tube(vectors_to_si(points), radius * run.scale, place=OBSTACLE + run.label)


def crowded(scene) -> list[str]:
    """Where a cable is held inside another one, which it then leaves by the sharpest of bends, as sentences."""
    held = [
        each for each in (scene.start, *scene.supports, scene.end) if not isinstance(each, Free)
    ]
    others = [each for each in scene.obstacles if isinstance(each, Tube)]
    return [
        f"Warning: at {each.place} it is held {from_si('length', depth):.3g} mm inside "
        f"{other.place.removeprefix(OBSTACLE)}; two cables do not fit there, so hold one of them beside the other."
        for each in held
        for other in others
        if (depth := scene.rod.radius - other.nearest(each.position[None]).distance[0])
        > CROWDED * scene.rod.radius
    ]


def _stated(cable, found, radius):
    if isinstance(found, Tube):
        return found
    try:
        return found.placed.mesh(radius, OBSTACLE + found.label)
    except ProblemError as error:
        raise in_properties(cable, error) from None
