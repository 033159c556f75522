# SPDX-License-Identifier: LGPL-2.1-or-later
"""The study file, schema 1: a study of a scene as plain JSON data, in SI units. Reading is strict, as of scene
files."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ..errors import ProblemError
from ..problem import Scene
from ..problem.checked import number, record, shown
from ..problem.scene_file import read_scene
from .cases import Cases, corners, random_cases
from .parameter import Parameter
from .path import PRECISION
from .variation import Variation, held_within, longer

SCHEMA = 1
MOST = 1_000_000
"""Values of a path, and cases."""


@dataclass(frozen=True, eq=False)
class PathStudy:
    """One property over values, each from the last."""

    scene: Scene
    parameter: Parameter
    values: tuple[float, ...]
    precision: float
    needed_length: bool
    """whether the length that the worst value needs is asked for, too"""

    def scene_at(self, value: float) -> Scene:
        return self.parameter.of(self.scene, value)

    @property
    def names(self):
        return (_name(self.parameter),)

    @property
    def count(self) -> int:
        return len(self.values)


@dataclass(frozen=True, eq=False)
class ToleranceStudy:
    """Cases of one scene."""

    scene: Scene
    cases: Cases

    @property
    def names(self):
        return tuple(_name(each.parameter) for each in self.cases.variations)

    @property
    def count(self) -> int:
        return self.cases.count


def read_study(data, load: Callable) -> PathStudy | ToleranceStudy:
    """Study of parsed JSON; ``load(name)`` gives the parsed JSON of a scene file that it names. Errors:
    ``ProblemError``."""
    fields = record("study", data, ("schema", "scene"), ("path", "tolerance"))
    if fields["schema"] != SCHEMA or isinstance(fields["schema"], bool):
        raise ProblemError(
            "schema", f"is {shown(fields['schema'])}; this version reads schema {SCHEMA}"
        )
    if ("path" in fields) == ("tolerance" in fields):
        raise ProblemError("study", "must have either path or tolerance")
    scene = fields["scene"]
    scene = read_scene(load(scene) if isinstance(scene, str) else scene)
    if "tolerance" in fields:
        return ToleranceStudy(scene, _cases(scene, fields["tolerance"]))
    path = record(
        "path",
        fields["path"],
        ("parameter",),
        ("values", "from", "to", "count", "precision", "needed_length"),
    )
    study = PathStudy(
        scene,
        read_parameter("path.parameter", path["parameter"]),
        _values(path),
        number("path.precision", path.get("precision", PRECISION), above=0),
        _flag("path.needed_length", path.get("needed_length", False)),
    )
    study.parameter.at(scene)
    return study


def read_parameter(place, data) -> Parameter:
    """Parameter of parsed JSON. Errors: ``ProblemError``."""
    fields = record(place, data, ("field",), ("how", "axis", "point", "positions", "quaternions"))
    return Parameter(**{name: value for name, value in fields.items() if value is not None})


def _values(path):
    if "values" in path:
        given = "is given beside values; give from, to and count, or values"
        _refuse("path", path, ("from", "to", "count"), given)
        values = path["values"]
        if not isinstance(values, list) or not 1 <= len(values) <= MOST:
            raise ProblemError("path.values", f"is {shown(values)}; it must be a list of numbers")
        return tuple(number(f"path.values[{i}]", value) for i, value in enumerate(values))
    for name in ("from", "to", "count"):
        if name not in path:
            raise ProblemError(f"path.{name}", "is missing; give from, to and count, or values")
    count = _whole("path.count", path["count"], 2)
    first, last = (number(f"path.{name}", path[name]) for name in ("from", "to"))
    if first == last:
        raise ProblemError("path.to", f"is {last:g} and so is from; give a range, or values")
    return tuple(np.linspace(first, last, count).tolist())


def _cases(scene, data):
    place = "tolerance"
    fields = record(place, data, ("method",), ("length", "held", "variations", "count", "seed"))
    variations = [longer(scene)] if _flag(f"{place}.length", fields.get("length", False)) else []
    for where, each in _each(f"{place}.held", fields.get("held", [])):
        held = record(where, each, ("field",), ("distance", "angle"))
        distance, angle = (
            number(f"{where}.{name}", held.get(name, 0.0), at_least=0)
            for name in ("distance", "angle")
        )
        variations += held_within(scene, held["field"], distance, angle)
    for where, each in _each(f"{place}.variations", fields.get("variations", [])):
        one = record(where, each, ("parameter", "low", "high"), ("spread",))
        parameter = read_parameter(f"{where}.parameter", one["parameter"])
        variations.append(
            Variation(parameter, one["low"], one["high"], one.get("spread", "uniform"))
        )
    for each in variations:
        each.parameter.at(scene)
    if fields["method"] == "corners":
        given = "is given beside corners, which are all there are; leave it out"
        _refuse(place, fields, ("count", "seed"), given)
        return corners(variations)
    if fields["method"] != "random":
        raise ProblemError(
            f"{place}.method", f"is {shown(fields['method'])}; it must be random or corners"
        )
    for name in ("count", "seed"):
        if name not in fields:
            raise ProblemError(f"{place}.{name}", "is missing; cases at random need it")
    count = _whole(f"{place}.count", fields["count"], 1)
    return random_cases(variations, count, fields["seed"])


def _refuse(place, data, names, sentence):
    for name in names:
        if name in data:
            raise ProblemError(f"{place}.{name}", sentence)


def _each(place, data):
    if not isinstance(data, list):
        raise ProblemError(place, f"is {shown(data)}; it must be a list")
    return ((f"{place}[{i}]", item) for i, item in enumerate(data))


def _flag(place, value):
    if not isinstance(value, bool):
        raise ProblemError(place, f"is {shown(value)}; it must be true or false")
    return value


def _whole(place, value, least):
    if isinstance(value, bool) or not isinstance(value, int) or not least <= value <= MOST:
        raise ProblemError(
            place, f"is {shown(value)}; it must be a whole number from {least} to {MOST}"
        )
    return value


def _name(parameter):
    if parameter.how == "set":
        return parameter.field
    axis = f" {parameter.axis}" if isinstance(parameter.axis, str) else ""
    if parameter.axis is not None and not axis:
        axis = " " + " ".join(f"{x:.4g}" for x in parameter.axis)
    return f"{parameter.field} {parameter.how}{axis}"
