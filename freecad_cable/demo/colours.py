# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours of the demo, in pictures and in FreeCAD's window."""

COLOURS = (
    "#1f6fb4",
    "#d9541e",
    "#2a9d4a",
    "#8e44ad",
    "#c49a00",
    "#c2185b",
    "#00939c",
    "#7a5230",
    "#3f51b5",
    "#5a8f00",
)
"""Of the cables, in order; dark enough for text."""

METAL = "#c9d1d8"
"""Of the equipment."""
