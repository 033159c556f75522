# SPDX-License-Identifier: LGPL-2.1-or-later
"""Obstacles in scene files: what is right is read, what is wrong is named with its value and bound."""

import numpy as np
import pytest

from freecad_cable.errors import ProblemError
from freecad_cable.problem import Mesh, Tube
from freecad_cable.problem.scene_file import read_scene

NAN, INFINITE = float("nan"), float("inf")
CORNERS = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]]
FACES = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
RIGHT = {
    "half_space": {"point": [0, 0, -0.2], "normal": [0, 0, 2]},
    "sphere": {"center": [0, 0, 0], "radius": 0.05},
    "cylinder": {"start": [0, 0, 0], "end": [0, 0, 1], "radius": 0.02},
    "box": {"position": [0, 0, 0], "quaternion": [2, 0, 0, 0], "size": [0.1, 0.2, 0.3]},
    "mesh": {"vertices": CORNERS, "triangles": FACES},
}


def test_every_kind_is_read(data):
    data["obstacles"] = [{"kind": kind, **fields} for kind, fields in RIGHT.items()]
    obstacles = read_scene(data).obstacles
    assert [obstacle.kind for obstacle in obstacles] == list(RIGHT)
    assert [o.place for o in obstacles] == [f"obstacles[{i}]" for i in range(5)]
    for obstacle, fields in zip(obstacles, RIGHT.values(), strict=True):
        for name, value in fields.items():
            if name not in ("normal", "quaternion"):
                assert np.array_equal(getattr(obstacle, name), value)
    assert obstacles[0].normal.tolist() == [0, 0, 1]
    assert obstacles[3].quaternion.tolist() == [1, 0, 0, 0]


@pytest.mark.parametrize(
    ("kind", "name", "value", "field", "message"),
    [
        ("half_space", "normal", [0, 0, 0], "normal", "its length is zero"),
        ("half_space", "point", [0, 0], "point", "must be a list of 3 numbers"),
        ("half_space", "point", [0, NAN, 0], "point[1]", "is nan; it must be a finite number"),
        ("sphere", "radius", 0, "radius", "is 0 m; it must be greater than 0 m"),
        ("sphere", "radius", -1, "radius", "is -1 m; it must be greater than 0 m"),
        ("sphere", "radius", INFINITE, "radius", "finite"),
        ("sphere", "radius", "5 mm", "radius", "must be a number in m"),
        ("sphere", "center", None, "center", "is None; it must be a list of 3 numbers"),
        ("cylinder", "radius", 0.0, "radius", "greater than 0 m"),
        ("cylinder", "end", [0, 0, 0], "end", "the same point as start"),
        ("box", "size", [0.1, 0, 0.1], "size[1]", "is 0 m; it must be greater than 0 m"),
        ("box", "size", [0.1, 0.1, -2], "size[2]", "is -2 m"),
        ("box", "size", 0.1, "size", "must be a list of 3 numbers"),
        ("box", "quaternion", [0, 0, 0, 0], "quaternion", "its length is zero"),
        ("mesh", "vertices", [], "vertices", "has 0 rows; it must have at least 3"),
        ("mesh", "vertices", "all", "vertices", "is 'all'; it must be at least 3 lists"),
        ("mesh", "vertices", [0, 0, 0], "vertices[0]", "is 0; it must be a list of 3 numbers"),
        ("mesh", "vertices", [*CORNERS, [0, 1]], "vertices[4]", "must be a list of 3 numbers"),
        ("mesh", "vertices", [*CORNERS, [0, NAN, 1]], "vertices[4][1]", "is nan"),
        ("mesh", "vertices", [*CORNERS, [0, 1, 10**40]], "vertices[4][2]", "at most 1e+30"),
        ("mesh", "vertices", [*CORNERS, [0, 1, "1"]], "vertices[4][2]", "must be a number"),
        ("mesh", "vertices", [*CORNERS, [0, True, 1]], "vertices[4][1]", "must be a number"),
        ("mesh", "vertices", [*CORNERS, {"x": 0}], "vertices[4]", "must be a list of 3 numbers"),
        ("mesh", "triangles", [], "triangles", "is empty; it must have at least 1 row"),
        ("mesh", "triangles", [[0, 1]], "triangles[0]", "must be a list of 3 numbers"),
        (
            "mesh",
            "triangles",
            [[0, 1, 2], [0, 1, 4]],
            "triangles[1][2]",
            "from 0 to 3, as there are 4",
        ),
        (
            "mesh",
            "triangles",
            [[0, 1, 2], [0, -1, 2]],
            "triangles[1][1]",
            "is -1; it must be from 0",
        ),
        ("mesh", "triangles", [[0, 1, 2.0]], "triangles[0][2]", "must be a whole number"),
        ("mesh", "triangles", [[0, 1, 10**30]], "triangles[0][2]", "must be a whole number"),
        ("mesh", "triangles", [[0, 1, True]], "triangles[0][2]", "must be a whole number"),
        ("mesh", "triangles", [[0, 0, 1], [2, 2, 2]], "triangles", "are 2, but none has an area"),
        ("mesh", "triangles", [f[::-1] for f in FACES], "triangles", "enclose -0.166667 m³"),
        ("mesh", "triangles", [[0, 1, 2], [0, 2, 1]], "triangles", "a sheet that is there twice"),
        ("mesh", "triangles", [*FACES[:3], [1, 3, 2]], "triangles", "from (0, 1, 0) to (1, 0, 0)"),
        ("mesh", "triangles", [*FACES, [0, 1, 2]], "triangles", "do not part inside from outside"),
    ],
)
def test_what_is_wrong_is_named(changed, kind, name, value, field, message):
    wrong = {"kind": kind, **RIGHT[kind], name: value}
    right = {"kind": "sphere", **RIGHT["sphere"]}
    with pytest.raises(ProblemError) as caught:
        read_scene(changed("obstacles", [right, wrong]))
    assert caught.value.field == f"obstacles[1].{field}"
    assert message in caught.value.message
    assert "\n" not in str(caught.value) and len(str(caught.value)) < 300


@pytest.mark.parametrize(
    ("path", "value"),
    [
        ("radius", None),
        ("colour", "red"),
    ],
)
def test_fields_that_are_missing_or_unknown(changed, path, value):
    sphere = {"kind": "sphere", **RIGHT["sphere"], path: value}
    if value is None:
        del sphere[path]
    with pytest.raises(ProblemError, match=rf"obstacles\[0\]\.{path}"):
        read_scene(changed("obstacles", [sphere]))


def test_arrays_are_read_as_lists_are():
    mesh = Mesh(np.array(CORNERS, np.float32), np.array(FACES, np.uint16))
    assert mesh.vertices.tolist() == CORNERS and mesh.triangles.tolist() == FACES
    with pytest.raises(ValueError, match="read-only"):
        mesh.vertices[0, 0] = 1
    for wrong in (np.zeros((4, 2)), np.zeros((4, 3), bool), np.zeros(3)):
        with pytest.raises(ProblemError, match="vertices: is an array"):
            Mesh(wrong, FACES)
    with pytest.raises(ProblemError, match=r"vertices\[2\]\[0\]: is inf"):
        Mesh(np.array([*CORNERS[:2], [INFINITE, 0, 0]]), [[0, 1, 2]])


def test_triangles_without_area_are_dropped():
    points = np.array([(0.2, 0.2, 0.5), (0.1, 0.1, 0.2), (0.5, -0.5, 0.2)])
    middle = [*CORNERS, [0.5, 0, 0], [0, 0, 1]]
    odd = Mesh(middle, [*FACES, [0, 4, 1], [3, 5, 1], [2, 2, 2]])
    plain = Mesh(CORNERS, FACES)
    assert odd.nearest(points).distance.tolist() == plain.nearest(points).distance.tolist()


def test_vertices_at_one_place_are_one():
    loose = Mesh(np.array(CORNERS)[FACES].reshape(-1, 3), np.arange(12).reshape(4, 3))
    assert loose.closed and not Mesh(CORNERS, FACES[:3]).closed


def test_bounds_are_of_the_triangles():
    mesh = Mesh([*CORNERS, [9, 9, 9]], FACES)
    assert mesh.bounds.tolist() == [[0, 0, 0], [1, 1, 1]]


@pytest.mark.parametrize(
    ("points", "radius", "message"),
    [
        ([[0, 0, 0]], 0.1, "points: has 1 rows; it must have at least 2"),
        ([[1, 0, 0], [1, 0, 0]], 0.1, "points: are all .* at least two must differ"),
        ([[0, 0, 0], [1, 0, 0]], 0, "radius: is 0 m; it must be greater than 0 m"),
    ],
)
def test_tubes_that_are_none(points, radius, message):
    with pytest.raises(ProblemError, match=message):
        Tube(points, radius)


def test_a_tube_may_have_points_twice():
    tube = Tube([[0, 0, 0], [0, 0, 0], [1, 0, 0], [1, 0, 0]], 0.1)
    found = tube.nearest(np.array([[0.5, 0.3, 0], [-0.3, 0, 0]]))
    assert found.distance == pytest.approx([0.2, 0.2])
