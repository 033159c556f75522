# SPDX-License-Identifier: LGPL-2.1-or-later
"""Distance to a triangulated surface: against all triangles, winding numbers and boxes."""

import numpy as np
import pytest
from numpy.linalg import norm

from freecad_cable.geometry.nearest import FLAT, LINE, POINT
from freecad_cable.geometry.surface import Surface, nearest_of_each

ROUNDING = 1e-12
"""Coordinates are of size 1 and distances come from a dozen operations on them."""


@pytest.fixture(params=["box", "bracket", "star"])
def solid(request, meshes, random):
    if request.param == "box":
        return meshes.box((-0.3, -0.5, -0.7), (0.4, 0.6, 0.2), 3)
    return meshes.bracket() if request.param == "bracket" else meshes.star(random)


def test_distance_and_sign(solid, random, the_long_way, winding):
    points = random.uniform(-1.1, 1.3, (800, 3))
    found = Surface(*solid).nearest(points)
    inside = winding(points, *solid) > 0.5
    assert inside.sum() > 10
    assert np.array_equal(found.distance < 0, inside)
    assert np.abs(found.distance) == pytest.approx(the_long_way(points, *solid), abs=ROUNDING)


def test_the_feature_tells_distance_and_gradient(solid, random, from_feature):
    points = random.uniform(-1.1, 1.3, (800, 3))
    surface = Surface(*solid)
    found = surface.nearest(points)
    assert from_feature(found, points) == pytest.approx(found.distance, abs=ROUNDING)
    step = 1e-5
    for i in range(3):
        shift = step * np.eye(3)[i]
        slope = from_feature(found, points + shift) - from_feature(found, points - shift)
        # Central differences of a distance are off by (step / distance)², and no point is nearer than 1e-3.
        far = np.abs(found.distance) > 1e-3
        assert slope[far] / (2 * step) == pytest.approx(found.normal[far, i], abs=1e-4)
    # On the way to the surface along the normal, the distance falls as fast as it can.
    half_way = points - found.distance[:, None] / 2 * found.normal
    assert surface.nearest(half_way).distance == pytest.approx(found.distance / 2, abs=ROUNDING)


def test_several_at_once(meshes, random, the_long_way):
    tetrahedron = np.eye(4)[:, :3], np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
    boxes = [meshes.box((k, 0, 0), (k + 0.5, 0.3, 0.2), n) for k, n in ((0, 1), (1, 1), (2, 4))]
    several = [tetrahedron, boxes[0], boxes[2], boxes[1]]
    points = [random.uniform(-1.1, 3.1, (count, 3)) for count in (40, 0, 30, 7)]
    found = nearest_of_each([Surface(*each) for each in several], points)
    for solid, own, there in zip(several, points, found, strict=True):
        assert np.abs(there.distance) == pytest.approx(the_long_way(own, *solid), abs=ROUNDING)
        alone = vars(Surface(*solid).nearest(own))
        assert all(np.array_equal(row, vars(there)[name]) for name, row in alone.items())


def test_faces_edges_and_corners_outside(meshes):
    surface = Surface(*meshes.box((0, 0, 0), (1, 1, 1), 4))
    points = np.array([(0.5, 0.5, 2), (0.25, 0.6, 1.3), (1.5, 0.25, 2), (2, 0.3, 1.1), (2, 2, 2.0)])
    found = surface.nearest(points)
    # The first, above a vertex of the grid, and the second, above one of its lines, are over a face all the same; the
    # third, beside a vertex of the grid on an edge of the box, is beside that edge.
    assert found.feature.tolist() == [FLAT, FLAT, LINE, LINE, POINT]
    assert found.direction[:2].tolist() == [[0, 0, 1], [0, 0, 1]]
    assert np.abs(found.direction[2:]).tolist() == [[0, 1, 0], [0, 1, 0], [0, 0, 0]]
    assert found.center[4].tolist() == [1, 1, 1]
    assert found.normal[4] == pytest.approx(np.ones(3) / np.sqrt(3))


def test_inside_the_nearest_face_is_flat(meshes):
    points = np.array([(0.5, 0.5, 0.9), (0.25, 0.02, 0.5), (0.25, 0.5, 0.01)])
    found = Surface(*meshes.box((0, 0, 0), (1, 1, 1), 4)).nearest(points)
    assert found.feature.tolist() == [FLAT] * 3
    assert found.direction == pytest.approx(np.array([(0, 0, 1), (0, -1, 0), (0, 0, -1)]))
    assert found.distance == pytest.approx(np.array([-0.1, -0.02, -0.01]))


def test_inside_at_a_reentrant_edge_the_way_out_is_to_the_edge(meshes):
    surface = Surface(*meshes.bracket())
    found = surface.nearest(np.array([(0.4, 0.3, 0.5)]))
    way_out = np.array([0.1, 0.2, 0]) / np.hypot(0.1, 0.2)
    assert found.feature.tolist() == [FLAT]
    assert found.distance == pytest.approx([-np.hypot(0.1, 0.2)])
    assert found.normal[0] == pytest.approx(way_out)
    outside = surface.nearest(np.array([(0.6, 0.7, 0.5), (0.5, 0.5, 0.5)]))
    assert outside.feature.tolist() == [FLAT, FLAT]
    assert outside.normal[0] == pytest.approx([1, 0, 0])
    assert outside.distance == pytest.approx([0.1, 0])
    # On the hollow edge itself, the normal is that of either face and not one between.
    assert sorted(np.abs(outside.normal[1])) == pytest.approx([0, 0, 1])


@pytest.mark.parametrize(
    ("point", "normal"),
    [
        ((0.3, 0.4, 1), (0, 0, 1)),
        ((0.5, 0.5, 1), (0, 0, 1)),
        ((1, 0.4, 1), (1, 0, 1)),
        ((1, 0.5, 1), (1, 0, 1)),
        ((1, 1, 1), (1, 1, 1)),
    ],
)
def test_on_the_surface_there_is_a_normal(meshes, point, normal):
    found = Surface(*meshes.box((0, 0, 0), (1, 1, 1), 4)).nearest(np.array([point], float))
    assert found.distance == pytest.approx([0], abs=1e-15)
    assert found.normal[0] == pytest.approx(np.array(normal) / norm(normal))
    assert found.feature.tolist() == [FLAT]


def test_a_sheet_has_a_front_and_a_back_and_nothing_beyond_its_rim(meshes):
    sheet = meshes.grid(np.zeros(3), np.array([1.0, 0, 0]), np.array([0, 1.0, 0]), 4)
    surface = Surface(*sheet)
    assert not surface.closed
    points = np.array(
        [(0.5, 0.5, 0.3), (0.5, 0.5, -0.3), (1.3, 0.5, -0.4), (1.3, 1.4, 0), (1, 0.4, -0.2)]
    )
    found = surface.nearest(points)
    assert found.distance == pytest.approx([0.3, -0.3, 0.5, 0.5, -0.2])
    assert found.feature.tolist() == [FLAT, FLAT, LINE, POINT, FLAT]
    assert found.normal[:3] == pytest.approx(np.array([(0, 0, 1), (0, 0, 1), (0.6, 0, -0.8)]))


def test_a_crack_in_a_face_is_not_seen(meshes):
    vertices, triangles = meshes.box((0, 0, 0), (1, 1, 1), 4)
    apart = vertices[triangles].reshape(-1, 3), np.arange(triangles.size).reshape(-1, 3)
    points = np.array([(0.5, 0.5, 1.2), (0.5, 0.5, 0.8), (0.3, 0.25, 0.9), (0.25, 1.1, 0.6)])
    found, whole = (Surface(*mesh).nearest(points) for mesh in (apart, (vertices, triangles)))
    assert found.distance == pytest.approx(whole.distance, abs=1e-15)
    assert found.feature.tolist() == [FLAT] * 4


def test_volume(meshes):
    box, bracket = Surface(*meshes.box((1, 2, 3), (2, 4, 6), 2)), Surface(*meshes.bracket())
    assert box.closed and bracket.closed
    assert (box.volume, bracket.volume) == pytest.approx((6, 0.75))


def test_an_edge_that_does_not_part_two_sides_is_told(meshes):
    vertices, triangles = meshes.bracket()
    assert not Surface(vertices, triangles).edges.balance.any()
    triangles[0] = triangles[0, ::-1]
    edges = Surface(vertices, triangles).edges
    assert {tuple(sorted(e)) for e in edges.ends[edges.balance != 0]} == {(0, 1), (1, 2), (0, 2)}
