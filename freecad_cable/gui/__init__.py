# SPDX-License-Identifier: LGPL-2.1-or-later
"""The window: workbench, commands, view providers. FreeCADGui and Qt live here and nowhere else.

It edits properties and asks the document to recompute; it neither solves nor knows the solver.
"""
