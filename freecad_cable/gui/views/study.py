# SPDX-License-Identifier: LGPL-2.1-or-later
"""A family of shapes, coloured by its values."""

from ...study.colours import scale
from .view import View


class StudyView(View):
    icon_name = "cable_study"

    def claimChildren(self):
        return [self.object.Sheet] if self.object.Sheet else []

    def updateData(self, study, name):
        if name == "DrawnValues":
            self._colour(study)

    def _colour(self, study):
        parts = study.Shape.SubShapes if not study.Shape.isNull() else []
        if len(parts) != len(study.DrawnValues):
            return
        faces, edges = [], []
        for part, colour in zip(parts, scale(study.DrawnValues), strict=True):
            faces += [(*colour, 0.0)] * len(part.Faces)
            edges += [(*colour, 0.0)] * len(part.Edges)
        if faces:
            study.ViewObject.DiffuseColor = faces
        elif edges:
            study.ViewObject.LineColorArray = edges
            study.ViewObject.LineWidth = 3
