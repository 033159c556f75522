# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers of a cable that are no property, but that a study may vary."""

import math

from FreeCAD import Units

from ..problem import Scene
from ..study import Parameter

DEGREES = {
    f"GravityTurn.{name}": Parameter(field="gravity", how="turn", axis=axis)
    for name, axis in (("x", [1, 0, 0]), ("y", [0, 1, 0]), ("z", [0, 0, 1]))
}
FACTORS = {"StiffnessScale": Parameter(field="cable.stiffness", how="scale")}


class MadeUp:
    """By how much the stiffness is scaled, or gravity is turned about an axis of the document: varied as a
    ``document.varied.Varied``, of the scene alone."""

    cell = None

    def __init__(self, path):
        self.path, self.names = path, [path]
        self.unit = Units.Angle if path in DEGREES else None
        self.unit_text = "deg" if self.unit else ""

    def set(self, value):
        """Nothing in the document changes."""

    check = set

    def release(self):
        """Nothing else gives it its value."""
        return []

    def of(self, scene: Scene, value: float) -> Scene:
        """A scene with this value. Errors: ``ProblemError``."""
        if self.unit:
            return DEGREES[self.path].of(scene, math.radians(value))
        return FACTORS[self.path].of(scene, value)
