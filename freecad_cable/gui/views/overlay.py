# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the window draws over a cable and the document does not know: nodes of the scene graph."""

from pivy import coin

LIVE = (0.96, 0.47, 0.0)
"""RGB of the line that follows a hand"""

FADED = 0.75
"""Transparency of a solid that is not up to date"""


class Fade:
    """Lets what follows in a scene graph shine through, or not."""

    def __init__(self):
        self.node = coin.SoSwitch()
        material = coin.SoMaterial()
        for field in (
            "ambientColor",
            "diffuseColor",
            "specularColor",
            "emissiveColor",
            "shininess",
        ):
            getattr(material, field).setIgnored(True)
        material.transparency.setValue(FADED)
        material.setOverride(True)
        self.node.addChild(material)
        self.set(False)

    def set(self, on):
        self.node.whichChild.setValue(coin.SO_SWITCH_ALL if on else coin.SO_SWITCH_NONE)

    @property
    def on(self):
        return self.node.whichChild.getValue() != coin.SO_SWITCH_NONE


class Drawing:
    """A part of the scene graph that can be seen or not, and not be picked."""

    def __init__(self):
        self.node = coin.SoSwitch()
        self.content = coin.SoSeparator()
        style = coin.SoPickStyle()
        style.style = coin.SoPickStyle.UNPICKABLE
        self.content.addChild(style)
        self.node.addChild(self.content)
        self.show(False)

    def show(self, on):
        self.node.whichChild.setValue(coin.SO_SWITCH_ALL if on else coin.SO_SWITCH_NONE)

    @property
    def shown(self):
        return self.node.whichChild.getValue() != coin.SO_SWITCH_NONE


class Line(Drawing):
    """A line of one colour, of the same width at every distance."""

    def __init__(self, colour=LIVE, width=3):
        super().__init__()
        light = coin.SoLightModel()
        light.model = coin.SoLightModel.BASE_COLOR
        base, style = coin.SoBaseColor(), coin.SoDrawStyle()
        base.rgb.setValue(*colour)
        style.lineWidth = width
        self._points, self._line = coin.SoCoordinate3(), coin.SoLineSet()
        for node in (light, base, style, self._points, self._line):
            self.content.addChild(node)

    def draw(self, points):
        """Through ``points`` (x, y, z)."""
        self._points.point.setNum(len(points))
        self._points.point.setValues(0, len(points), points)
        self._line.numVertices.setValue(len(points))
        self.show(True)

    @property
    def points(self):
        return [tuple(self._points.point[i]) for i in range(self._points.point.getNum())]
