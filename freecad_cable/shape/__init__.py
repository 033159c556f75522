# SPDX-License-Identifier: LGPL-2.1-or-later
"""From solved nodes to shapes of FreeCAD, and from FreeCAD's units to SI and back.

Everything that leaves this room as a shape is in millimetres, in the frame of the nodes, with identity
location: the document moves it.
"""

# Outside FreeCAD, Python crashes if Part is imported first.
import FreeCAD  # noqa: F401
