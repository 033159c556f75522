# SPDX-License-Identifier: LGPL-2.1-or-later
# FreeCAD runs this file at every start, so it does nothing: the objects of a stored document bring
# in what they need when it opens.
