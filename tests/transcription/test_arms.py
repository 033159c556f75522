# SPDX-License-Identifier: LGPL-2.1-or-later
"""Places between nodes: where they are, what they keep away from, and that the two ways to say so agree."""

import numpy as np
import pytest

from freecad_cable.geometry import rotation
from freecad_cable.geometry.nearest import LINE, Nearest
from freecad_cable.transcription import arms, contact, layout
from freecad_cable.transcription.nlp import build
from freecad_cable.transcription.shape import Joint, Shape
from freecad_cable.transcription.structure import Structure

RADIUS, KEEP = 0.05, 0.01
SCHEMES = ("magnus", "helix")


def program(scheme):
    return build(
        Structure(scheme, (2, 3), "clamped", "clamped", (0, 1, 2), ("sleeve",), (False,), 1)
    )


def bent(scheme):
    """A bent and twisted rod of five elements, with a joint where its curvature jumps."""
    random = np.random.default_rng(4)
    s = np.array([0, 0.2, 0.35, 0.6, 0.8, 1.0])
    quaternion = np.cumsum(np.vstack([[1, 0, 0, 0], 0.2 * random.normal(size=(5, 4))]), axis=0)
    quaternion /= np.linalg.norm(quaternion, axis=1)[:, None]
    strain = np.hstack([random.normal(size=(6, 3)), np.zeros((6, 3))])
    joint = Joint(2, np.append(random.normal(size=3), np.zeros(3)))
    return Shape(
        s, np.cumsum(random.normal(size=(6, 3)), axis=0), quaternion, strain, joints=(joint,)
    )


def across(shape, slides=0.0):
    """Places of a shape on each element, beside cylinders that cross it somehow."""
    random = np.random.default_rng(5)
    n = len(shape.steps)
    beyond = random.uniform(0, 1, (n, 1)) * shape.steps[:, None]
    position, tangent, axis = random.normal(size=(3, n, 3))
    tangent, axis = (each / np.linalg.norm(each, axis=1)[:, None] for each in (tangent, axis))
    center = position + KEEP + RADIUS * random.normal(size=(n, 3))
    lines, radii = np.full(n, LINE), np.full(n, RADIUS)
    features = contact.parameters(Nearest(None, None, lines, center, axis, radii), KEEP)
    owners = np.zeros((n, 1), int)
    given = features[:, None], position[:, None], tangent[:, None], beyond
    return arms.Places(*given, np.full((n, 1), slides), owners)


@pytest.mark.parametrize("scheme", SCHEMES)
def test_a_place_is_where_it_was_looked_up(scheme):
    nlp, shape = program(scheme), bent(scheme)
    places = across(shape)
    touched = arms.read(nlp, layout.variables(nlp, shape), arms.rows(nlp.structure, shape, places))
    np.testing.assert_allclose(touched.position, places.position, atol=1e-13)
    expected = contact.value(places.position[:, 0], places.features[:, 0])
    np.testing.assert_allclose(touched.gap[:, 0], expected, atol=1e-12)


@pytest.mark.parametrize("scheme", SCHEMES)
def test_what_is_read_is_what_the_program_says(scheme):
    nlp, shape = program(scheme), bent(scheme)
    rows = arms.rows(nlp.structure, shape, across(shape, 0.3))
    random = np.random.default_rng(6)
    x = layout.variables(nlp, shape)
    x += 0.1 * random.normal(size=len(x))
    x[nlp.states[:, 3:7]] /= np.linalg.norm(x[nlp.states[:, 3:7]], axis=1)[:, None]
    p = np.zeros(nlp.p.numel())
    p[-rows.size :] = rows.ravel()
    touched = arms.read(nlp, x, rows)
    (g,) = nlp.rows_function(x, p)
    np.testing.assert_allclose(touched.gap, g[nlp.contact_rows], rtol=1e-12)
    # A turn δφ changes a quaternion by ½ δφ ∘ q; of the displacement along the cable the place itself takes part.
    step, states = 1e-6, nlp.states[:-1]
    for axis in np.eye(3):
        moved = [x.copy(), x.copy()]
        turned = [x.copy(), x.copy()]
        for sign, one, other in zip((1, -1), moved, turned, strict=True):
            one[states[:, :3]] += sign * step * axis
            small = rotation.exponential(np.tile(sign * step * axis, (len(states), 1)))
            other[states[:, 3:7]] = rotation.multiply(small, x[states[:, 3:7]])
        for ways, told in ((moved, touched.slope), (turned, touched.turn)):
            high, low = (nlp.rows_function(way, p)[0][nlp.contact_rows] for way in ways)
            # Central differences, of third derivatives of order (1/RADIUS)³, leave step²/RADIUS³.
            np.testing.assert_allclose(told @ axis, (high - low) / (2 * step), atol=1e-7, rtol=1e-7)


def test_a_straight_cable_slides_along_itself_without_resistance():
    nlp = program("magnus")
    s, ahead = np.linspace(0, 1, 6), np.array([0.6, 0.0, 0.8])
    frames = np.tile(rotation.from_tangent(ahead), (6, 1))
    shape = Shape(s, s[:, None] * ahead, frames, np.zeros((6, 6)), joints=(Joint(2, np.zeros(6)),))
    axis = np.array([0.0, 1.0, 0.0])
    center = 0.5 * ahead + 0.04 * np.cross(axis, ahead)
    beyond = np.full((5, 1), 0.07)
    position = shape.position[:-1, None] + 0.07 * ahead
    lines, radii = np.full(5, LINE), np.full(5, RADIUS)
    what = Nearest(None, None, lines, np.tile(center, (5, 1)), np.tile(axis, (5, 1)), radii)
    features = contact.parameters(what, KEEP)[:, None]
    bend = (ahead * contact.bent(ahead[None], features[:1, 0])).sum()
    tangent = np.tile(ahead, (5, 1, 1))
    places = arms.Places(
        features, position, tangent, beyond, np.full((5, 1), 1 / bend), np.zeros((5, 1), int)
    )
    rows, x = arms.rows(nlp.structure, shape, places), layout.variables(nlp, shape)
    # Exact for a line beside a cylinder: the same gap from everywhere, at the same place.
    gap = contact.value((0.5 * ahead)[None], features[:1, 0])
    for along in (0.0, 0.03, -0.2):
        slid = x.copy()
        slid[nlp.states[:, :3]] += along * ahead
        touched = arms.read(nlp, slid, rows)
        np.testing.assert_allclose(touched.gap, np.full((5, 1), gap), atol=1e-14)
        expected = np.tile(0.5 * ahead, (5, 1, 1))
        np.testing.assert_allclose(touched.position, expected, atol=1e-14)
        np.testing.assert_allclose(touched.slope @ ahead, 0.0, atol=1e-13)
