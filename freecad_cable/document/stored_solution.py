# SPDX-License-Identifier: LGPL-2.1-or-later
"""The solution that a cable keeps in the file: a document opens and draws without solving, and the next solve
starts from here.

Arrays in SI units, as the core has them, so that they come back bit by bit.
"""

import hashlib
from dataclasses import fields, is_dataclass, replace
from functools import lru_cache

import numpy as np
from FreeCAD import Vector

from ..errors import ProblemError
from ..geometry import rotation
from ..problem import End, Mesh, Obstacle, Ring, Scene, Support
from ..result import Contact, Load, Solution
from ..shape.nodes import Nodes
from ..shape.units import to_si, vector_to_si
from ..status import Status
from .property_table import Prop

PLACE_DECIMALS = 10
"""Of a position in metres, and of an axis: OCCT takes points nearer than 1e-7 mm for one."""

DIGITS = 12
"""Significant, of any other number; files keep 16."""

NODES = {
    "NodeArcLength": ("arc_length", "FloatList", "arc length of the nodes [m]"),
    "NodePosition": ("position", "VectorList", "position of the nodes [m]"),
    "NodeQuaternion": ("quaternion", "FloatList", "orientation of the nodes, 4 each, scalar first"),
    "NodeForce": ("force", "VectorList", "internal force at the nodes [N]"),
    "NodeMoment": ("moment", "VectorList", "internal moment at the nodes [N m]"),
    "NodeCurvature": (
        "curvature",
        "VectorList",
        "curvature and twist at the nodes, material frame [1/m]",
    ),
}
"""Property: field of the solution, type, text."""

TABLE = (
    *(
        Prop(name, kind, "Nodes", text[:1].upper() + text[1:], result=True, hidden=True)
        for name, (_, kind, text) in NODES.items()
    ),
    Prop(
        "NodeOfSupport",
        "IntegerList",
        "Nodes",
        "Node of each support; force, moment and curvature there are those just before it",
        result=True,
        hidden=True,
    ),
    Prop(
        "SolvedInputs",
        "String",
        "Nodes",
        "Fingerprint of what was solved",
        result=True,
        hidden=True,
    ),
    Prop(
        "SweptInputs", "String", "Nodes", "Fingerprint of what was swept", result=True, hidden=True
    ),
)


def fingerprint(value, decimals=None) -> str:
    """The same for scenes, or other nested data, that are the same but for rounding.

    ``decimals`` of every number; None: ``DIGITS`` significant ones, and ``PLACE_DECIMALS`` of places.
    """
    return hashlib.sha256(_text(value, decimals).encode()).hexdigest()


def keep(cable, solution: Solution):
    """Store the nodes."""
    for name, (field, kind, _) in NODES.items():
        array = getattr(solution, field)
        rows = (
            array.ravel().tolist()
            if kind == "FloatList"
            else [Vector(*row) for row in array.tolist()]
        )
        setattr(cable, name, rows)
    cable.NodeOfSupport = list(solution.support_nodes)
    cable.Proxy.solution = solution


def kept(cable, scene: Scene) -> Solution | None:
    """The last solution; where only its nodes are known, from a file or undone, these as one of ``scene``. None if
    there are none."""
    if not cable.NodePosition:
        return None
    arrays, last = _arrays(cable), cable.Proxy.solution
    if last is not None and np.array_equal(last.position, arrays["position"]):
        return last
    status = Status.CONVERGED
    loads = zip(cable.SupportForces, cable.SupportMoments, strict=True)
    reactions = [Load(np.array(force), np.array(moment)) for force, moment in loads]
    # An error since has cleared what a user sees; as a start, no load is near enough.
    reactions = reactions or [Load(np.zeros(3), np.zeros(3)) for _ in cable.NodeOfSupport]
    # What it touched, whatever that was: with it goes the error of the nodes, which gather there.
    pushes = zip(cable.ContactPlaces, cable.ContactForces, strict=True)
    contacts = [Contact(to_si("length", at), None, np.array(force)) for at, force in pushes]
    return Solution(
        scene=_before(scene, cable.NodeOfSupport, arrays),
        status=status,
        message=status.value,
        contacts=tuple(contacts),
        position_error=to_si("length", cable.ErrorEstimate),
        min_clearance=to_si("length", cable.SmallestClearance),
        support_nodes=tuple(cable.NodeOfSupport),
        support_reactions=tuple(reactions),
        **arrays,
    )


def _before(scene, support_nodes, arrays):
    """The scene, but held where the stored nodes are, as far as they tell."""
    if len(support_nodes) != len(scene.supports):
        return scene

    def there(holder, node):
        if isinstance(holder, Ring):
            return holder
        quaternion = arrays["quaternion"][node]
        places = {
            "position": arrays["position"][node],
            "quaternion": quaternion,
            "tangent": rotation.tangent(quaternion),
        }
        if getattr(holder, "arc_length", None) is not None:
            places["arc_length"] = float(arrays["arc_length"][node])
        known = {field.name for field in fields(holder)}
        return replace(holder, **{name: places[name] for name in known & places.keys()})

    try:
        return replace(
            scene,
            rod=replace(scene.rod, length=float(arrays["arc_length"][-1])),
            start=there(scene.start, 0),
            end=there(scene.end, -1),
            supports=tuple(map(there, scene.supports, support_nodes)),
        )
    except ProblemError:
        return scene


def nodes(cable) -> Nodes:
    """What of the stored nodes a shape is made from."""
    arrays = _arrays(cable)
    drawn = {field.name: arrays[field.name] for field in fields(Nodes) if field.name in arrays}
    # Curvature does not jump where a support turns nothing, as a ring.
    turning = zip(cable.NodeOfSupport, cable.SupportMoments, strict=True)
    return Nodes(
        **drawn, support_nodes=tuple(node for node, moment in turning if moment.Length > 0)
    )


def nearest_node(cable, point) -> int:
    """Index of the node that is nearest to a point [mm]; 0 if there are none."""
    place = vector_to_si(point)
    away = [np.linalg.norm(np.array(position) - place) for position in cable.NodePosition]
    return int(np.argmin(away)) if away else 0


def _arrays(cable):
    """The stored arrays by the field of the solution."""
    arrays = {}
    for name, (field, kind, _) in NODES.items():
        rows = getattr(cable, name)
        # NumPy takes numbers out of lists four times faster than out of vectors.
        arrays[field] = np.array(rows if kind == "FloatList" else [[*row] for row in rows], float)
    arrays["quaternion"] = arrays["quaternion"].reshape(-1, 4)
    return arrays


def _text(value, decimals):
    if is_dataclass(value):
        if isinstance(value, Mesh):
            return _surface(value)
        decimals = PLACE_DECIMALS if isinstance(value, (End, Obstacle, Support)) else decimals
        named = ((f.name, getattr(value, f.name)) for f in fields(value) if f.name != "place")
        inside = (f"{name}={_text(item, decimals)}" for name, item in named)
        return f"{type(value).__name__}({', '.join(inside)})"
    if isinstance(value, (tuple, list, np.ndarray)):
        return f"[{', '.join(_text(item, decimals) for item in value)}]"
    if isinstance(value, float):
        # Adding zero: no minus in front of it.
        return (
            f"{value:.{DIGITS}g}" if decimals is None else repr(round(float(value), decimals) + 0.0)
        )
    return repr(value)


@lru_cache(1024)
def _surface(mesh):
    """A mesh has too many numbers to ask each for its rounding: sums of them with weights that have no pattern."""
    count = len(mesh.vertices)
    weights = np.sin(np.arange(1, count + 1) ** 2 % 1e4)
    sums = [*(weights @ mesh.vertices), *mesh.vertices.sum(axis=0) / count]
    order = hashlib.sha256(np.ascontiguousarray(mesh.triangles, np.int64)).hexdigest()
    return f"Mesh({count}, {order}, {_text(sums, PLACE_DECIMALS)})"
