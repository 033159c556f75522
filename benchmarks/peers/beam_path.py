# SPDX-License-Identifier: LGPL-2.1-or-later
"""The way of a beam code into a task: it begins straight and unloaded, and its end has to be led to where it is held.

Frame of the start, x along the beam, y and z in the section. By the way *over an arc* the end first turns as the end of
the arc that the beam then forms, which needs no force, and then moves to its place while the weight comes on; by the
*straight* way it does all of that at once.
"""

import numpy as np

from benchmarks.peers.task import Task
from freecad_cable.geometry import rotation

BEAM_AXES = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
"""Rows x, y, z of a beam in the material frame: d3, d1, d2."""


def to_beam(task: Task, vector):
    """World → frame of the start, (..., 3)."""
    return vector @ (rotation.matrix(task.start_quaternion) @ BEAM_AXES.T)


def to_world(task: Task, position):
    """Places (n+1, 3) in the frame of the start → world."""
    return task.start_position + position @ (rotation.matrix(task.start_quaternion) @ BEAM_AXES.T).T


class Path:
    """Where the end is from time 0 to 1, and how much of the weight acts."""

    def __init__(self, task: Task):
        self.length = task.length
        turn = rotation.multiply(rotation.conjugate(task.start_quaternion), task.end_quaternion)
        self.turn = BEAM_AXES @ rotation.logarithm(turn)
        self.target = to_beam(task, task.end_position - task.start_position)
        self.arc_end = self._arc(1.0)

        self.middle = 0.5 if task.variant == "over an arc" else 0.0
        """time at which the arc is done"""

    def _arc(self, share):
        """End of the arc that turns by a share of the whole turn: L times the mean of its tangents."""
        s = (np.arange(2000) + 0.5) / 2000
        turns = rotation.exponential(np.outer(s * share, self.turn))
        return self.length * rotation.rotate(turns, (1.0, 0.0, 0.0)).mean(axis=0)

    def place(self, time):
        """(3,) in the frame of the start"""
        if time < self.middle:
            return self._arc(time / self.middle)
        first = self.arc_end if self.middle else np.array([self.length, 0.0, 0.0])
        return first + self.weight(time) * (self.target - first)

    def rotation(self, time):
        """(3,) rotation vector in the frame of the start"""
        return min(time / (self.middle or 1.0), 1.0) * self.turn

    def weight(self, time):
        """share of the weight"""
        return max(0.0, (time - self.middle) / (1 - self.middle))
