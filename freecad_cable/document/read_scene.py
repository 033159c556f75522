# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the properties of a cable and what it links to, to the scene that states its problem."""

from dataclasses import replace

from ..problem import Scene
from .obstacles import read_obstacles
from .read_held import read_held


def read_scene(cable, asks_length=False) -> Scene:
    """The scene of a cable, in the coordinates of its container. ``asks_length``: as if its ``LengthMode`` were
    Shortest. Errors: ``DocumentError``."""
    scene = read_held(cable, asks_length)
    return replace(scene, obstacles=read_obstacles(cable, scene))
