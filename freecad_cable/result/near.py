# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether an earlier solution is a start for a scene: so near that a cable moved from there to here would keep its
branch. From farther away the iteration may end on any, and the answer would depend on the history of the document."""

import numpy as np

from ..geometry import rotation
from ..problem import Clamp, Clamped, Pinned, Ring, Support
from ..problem.reduce import orientation

NEAR = 0.1
"""Change of length, of a held place in lengths and of its direction in half turns, up to which an earlier shape is
a start."""


def is_near(solution, scene, near=NEAR) -> bool:
    """Whether an earlier solution, of any scene, is a start for this one."""
    length = scene.rod.length
    if abs(solution.arc_length[-1] / length - 1) > near:
        return False
    if len(solution.support_nodes) != len(scene.supports):
        return False
    held = zip(
        (scene.start, *scene.supports, scene.end), (0, *solution.support_nodes, -1), strict=True
    )
    if not all(_holds_nearly(holder, solution, node, length, near) for holder, node in held):
        return False
    # The old moments must be nearly those of this rod, or stiffness has changed by more than a start can bear: to twice
    # or half.
    moment = np.einsum("kij,ki->kj", rotation.matrix(solution.quaternion), solution.moment)
    ours = scene.rod.stiffness * (solution.curvature - scene.rod.natural_curvature)
    larger = max(np.abs(moment).max(), np.abs(ours).max())
    return bool(np.abs(moment - ours).max() <= 0.5 * (1 + 1e-9) * larger)


def _holds_nearly(holder, solution, node, length, near) -> bool:
    """Whether an end or a support moved little from where an earlier solution had it."""
    if not isinstance(holder, (Pinned, Support)):
        return True
    quaternion = solution.quaternion[node]
    moved = np.linalg.norm(solution.position[node] - holder.position) / length
    if isinstance(holder, Ring):
        moved -= holder.radius / length
    if isinstance(holder, Support) and not holder.slides:
        moved = max(moved, abs(solution.arc_length[node] - holder.arc_length) / length)
    turned = 0.0
    if isinstance(holder, (Clamped, Clamp)):
        # The real part of the turn from one frame to the other.
        turned = 2 * np.arccos(min(1.0, abs(holder.quaternion @ quaternion)))
    elif (tangent := orientation(holder)) is not None:
        turned = np.arccos(np.clip(rotation.tangent(quaternion) @ tangent, -1.0, 1.0))
    return moved <= near and turned <= np.pi * near
