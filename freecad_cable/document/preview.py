# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a cable would lie while what it depends on still moves: a line, of which the document knows nothing."""

from dataclasses import replace

import numpy as np

from ..equilibrium import find_equilibrium
from ..errors import DocumentError
from ..geometry import rotation
from ..geometry.curves import Curve
from ..result import Solution
from ..shape.units import from_si, to_si
from . import complaint
from .read_scene import read_scene
from .stored_solution import kept

TOLERANCE = 1e-3
"""Error of position, relative to the length: below a pixel of a window that shows the whole cable."""

PATIENCE = 2.0
"""[s] after which a hand that moves something gets no line."""

POINTS = 4
"""of the line from node to node"""


class Preview:
    """Of one cable; each solve starts from the last."""

    def __init__(self, cable):
        self.cable = cable
        self.last = None

    def work(self):
        """``work(watch)``, which solves the cable as it is stated now and gives a ``Solution``; it sees no document.

        Errors: ``DocumentError`` if the statement is wrong.
        """
        cable = self.cable
        for holder in {cable.Start, *cable.Supports, cable.End} - {None}:
            if "Touched" in holder.State:
                holder.recompute()
        scene = read_scene(cable)
        if scene.asks_length:
            # To ask anew would take seconds.
            if not cable.SolvedLength.Value:
                raise DocumentError(f"{cable.Label}: its length is not found yet.")
            length = to_si("length", cable.SolvedLength)
            scene = replace(scene, rod=replace(scene.rod, length=length), asks_length=False)
        tolerance = max(TOLERANCE, scene.options.tolerance)
        options = replace(scene.options, tolerance=tolerance, time_limit=PATIENCE)
        scene = replace(scene, options=options)
        start = self.last or kept(cable, scene)
        return lambda watch: find_equilibrium(scene, start=start, watch=watch)

    def keep(self, solution: Solution):
        """The next solve starts from here."""
        if solution.status.success:
            self.last = solution


def line(solution: Solution) -> list[tuple]:
    """Points of the centreline [mm], in the coordinates of the container of the cable."""
    tangent = rotation.tangent(solution.quaternion)
    curve = Curve(solution.arc_length, solution.position, tangent)
    s = solution.arc_length
    dense = np.interp(np.arange(POINTS * (len(s) - 1) + 1) / POINTS, np.arange(len(s)), s)
    return [tuple(point) for point in from_si("length", curve.at(dense)[0]).tolist()]


def in_words(cable, solution: Solution) -> str:
    """How the preview of a cable ended."""
    return f"{cable.Label}: {complaint.in_words(cable, solution.message)}"
