# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether the nodes are held as the scene says, asked in other words than those in which it was solved."""

import numpy as np

from ..geometry import rotation
from ..problem import Clamp, Clamped, Pinned, Ring, Sleeve, Swivel
from ..problem.reach import play


def end_violation(scene, position, quaternion) -> float:
    """Largest violation of an end condition by nodes (n+1, 3) [m] and (n+1, 4): distances relative to the length,
    directions and frames as the length of the difference of unit vectors."""
    found = [0.0]
    for end, node in ((scene.start, 0), (scene.end, -1)):
        if isinstance(end, Pinned):
            found.append(np.linalg.norm(position[node] - end.position) / scene.rod.length)
        if isinstance(end, Swivel):
            found.append(np.linalg.norm(rotation.tangent(quaternion[node]) - end.tangent))
        if isinstance(end, Clamped):
            frames = rotation.matrix(np.stack([quaternion[node], end.quaternion]))
            found.append(np.abs(frames[0] - frames[1]).max())
    return float(max(found))


def support_violation(scene, nodes, arc_length, position, quaternion) -> float:
    """Largest violation of a support at ``nodes``, as above; given arc lengths relative to the length too. Infinite
    where the supports are not in order along the cable."""
    found, length = [0.0], scene.rod.length
    if not nodes:
        return 0.0
    if (np.diff(arc_length[[0, *nodes, -1]]) <= 0).any():
        return float("inf")
    for support, node in zip(scene.supports, nodes, strict=True):
        offset = position[node] - support.position
        frame = rotation.matrix(quaternion[node])
        if not support.slides:
            found.append(abs(arc_length[node] - support.arc_length) / length)
        if isinstance(support, Ring):
            found.append(abs(offset @ support.axis) / length)
            found.append((np.linalg.norm(offset) - play(support, scene.rod)) / length)
        else:
            found.append(np.linalg.norm(offset) / length)
        if isinstance(support, Sleeve):
            found.append(np.linalg.norm(frame[:, 2] - support.tangent))
        if isinstance(support, Clamp):
            found.append(np.abs(frame - rotation.matrix(support.quaternion)).max())
    return float(max(found))
