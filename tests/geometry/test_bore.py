# SPDX-License-Identifier: LGPL-2.1-or-later
"""A round hole in a triangulated plate: found from a circle, and as near as the torus of its rim says."""

from dataclasses import replace

import numpy as np
import pytest

from freecad_cable.geometry.bore import Bore
from freecad_cable.geometry.nearest import HOLE
from freecad_cable.geometry.surface import Surface
from freecad_cable.transcription import contact

RADIUS, THICKNESS, SIDES = 0.01, 0.004, 48
FLAT_SIDE = RADIUS * np.cos(np.pi / SIDES)
"""Way from the axis to the middle of a side, which is all the room that the triangulation leaves."""
AXIS = np.array([0.0, 0.6, 0.8])


@pytest.fixture
def plate(drilled):
    return Surface(*drilled(np.zeros(3), AXIS, RADIUS, THICKNESS, SIDES))


def bore_of(plate, at):
    """From the circle ``at`` a way along the axis."""
    return Bore.around(at * AXIS, AXIS, RADIUS, lambda x: plate.nearest(x).distance)


@pytest.mark.parametrize("at", [0.0, THICKNESS / 2, THICKNESS])
def test_the_hole_is_found_from_any_circle_on_its_wall(plate, at):
    bore = bore_of(plate, at)
    assert bore.radius == pytest.approx(FLAT_SIDE, rel=1e-9)
    assert [bore.low + at, bore.high + at] == pytest.approx([0, THICKNESS], abs=1e-9)


def around(plate, at, radius):
    return Bore.around(at * AXIS, AXIS, radius, lambda x: plate.nearest(x).distance)


@pytest.mark.parametrize(("at", "radius"), [(-0.1 * RADIUS, 1.1 * RADIUS), (0.0, 2 * RADIUS)])
def test_a_circle_about_a_narrower_hole_as_of_its_chamfer_has_that(plate, at, radius):
    bore = around(plate, at, radius)
    assert bore.radius == pytest.approx(FLAT_SIDE, rel=1e-9)
    assert [bore.low + at, bore.high + at] == pytest.approx([0, THICKNESS], abs=1e-9)


@pytest.mark.parametrize(("at", "radius"), [(-2 * RADIUS, RADIUS), (0.0, 2.6 * RADIUS)])
def test_a_circle_far_from_a_wall_has_no_hole(plate, at, radius):
    assert around(plate, at, radius) is None


@pytest.mark.parametrize(("open_share", "found"), [(0.2, True), (0.5, False)])
def test_a_hole_may_have_a_slot_but_must_be_mostly_there(plate, open_share, found):
    """Where it is open there is nothing."""

    def distance(points):
        across = np.linalg.svd(AXIS[None])[2][1:] @ points.T
        opened = np.arctan2(*across) > np.pi * (1 - 2 * open_share)
        on_axis = np.linalg.norm(across, axis=0) < 1e-9
        return plate.nearest(points).distance + np.where(opened & ~on_axis, RADIUS, 0.0)

    assert (Bore.around(np.zeros(3), AXIS, RADIUS, distance) is not None) == found


def test_how_far_from_the_axis_keeps_a_distance(plate):
    bore, keep = bore_of(plate, 0.0), 0.4 * RADIUS
    assert bore.way(THICKNESS / 2, keep) == pytest.approx(bore.radius - keep)
    assert bore.way(-0.6 * keep, keep) == pytest.approx(bore.radius - 0.8 * keep)
    assert bore.way(-1.1 * keep, keep) == np.inf


@pytest.mark.parametrize(("deep", "found"), [(1.0, True), (0.97, False)])
def test_a_hole_that_is_narrower_farther_down_is_no_bore(deep, found):
    """Four radii deep, and below the first two narrower, maybe."""

    def distance(points):
        along = points @ AXIS / RADIUS
        aside = np.linalg.norm(points / RADIUS - np.outer(along, AXIS), axis=1)
        wall = np.where((along < -2) & (along > -4), deep, 1.0)
        beyond = np.maximum(np.abs(along + 2) - 2, 0.0)
        return RADIUS * np.hypot(np.maximum(wall - aside, 0.0), beyond)

    assert (Bore.around(np.zeros(3), AXIS, RADIUS, distance) is not None) == found


def test_what_is_nearer_than_the_wall_stays(plate):
    """A bump in the hole that is a tenth of the radius high."""
    bore, points = bore_of(plate, 0.0), np.array([[0.5 * RADIUS, 0.0, 0.0]])
    surface = plate.nearest(points)
    bump = replace(surface, distance=surface.distance - 0.1 * RADIUS)
    assert bore.nearest(points, surface).feature == [HOLE]
    assert bore.nearest(points, bump).distance == bump.distance


def points_inside(random, bore):
    """Within the hole's circle, up to a radius beyond its rims."""
    across = np.linalg.svd(AXIS[None])[2][1:]
    angle, aside = random.uniform(0, 2 * np.pi, 300), bore.radius * random.uniform(0.1, 0.98, 300)
    around = aside[:, None] * (np.stack([np.cos(angle), np.sin(angle)], axis=1) @ across)
    return around + random.uniform(-RADIUS, THICKNESS + RADIUS, 300)[:, None] * AXIS


def test_distance_is_that_of_the_surface_and_the_normal_its_gradient(plate, random):
    bore = bore_of(plate, 0.0)
    points = points_inside(random, bore)
    found = bore.nearest(points, plate.nearest(points))
    assert (found.feature == HOLE).all()
    # A corner between two sides is farther from the axis than their middles, by no more than this.
    assert (
        np.abs(found.distance - plate.nearest(points).distance).max() <= RADIUS - FLAT_SIDE + 1e-12
    )
    step = 1e-7
    for i in range(3):
        shift = step * np.eye(3)[i]
        ahead, behind = (
            bore.nearest(x, plate.nearest(x)).distance for x in (points + shift, points - shift)
        )
        # Central differences are off by (step / distance)², and no point is nearer than 2e-4.
        assert (ahead - behind) / (2 * step) == pytest.approx(found.normal[:, i], abs=1e-5)


def test_a_point_sunk_into_the_wall_is_to_go_back_into_the_hole(plate):
    bore = bore_of(plate, 0.0)
    sideways = np.array([1.0, 0.0, 0.0])
    point = (0.1 * THICKNESS * AXIS + 1.3 * RADIUS * sideways)[None]
    outside = plate.nearest(point)
    assert outside.distance == pytest.approx([-0.1 * THICKNESS])
    found = bore.nearest(point, outside)
    assert found.normal[0] == pytest.approx(-sideways)
    assert found.distance == pytest.approx([bore.radius - 1.3 * RADIUS])


def test_the_row_of_a_hole_is_zero_at_the_distance_to_keep_and_grows_as_the_distance(plate, random):
    """Places at the distance to keep from the rim or the wall, and what is beside them."""
    bore, keep = bore_of(plate, 0.0), 0.4 * RADIUS
    beyond = random.uniform(-0.95 * keep, 0.95 * keep, 200)
    along = np.where(beyond < 0, beyond, THICKNESS + beyond)
    aside = bore.radius - np.sqrt(keep**2 - beyond**2)
    sideways = np.array([1.0, 0.0, 0.0])
    points = aside[:, None] * sideways + along[:, None] * AXIS
    nearest = bore.nearest(points, plate.nearest(points))
    rows = contact.parameters(nearest, keep)
    assert nearest.distance == pytest.approx(np.full(200, keep))
    assert contact.value(points, rows) == pytest.approx(np.zeros(200), abs=1e-15)
    assert contact.slope(points, rows) == pytest.approx(nearest.normal, abs=1e-9)


def test_past_the_rim_the_hole_is_not_in_the_way(plate):
    bore, keep = bore_of(plate, 0.0), 0.4 * RADIUS
    point = (-1.01 * keep * AXIS)[None]
    rows = contact.parameters(bore.nearest(point, plate.nearest(point)), keep)
    assert np.array_equal(rows, [contact.NONE])
