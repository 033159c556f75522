# SPDX-License-Identifier: LGPL-2.1-or-later
# FreeCAD runs this file at every start, so it does little: the objects of a stored document bring in
# what they need when it opens.

from freecad_cable.document import material_library

material_library.register()
