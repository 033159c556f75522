# SPDX-License-Identifier: LGPL-2.1-or-later
"""Distances from obstacles, their features and bounds, against closed forms and samples of their surfaces."""

import numpy as np
import pytest
from numpy.linalg import norm

from freecad_cable.geometry import rotation
from freecad_cable.problem import Box, Cylinder, HalfSpace, Mesh, Sphere, Tube
from freecad_cable.problem.obstacles import FLAT, LINE, POINT

TURN = np.array([0.8, 0.2, -0.5, 0.3]) / norm([0.8, 0.2, -0.5, 0.3])
CORNERS = np.array(
    [(0.0, 0, 0), (0.5, 0.1, 0), (0.6, 0.1, 0.3), (0.6, 0.1, 0.5), (0.6, 0.1, 0.6), (0.1, 0.7, 0.5)]
)
TETRAHEDRON = (
    [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)],
    [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)],
)

SOLIDS = {
    "half_space": HalfSpace((0.1, 0.2, -0.1), (1, 2, -2)),
    "sphere": Sphere((0.1, -0.2, 0.3), 0.6),
    "cylinder": Cylinder((-0.2, 0.1, -0.3), (0.5, 0.6, 0.4), 0.4),
    "disc": Cylinder((0, 0, 0), (0.03, 0, 0.05), 0.7),
    "box": Box((0.1, 0.2, -0.1), TURN, (0.6, 1.1, 0.8)),
    "mesh": Mesh(*TETRAHEDRON),
    "tube": Tube(CORNERS, 0.15),
}
EXACT_INSIDE = set(SOLIDS) - {"tube"}
ROUNDING = 1e-13
"""Coordinates are of size 1, and a distance comes from a dozen operations."""


@pytest.fixture(params=SOLIDS)
def solid(request):
    return SOLIDS[request.param]


@pytest.fixture
def points():
    return np.random.default_rng(7).uniform(-1, 1.2, (1000, 3))


def test_the_distance_is_that_of_its_feature(solid, points):
    found = solid.nearest(points)
    assert _from_feature(found, points) == pytest.approx(found.distance, abs=ROUNDING)
    step = 1e-5
    # Central differences about a line or point are off by (step / distance from it)².
    away = np.where(found.feature == FLAT, np.inf, found.distance + found.radius)
    for i in range(3):
        shift = step * np.eye(3)[i]
        slope = (_from_feature(found, points + shift) - _from_feature(found, points - shift)) / (
            2 * step
        )
        assert (np.abs(slope - found.normal[:, i]) <= 1e-9 + (step / away) ** 2).all()


def test_along_the_normal_the_surface_is_as_near_as_said(solid, points):
    found = solid.nearest(points)
    for part in (0.3, 0.9, 1.0):
        nearer = points - part * found.distance[:, None] * found.normal
        assert solid.nearest(nearer).distance == pytest.approx(
            (1 - part) * found.distance, abs=ROUNDING
        )


def test_no_distance_changes_faster_than_the_point_moves(solid, points):
    there = points + np.random.default_rng(8).normal(size=points.shape) * 0.2
    change = solid.nearest(there).distance - solid.nearest(points).distance
    assert (np.abs(change) <= norm(there - points, axis=1) + ROUNDING).all()


def test_outside_a_feature_is_that_of_the_solid_nearby(solid, points):
    """Where a small step stays with the same piece of the surface, its distance is that of the solid, curvature too."""
    found = solid.nearest(points)
    steps = 1e-3 * np.random.default_rng(9).normal(size=points.shape)
    there = solid.nearest(points + steps)
    error = np.abs(_from_feature(found, points + steps) - there.distance)
    rim = isinstance(solid, Cylinder) & (found.feature == LINE) & (found.radius == 0)
    same = (found.feature == there.feature) & (found.radius == there.radius) & ~rim
    same &= norm(np.cross(found.direction, there.direction), axis=1) < 1e-12
    same &= np.sum(found.direction * there.direction, axis=1) > -0.5
    assert same.sum() > 0.5 * (~rim).sum()
    assert (error[same] <= ROUNDING).mean() > 0.95
    # The rim is off by (step)²/radius or (step)²/distance, and so is a step on to the next piece.
    assert (error <= 20 * np.sum(steps**2, axis=1) / np.maximum(np.abs(found.distance), 1e-3)).all()


@pytest.mark.parametrize("name", ["sphere", "cylinder", "disc", "box", "mesh", "tube"])
def test_bounds_touch_on_all_sides(name):
    solid = SOLIDS[name]
    low, high = solid.bounds
    points = np.random.default_rng(3).uniform(low - 0.1, high + 0.1, (5000, 3))
    found = solid.nearest(points)
    surface = points - found.distance[:, None] * found.normal
    assert (surface >= low - ROUNDING).all() and (surface <= high + ROUNDING).all()
    # A plane at each side, pushed in by a little, is passed by some point of the solid.
    far = 1e4
    for i in range(3):
        for side, bound in ((-1, low[i]), (1, high[i])):
            beyond = (low + high) / 2 + side * far * np.eye(3)[i]
            gap = solid.nearest(beyond[None]).distance[0]
            # From afar, the nearest point is the outermost, to size² / far.
            assert np.abs(beyond[i] - bound) == pytest.approx(gap, abs=3 / far)


def test_sides_of_a_half_space():
    found = HalfSpace((0, 0, 1), (0, 0, 2)).nearest(np.array([(3.0, 4, 5), (0, 0, -1)]))
    assert found.distance.tolist() == [4, -2]
    assert HalfSpace((0, 0, 1), (0, 0, 2)).bounds.tolist() == [[-np.inf] * 3, [np.inf, np.inf, 1]]
    assert HalfSpace((5, 0, 1), (-1, 0, 0)).bounds[0].tolist() == [5, -np.inf, -np.inf]
    assert np.isinf(SOLIDS["half_space"].bounds).all()


@pytest.mark.parametrize(
    ("point", "distance", "feature", "normal", "radius"),
    [
        ((0.5, 0, 1), 0.3, LINE, (1, 0, 0), 0.2),
        ((0, 0.1, 2.5), 0.5, FLAT, (0, 0, 1), 0),
        ((0.1, 0, -3), 3, FLAT, (0, 0, -1), 0),
        ((0.5, 0, 2.4), 0.5, LINE, (0.6, 0, 0.8), 0),
        ((0, 0.15, 1), -0.05, LINE, (0, 1, 0), 0.2),
        ((0, 0.1, 1.95), -0.05, FLAT, (0, 0, 1), 0),
        ((0, 0.2, 2), 0, LINE, (0, 1, 0), 0.2),
        ((0, 0.2, 1), 0, LINE, (0, 1, 0), 0.2),
        ((0, 0, 2), 0, FLAT, (0, 0, 1), 0),
    ],
)
def test_wall_caps_and_rims_of_a_cylinder(point, distance, feature, normal, radius):
    found = Cylinder((0, 0, 0), (0, 0, 2), 0.2).nearest(np.array([point], float))
    assert found.distance[0] == pytest.approx(distance, abs=1e-15)
    assert found.feature[0] == feature
    assert found.normal[0] == pytest.approx(np.array(normal) / norm(normal))
    assert found.radius[0] == radius


@pytest.mark.parametrize(
    ("point", "distance", "feature", "normal"),
    [
        ((2, 0.1, 0.2), 1.5, FLAT, (1, 0, 0)),
        ((0.1, -0.2, 0.45), -0.05, FLAT, (0, 0, 1)),
        ((0.8, -0.9, 0.3), 0.5, LINE, (3, -4, 0)),
        ((1.5, 1.5, -1.5), 3**0.5, POINT, (1, 1, -1)),
        ((0.5, 0.1, 0.2), 0, FLAT, (1, 0, 0)),
        ((0.5, 0.5, 0.2), 0, FLAT, (1, 0, 0)),
    ],
)
def test_faces_edges_and_corners_of_a_box(point, distance, feature, normal):
    turned = Box((1, 2, 3), TURN, (1, 1, 1))
    for box, x, n in (
        (Box((0, 0, 0), (1, 0, 0, 0), (1, 1, 1)), point, normal),
        (turned, rotation.rotate(TURN, point) + (1, 2, 3), rotation.rotate(TURN, normal)),
    ):
        found = box.nearest(np.array([x], float))
        assert found.distance[0] == pytest.approx(distance, abs=1e-15)
        if distance:
            assert found.feature[0] == feature
            assert found.normal[0] == pytest.approx(n / norm(n))
        assert norm(found.normal[0]) == pytest.approx(1)


@pytest.mark.parametrize("name", ["sphere", "cylinder", "tube"])
def test_at_its_middle_there_is_a_normal(name):
    solid = SOLIDS[name]
    middle = {"sphere": (0.1, -0.2, 0.3), "cylinder": (0.15, 0.35, 0.05), "tube": (0.6, 0.1, 0.5)}
    found = solid.nearest(np.array([middle[name]]))
    assert found.distance[0] == pytest.approx(-solid.radius)
    assert norm(found.normal[0]) == pytest.approx(1)
    assert found.normal[0] @ found.direction[0] == pytest.approx(0)


def test_a_tube_is_a_row_of_cylinders_and_balls():
    points = np.random.default_rng(5).uniform(-0.5, 1.2, (500, 3))
    found = SOLIDS["tube"].nearest(points)
    steps = np.linspace(0, 1, 2001)[:, None, None]
    line = (CORNERS[:-1] + steps * np.diff(CORNERS, axis=0)).reshape(-1, 3)
    sampled = np.array([norm(line - p, axis=1).min() for p in points]) - 0.15
    # Samples are 4e-4 apart at most, so the nearest one is farther by (2e-4)² / (2 distance) at most.
    assert (np.abs(sampled - found.distance) <= 2e-8 / (found.distance + 0.15)).all()
    straight = SOLIDS["tube"].nearest(
        np.array([(0.8, 0.1, 0.4), (0.8, 0.1, 0.5), (-0.2, -0.1, -0.1)])
    )
    assert straight.feature.tolist() == [LINE, LINE, POINT]
    assert set(found.radius) == {0.15}


def test_a_fine_mesh_is_what_it_stands_for():
    """A box as a mesh and as a box: one distance, normal and feature."""
    box = Box((0.2, 0.1, 0), TURN, (0.6, 1.1, 0.8))
    corners = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    vertices = rotation.rotate(TURN, corners * (0.3, 0.55, 0.4)) + (0.2, 0.1, 0)
    squares = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = [t for a, b, c, d in squares for t in ((a, b, c), (a, c, d))]
    points = np.random.default_rng(6).uniform(-1, 1.2, (2000, 3))
    found, meant = Mesh(vertices, triangles).nearest(points), box.nearest(points)
    assert found.distance == pytest.approx(meant.distance, abs=ROUNDING)
    assert found.normal == pytest.approx(meant.normal, abs=1e-9)
    assert np.array_equal(found.feature, meant.feature)
    assert np.abs(np.sum(found.direction * meant.direction, axis=1)) == pytest.approx(
        np.where(meant.feature == POINT, 0.0, 1.0), abs=1e-9
    )


def _from_feature(found, points):
    away = points - found.center
    along = np.sum(away * found.direction, axis=1)
    about_line = norm(away - along[:, None] * found.direction, axis=1) - found.radius
    return np.choose(found.feature, (along, about_line, norm(away, axis=1) - found.radius))
