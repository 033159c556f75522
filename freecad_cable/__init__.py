# SPDX-License-Identifier: LGPL-2.1-or-later
"""Flexible cables for FreeCAD: shapes and lengths that follow from mechanics.

The rooms, in the order in which data walks through them; each imports only from its left:

    geometry  problem  transcription  solve  result  routes | shape  document  gui

Left of the bar nothing imports FreeCAD; only ``transcription`` and ``solve`` import CasADi.
"""

__version__ = "0.1.0"
