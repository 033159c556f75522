# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scene file, schema 1: a scene as plain JSON data, in SI units.

Reading is strict: an unknown field is an error, so that a misspelt one is not silently ignored.
"""

from ..errors import ProblemError
from ..options import SolveOptions
from .checked import number, record, shown, vector
from .ends import Clamped, Free, Pinned, Swivel
from .obstacles import Box, Cylinder, HalfSpace, Sphere
from .reach import chord_through
from .rod import Rod
from .scene import Scene
from .supports import SUPPORTS
from .surfaces import Mesh

SCHEMA = 1
START = 1.1
"""Length over the chord with which the search for a length begins."""
ENDS = {"clamped": Clamped, "swivel": Swivel, "pinned": Pinned, "free": Free}
END_FIELDS = {
    "clamped": ("position", "quaternion"),
    "swivel": ("position", "tangent"),
    "pinned": ("position",),
    "free": (),
}
SUPPORT_FIELDS = {
    "clamp": ("position", "quaternion"),
    "sleeve": ("position", "tangent"),
    "ring": ("position", "axis", "radius"),
    "clip": ("position", "tangent"),
}
OBSTACLE_FIELDS = {
    "half_space": ("point", "normal"),
    "sphere": ("center", "radius"),
    "cylinder": ("start", "end", "radius"),
    "box": ("position", "quaternion", "size"),
    "mesh": ("vertices", "triangles"),
}
OBSTACLES = {kind.kind: kind for kind in (HalfSpace, Sphere, Cylinder, Box, Mesh)}
CABLE_REQUIRED = ("radius", "mass_per_length", "bending_stiffness", "torsional_stiffness")
CABLE_OPTIONAL = ("axial_stiffness", "shear_stiffness", "natural_curvature", "min_bend_radius")


def read_scene(data) -> Scene:
    """Scene of parsed JSON. Errors: ``ProblemError`` naming the field."""
    fields = record(
        "scene",
        data,
        required=("schema", "cable", "start", "end"),
        optional=("gravity", "supports", "obstacles", "clearance", "options"),
    )
    if fields["schema"] != SCHEMA or isinstance(fields["schema"], bool):
        raise ProblemError(
            "schema", f"is {shown(fields['schema'])}; this version reads schema {SCHEMA}"
        )
    supports = _supports(fields.get("supports", []))
    obstacles = _obstacles(fields.get("obstacles", []))
    start, end = (_end(place, fields[place]) for place in ("start", "end"))
    gravity = fields.get("gravity", [0, 0, -9.81])
    clearance = fields.get("clearance", 0.0)
    rod = _rod(fields["cable"], start, end, supports)
    mode = fields["cable"].get("length_mode")
    return Scene(
        rod=rod,
        asks_length=mode is not None and mode["kind"] == "shortest",
        enforce_bend_radius=_enforced(fields["cable"]),
        start=start,
        end=end,
        supports=supports,
        obstacles=obstacles,
        gravity=vector("gravity", gravity),
        clearance=number("clearance", clearance, at_least=0, unit="m"),
        options=_options(fields.get("options", {})),
    )


def _rod(data, start, end, supports) -> Rod:
    fields = record(
        "cable",
        data,
        required=CABLE_REQUIRED,
        optional=("length", "length_mode", "bend_radius_mode", *CABLE_OPTIONAL),
    )
    given = {name: fields[name] for name in CABLE_REQUIRED}
    given |= {name: fields[name] for name in CABLE_OPTIONAL if fields.get(name) is not None}
    return Rod(length=_length(fields, start, end, supports), **given)


def _enforced(data) -> bool:
    mode = data.get("bend_radius_mode") or "check"
    if mode not in ("check", "enforce"):
        raise ProblemError(
            "cable.bend_radius_mode", f"is {shown(mode)}; it must be check or enforce"
        )
    return mode == "enforce"


def _length(fields, start, end, supports) -> float:
    place, mode = "cable.length_mode", fields.get("length_mode")
    if (mode is None) == (fields.get("length") is None):
        raise ProblemError("cable.length", "give either length or length_mode, and not both")
    if mode is None:
        return number("cable.length", fields["length"], above=0, unit="m")
    if not isinstance(mode, dict):
        raise ProblemError(place, f"is {shown(mode)}; it must be an object with a kind")
    kind = mode.get("kind")
    if kind not in ("slack", "shortest"):
        raise ProblemError(f"{place}.kind", f"is {shown(kind)}; it must be slack or shortest")
    record(place, mode, ("kind", "value") if kind == "slack" else ("kind",), ())
    held = [end for end in (start, *supports, end) if not isinstance(end, Free)]
    if isinstance(start, Free) or isinstance(end, Free):
        raise ProblemError(place, f"{kind} needs both ends held at a position; give a length")
    way = chord_through([each.position for each in held])
    if way == 0:
        raise ProblemError(
            place, f"the ends are at the same point, so {kind} has no base; give a length"
        )
    if kind == "shortest":
        return way * START
    return way * (1 + number(f"{place}.value", mode["value"], at_least=0))


def _end(place, data):
    kind = _kind(place, data, END_FIELDS)
    fields = record(place, data, ("kind", *END_FIELDS[kind]), ())
    return ENDS[kind](*(fields[name] for name in END_FIELDS[kind]), place=place)


def _supports(data) -> tuple:
    found = _kinds("supports", data, SUPPORT_FIELDS, ("arc_length",))
    return tuple(
        SUPPORTS[kind](
            *(fields[name] for name in SUPPORT_FIELDS[kind]),
            arc_length=fields.get("arc_length"),
            place=f"supports[{i}]",
        )
        for i, (kind, fields) in enumerate(found)
    )


def _obstacles(data) -> tuple:
    found = _kinds("obstacles", data, OBSTACLE_FIELDS, ())
    return tuple(
        OBSTACLES[kind](*(fields[name] for name in OBSTACLE_FIELDS[kind]), place=f"obstacles[{i}]")
        for i, (kind, fields) in enumerate(found)
    )


def _options(data) -> SolveOptions:
    fields = record(
        "options", data, (), ("tolerance", "solver", "scheme", "elements", "keep", "time_limit")
    )
    given = {name: value for name, value in fields.items() if value is not None}
    for name in ("tolerance", "time_limit"):
        if name in given:
            given[name] = number(f"options.{name}", given[name], above=0)
    if not isinstance(keep := given.get("keep", []), list):
        raise ProblemError("options.keep", f"is {shown(keep)}; it must be a list")
    given["keep"] = tuple(keep)
    elements = given.get("elements")
    if elements is not None and (isinstance(elements, bool) or not isinstance(elements, int)):
        raise ProblemError(
            "options.elements", f"is {shown(elements)}; it must be a whole number or null"
        )
    return SolveOptions(**given)


def _kinds(place, data, kinds, optional):
    """Check a list of objects with a kind each; (kind, fields) of each."""
    if not isinstance(data, list):
        raise ProblemError(place, f"is {shown(data)}; it must be a list")
    found = []
    for i, item in enumerate(data):
        where = f"{place}[{i}]"
        kind = _kind(where, item, kinds)
        found.append((kind, record(where, item, ("kind", *kinds[kind]), optional)))
    return found


def _kind(place, data, kinds):
    if not isinstance(data, dict):
        raise ProblemError(place, f"is {shown(data)}; it must be an object with a kind")
    kind = data.get("kind")
    if not isinstance(kind, str) or kind not in kinds:
        raise ProblemError(
            f"{place}.kind", f"is {shown(kind)}; it must be one of {', '.join(kinds)}"
        )
    return kind
