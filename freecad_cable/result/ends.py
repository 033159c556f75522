# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether the nodes are held as the scene says, asked in other words than those in which it was solved."""

import numpy as np

from ..geometry import rotation
from ..problem import Clamped, Pinned, Swivel


def end_violation(scene, position, quaternion) -> float:
    """Largest violation of an end condition by nodes (n+1, 3) [m] and (n+1, 4): distances relative to the length,
    directions and frames as the length of the difference of unit vectors."""
    found = [0.0]
    for end, node in ((scene.start, 0), (scene.end, -1)):
        if isinstance(end, Pinned):
            found.append(np.linalg.norm(position[node] - end.position) / scene.rod.length)
        frame = rotation.matrix(quaternion[node])
        if isinstance(end, Swivel):
            found.append(np.linalg.norm(frame[:, 2] - end.tangent))
        if isinstance(end, Clamped):
            found.append(np.abs(frame - rotation.matrix(end.quaternion)).max())
    return float(max(found))
