# SPDX-License-Identifier: LGPL-2.1-or-later
"""The objects of a document: their properties, the scene they state, the results they keep.

FreeCAD's units outside (mm), SI inside; ``shape.units`` is the border. FreeCAD and Part, never Qt or
FreeCADGui. A macro starts with ``from freecad_cable.document import make``.

The module and class of every proxy and the name of every property are written into users' files:
they are a file format and may not be renamed.
"""
