# SPDX-License-Identifier: LGPL-2.1-or-later
"""The demo: cables on real input, headless, into a folder.

Uses the document as a macro would, and adds tables and pictures. ``./run demo`` calls
``program.main``, and FreeCAD's window ``example.make_document``, which needs no matplotlib.
"""
