# SPDX-License-Identifier: LGPL-2.1-or-later
"""Routes of a scene, one function a method."""

import math

import numpy as np

from ..errors import ProblemError
from ..geometry import curves, rotation
from ..problem import Clamped, Pinned, Scene, Swivel
from .route import Route


def spline_route(scene: Scene) -> Route:
    """The interpolating spline through the ends and supports, with the tangents of both ends.

    As CAD routes a cable: the supports give points, not directions; a pinned end gives no tangent.
    Its length follows from the points alone. Errors: ``ProblemError`` if an end is free or two
    points coincide.
    """
    tangents = _tangent(scene.start), _tangent(scene.end)
    return Route.of_curve("Spline", curves.spline(_points(scene), *tangents))


def catenary_route(scene: Scene) -> Route:
    """The cable as a thread without bending stiffness, of the cable's length, hanging from its
    ends.

    It knows no supports. Errors: ``ProblemError`` if an end is free, without gravity, or if the
    cable is shorter than the chord.
    """
    points = _points(scene)
    curve = curves.catenary(points[0], points[-1], scene.rod.length, scene.gravity)
    return Route.of_curve("Catenary", curve)


def chord_route(scene: Scene) -> Route:
    """Straight from the start over the supports to the end: the shortest route.

    Errors: ``ProblemError`` if an end is free or all points coincide.
    """
    points = _points(scene)
    chords = np.diff(points, axis=0)
    lengths = np.linalg.norm(chords, axis=1)
    apart = lengths > 0
    if not apart.any():
        raise ProblemError("end.position", "is that of the start; a chord needs two points")
    corners = points[np.concatenate(([True], apart))]
    directions = chords[apart] / lengths[apart, None]
    arc_length = np.concatenate(([0.0], np.cumsum(lengths[apart])))
    turning = np.linalg.norm(np.diff(directions, axis=0), axis=1)
    bends = turning > 1e-9
    radius, place = (
        (0.0, float(arc_length[1 + np.argmax(bends)])) if bends.any() else (math.inf, 0.0)
    )
    tangent = np.vstack((directions, directions[-1:]))
    return Route("Chord", arc_length, corners, tangent, radius, place)


METHODS = {"Spline": spline_route, "Catenary": catenary_route, "Chord": chord_route}
"""By the name that the document stores."""


def inputs(method: str, scene: Scene) -> tuple:
    """All that a route of this method is made from: equal inputs, equal route."""
    held = (method, scene.start, *scene.supports, scene.end)
    return (*held, scene.rod.length, scene.gravity) if method == "Catenary" else held


def _points(scene):
    """(n, 3) the start, the supports in order, the end."""
    for end in (scene.start, scene.end):
        if not isinstance(end, Pinned):
            raise ProblemError(end.place, "is free; a route needs both ends held")
    held = (scene.start, *scene.supports, scene.end)
    return np.array([place.position for place in held])


def _tangent(end):
    """The unit tangent (3,) the end holds, or None."""
    if isinstance(end, Clamped):
        return rotation.tangent(end.quaternion)
    return end.tangent if isinstance(end, Swivel) else None
