# SPDX-License-Identifier: LGPL-2.1-or-later
"""Markings on a cable: its bend radius as colour, its tightest place, forces as arrows, contacts."""

import math

from pivy import coin

from .overlay import Drawing

VIOLATED, SCARCE, FAIR, GOOD = (
    (0.8, 0.0, 0.0),
    (0.96, 0.47, 0.0),
    (0.93, 0.83, 0.0),
    (0.3, 0.6, 0.02),
)
NO_LIMIT = (0.45, 0.62, 0.81)
WORDS = (1.0, 1.0, 1.0)
CONTACT, FORCE = (0.2, 0.4, 0.64), (0.46, 0.31, 0.48)

STEPS = ((0.1, SCARCE), (0.5, FAIR), (1.0, GOOD))
"""Margin, as a share of the limit, where a colour is reached; below the first it is that of the first."""

HEAD = 0.25
"""Of an arrow, as a share of its length."""


def colour(margin):
    """RGB of a margin; red is only where the limit is violated."""
    if margin < 0:
        return VIOLATED
    below = STEPS[0]
    for above in STEPS:
        if margin <= above[0]:
            span = above[0] - below[0]
            share = (margin - below[0]) / span if span else 1.0
            return tuple(a + share * (b - a) for a, b in zip(below[1], above[1], strict=True))
        below = above
    return STEPS[-1][1]


class Skin(Drawing):
    """The surface, coloured."""

    def __init__(self):
        super().__init__()
        hints, binding = coin.SoShapeHints(), coin.SoMaterialBinding()
        hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
        hints.creaseAngle = 1.0
        binding.value = coin.SoMaterialBinding.PER_VERTEX
        self._material, self._points = coin.SoMaterial(), coin.SoCoordinate3()
        self._mesh = coin.SoQuadMesh()
        for node in (hints, binding, self._material, self._points, self._mesh):
            self.content.addChild(node)

    def draw(self, found):
        """A ``document.markings.Coloured``."""
        margins = found.margins
        rows = [NO_LIMIT] * found.rows if margins is None else [colour(m) for m in margins]
        colours = [rgb for rgb in rows for _ in range(found.columns)]
        for field, values in (
            (self._points.point, found.points),
            (self._material.diffuseColor, colours),
        ):
            field.setNum(len(values))
            field.setValues(0, len(values), values)
        self._mesh.verticesPerRow = found.columns
        self._mesh.verticesPerColumn = found.rows
        self.show(True)

    @property
    def colours(self):
        """Those drawn, one a point."""
        field = self._material.diffuseColor
        return [tuple(field[i]) for i in range(field.getNum())]


class Marks(Drawing):
    """Balls or arrows of one colour, with words."""

    def __init__(self, rgb):
        super().__init__()
        self._material = coin.SoMaterial()
        self._material.diffuseColor = rgb
        self._marks = coin.SoSeparator()
        self.content.addChild(self._material)
        self.content.addChild(self._marks)

    @property
    def count(self):
        return self._marks.getNumChildren()

    def draw_balls(self, marks, radius):
        """At the places of ``document.markings.Mark``, of ``radius`` [mm]."""
        self._marks.removeAllChildren()
        for mark in marks:
            ball = coin.SoSphere()
            ball.radius = radius
            self._add(mark, radius, ball)
        self.show(bool(marks))

    def draw_arrows(self, marks, length, width):
        """That show the forces; the greatest is ``length`` long, all are ``width`` thick [mm]."""
        self._marks.removeAllChildren()
        sizes = [math.hypot(*mark.force) for mark in marks]
        for mark, size in zip(marks, sizes, strict=True):
            long = length * size / max(sizes)
            head = min(HEAD * length, long)
            self._add(mark, 0.0, *_arrow(mark.force, long, head, width), at=long)
        self.show(bool(marks))

    def _add(self, mark, radius, *nodes, at=0.0):
        group, place = coin.SoSeparator(), coin.SoTranslation()
        place.translation = mark.place
        group.addChild(place)
        for node in nodes:
            group.addChild(node)
        group.addChild(_words(mark, radius, at))
        self._marks.addChild(group)


def _arrow(force, long, head, width):
    """Along ``force``, its tip ``long`` from the origin. Coin's cylinders and cones stand along y."""
    turn, middle, top = coin.SoRotation(), coin.SoTranslation(), coin.SoTranslation()
    turn.rotation = coin.SbRotation(coin.SbVec3f(0, 1, 0), coin.SbVec3f(*force))
    shaft, tip = coin.SoCylinder(), coin.SoCone()
    shaft.radius, shaft.height = width / 2, max(long - head, 1e-6)
    tip.bottomRadius, tip.height = 1.5 * width, head
    middle.translation = (0, (long - head) / 2, 0)
    top.translation = (0, long / 2, 0)
    both = coin.SoSeparator()
    for node in (turn, middle, shaft, top, tip):
        both.addChild(node)
    return [both]


def _words(mark, radius, at):
    """Beside the ball, or at the tip of the arrow."""
    words, place, text = coin.SoSeparator(), coin.SoTranslation(), coin.SoText2()
    light, ink, font = coin.SoLightModel(), coin.SoBaseColor(), coin.SoFont()
    light.model = coin.SoLightModel.BASE_COLOR
    ink.rgb = WORDS
    font.size = 14
    size = math.hypot(*mark.force) or 1.0
    place.translation = [1.2 * at * part / size + radius for part in mark.force]
    text.string = mark.text
    for node in (light, ink, font, place, text):
        words.addChild(node)
    return words
