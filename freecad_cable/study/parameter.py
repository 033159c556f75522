# SPDX-License-Identifier: LGPL-2.1-or-later
"""What of a scene a study changes, and how."""

import re
from dataclasses import dataclass, field, fields, is_dataclass, replace

import numpy as np

from ..errors import ProblemError
from ..geometry import rotation
from ..problem import Free, Scene
from ..problem.checked import direction, number, shown, table, vector
from ..problem.reach import chord_through
from ..problem.reduce import orientation

HOW = ("set", "add", "scale", "turn", "move", "path")
OWN_AXES = ("d1", "d2", "d3")
SCENE = {"cable": "rod"}
"""Names of the scene file that the scene calls otherwise."""

MADE_UP = {"cable.slack": "set", "cable.stiffness": "scale"}
"""Fields that no scene has, and all that can be done to them."""

NO_FIELDS = ("options", "place", "asks_length")

PLACES = ("position", "point", "center", "start", "end", "vertices")
DIRECTIONS = ("tangent", "axis", "normal")
"""Fields of what holds the cable and of obstacles that move and turn with it."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Parameter:
    """A number that a study varies.

    ``field`` is a place of the scene in the words of the scene file: ``cable.length``, ``end.position[2]``,
    ``supports[0].arc_length``, ``gravity``, ``clearance``; also ``cable.slack`` (set only) and ``cable.stiffness``
    (EI and GJ, scale only). ``how`` says what is done to it with a value:

    - ``set`` makes it the value, ``add`` adds the value, ``scale`` multiplies with it;
    - ``move`` moves an end, a support or an obstacle by the value [m] along ``axis``;
    - ``turn`` turns an end, a support, an obstacle or gravity by the value [rad] about ``axis`` through ``point``
      (its own place if None). The axis is (3,), or of an end or a support ``d1``, ``d2``, ``d3``, its own: ``d3`` is
      its roll;
    - ``path`` puts an end or a support at a place of a path: positions (k, 3) [m] and, if it holds a frame or a
      tangent, quaternions (k, 4). The value, from 0 to k − 1, is the number of the place; between two places
      straight on, turning at an even rate.

    Errors: ``ProblemError`` naming the field.
    """

    field: str
    how: str = "set"
    axis: object = None
    point: object = None
    positions: np.ndarray | None = field(default=None, repr=False)
    quaternions: np.ndarray | None = field(default=None, repr=False)

    def __post_init__(self):
        if not isinstance(self.field, str) or not self.field:
            raise ProblemError(
                "parameter.field", f"is {shown(self.field)}; it must be a place as cable.length"
            )
        if self.how not in HOW:
            raise ProblemError(
                "parameter.how", f"is {shown(self.how)}; it must be one of {', '.join(HOW)}"
            )
        put = lambda name, value: object.__setattr__(self, name, value)  # noqa: E731
        if self.how in ("turn", "move") and not self._own_axis:
            put("axis", direction("parameter.axis", self.axis))
        if self.point is not None:
            put("point", vector("parameter.point", self.point))
        if self.how == "path":
            put("positions", table("parameter.positions", self.positions, least=2))
            if self.quaternions is not None:
                put("quaternions", self._frames())

    @property
    def _own_axis(self):
        return isinstance(self.axis, str) and self.axis in OWN_AXES

    def _frames(self):
        place, frames = "parameter.quaternions", self.quaternions
        if not isinstance(frames, (list, tuple, np.ndarray)) or len(frames) != len(self.positions):
            raise ProblemError(
                place, f"must be {len(self.positions)} frames, one for each position"
            )
        frames = [direction(f"{place}[{i}]", q, 4) for i, q in enumerate(frames)]
        return rotation.continuous(np.array(frames))

    def of(self, scene: Scene, value: float) -> Scene:
        """The scene with this value."""
        value = number(self.field, value)
        if self.field == "cable.slack":
            return self._slack(scene, value)
        if self.field == "cable.stiffness":
            return self._stiffness(scene, value)
        return self._changed(scene, _steps(self.field), value)

    def at(self, scene: Scene):
        """What stands at the field now; of ``cable.slack`` and ``cable.stiffness`` the rod."""
        if self.field in MADE_UP:
            self._check_how()
            return scene.rod
        for step in _steps(self.field):
            scene = self._inside(scene, step)
        return scene

    def _check_how(self):
        if self.how != MADE_UP[self.field]:
            can = MADE_UP[self.field]
            raise ProblemError(self.field, f"cannot {self.how}; it can only {can}")

    def _slack(self, scene, value):
        self._check_how()
        held = (scene.start, *scene.supports, scene.end)
        if not scene.spans:
            raise ProblemError(self.field, "needs both ends held at a position; vary cable.length")
        way = chord_through([each.position for each in held])
        return replace(scene, rod=replace(scene.rod, length=(1 + value) * way))

    def _stiffness(self, scene, value):
        self._check_how()
        rod = scene.rod
        scaled = replace(
            rod,
            bending_stiffness=rod.bending_stiffness * value,
            torsional_stiffness=rod.torsional_stiffness * value,
        )
        return replace(scene, rod=scaled)

    def _changed(self, owner, steps, value):
        """``owner`` with what the steps lead to changed."""
        if not steps:
            return self._new(owner, value)
        step, *rest = steps
        new = self._changed(self._inside(owner, step), rest, value)
        if isinstance(step, int):
            return (*owner[:step], new, *owner[step + 1 :])
        return replace(owner, **{_name(owner, step): new})

    def _inside(self, owner, step):
        """What one step leads to."""
        if isinstance(step, int):
            count = len(owner) if isinstance(owner, (tuple, np.ndarray)) else 0
            if step >= count:
                raise ProblemError(self.field, f"is not in this scene: it has {count} of these")
            return owner[step]
        known = [each.name for each in fields(owner)] if is_dataclass(owner) else []
        if _name(owner, step) not in known or step in NO_FIELDS:
            raise ProblemError(self.field, "is no place in this scene")
        return getattr(owner, _name(owner, step))

    def _new(self, old, value):
        if self.how in ("turn", "move", "path"):
            return getattr(self, f"_{self.how}")(old, value)
        numbers = isinstance(old, (float, int, np.number)) and not isinstance(old, bool)
        if old is None and self.how == "set":
            return value
        if not numbers and not isinstance(old, np.ndarray):
            raise ProblemError(self.field, f"is {shown(old)}, no number that could {self.how}")
        if self.how == "scale":
            return old * value
        if self.how == "add":
            return old + value
        # One number stands for both directions of bending, as in the scene file; for no other vector.
        if not numbers and not self.field.endswith("bending_stiffness"):
            raise ProblemError(self.field, f"is a vector; vary {self.field}[0] or the like")
        return value

    def _move(self, thing, value):
        return self._placed(
            thing, np.array([1.0, 0.0, 0.0, 0.0]), np.zeros(3), value * self._along(thing)
        )

    def _turn(self, thing, value):
        turn = rotation.exponential(value * self._along(thing))
        if isinstance(thing, np.ndarray):
            return rotation.rotate(turn, thing)
        about = self.point
        if about is None:
            about = getattr(
                thing, "position", getattr(thing, "center", getattr(thing, "point", None))
            )
        if about is None:
            raise ProblemError(self.field, "has no place of its own to turn about; give a point")
        return self._placed(thing, turn, about, np.zeros(3))

    def _path(self, thing, value):
        self._check_held(thing)
        last = len(self.positions) - 1
        if not 0 <= value <= last:
            raise ProblemError(
                self.field, f"is at place {value:g} of a path; it must be from 0 to {last}"
            )
        k = min(int(value), last - 1)
        share = value - k
        changes = {"position": (1 - share) * self.positions[k] + share * self.positions[k + 1]}
        if self.quaternions is not None:
            frame = rotation.between(*self.quaternions[k : k + 2], share)
            changes |= {"quaternion": frame, "tangent": rotation.tangent(frame)}
        known = {each.name for each in fields(thing)}
        return replace(thing, **{name: new for name, new in changes.items() if name in known})

    def _along(self, thing):
        """(3,) the axis in the world."""
        if not self._own_axis:
            return self.axis
        self._check_held(thing)
        if hasattr(thing, "quaternion"):
            return rotation.matrix(thing.quaternion)[:, OWN_AXES.index(self.axis)]
        tangent = orientation(thing)
        if tangent is None:
            raise ProblemError(
                self.field, f"has no frame of its own, so no {self.axis}; give an axis"
            )
        return rotation.matrix(rotation.from_tangent(tangent))[:, OWN_AXES.index(self.axis)]

    def _check_held(self, thing):
        if not hasattr(thing, "position") or isinstance(thing, Free):
            raise ProblemError(self.field, "holds nothing, so it has no place to change")

    def _placed(self, thing, turn, about, shift):
        """An end, a support or an obstacle turned about a point and shifted."""
        if not is_dataclass(thing) or isinstance(thing, Free):
            raise ProblemError(self.field, f"is nothing that could {self.how}")
        changes = {}
        for name in (each.name for each in fields(thing)):
            if name in PLACES:
                old = getattr(thing, name)
                changes[name] = about + rotation.rotate(turn, old - about) + shift
            elif name in DIRECTIONS:
                changes[name] = rotation.rotate(turn, getattr(thing, name))
            elif name == "quaternion":
                changes[name] = rotation.multiply(turn, thing.quaternion)
        if not changes:
            raise ProblemError(self.field, f"is nothing that could {self.how}")
        return replace(thing, **changes)


def _name(owner, step):
    return SCENE.get(step, step) if isinstance(owner, Scene) else step


def _steps(place):
    """``end.position[2]`` → ["end", "position", 2]."""
    if not re.fullmatch(r"\w+(\[\d+\])?(\.\w+(\[\d+\])?)*", place):
        raise ProblemError(
            "parameter.field", f"is {shown(place)}; it must be a place as cable.length"
        )
    found = re.findall(r"(\w+)(?:\[(\d+)\])?", place)
    return [step for name, i in found for step in ([name, int(i)] if i else [name])]
