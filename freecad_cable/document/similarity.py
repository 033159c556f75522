# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where containers and links put an object, which links may scale."""

import numpy as np
from FreeCAD import Matrix, Placement

from ..errors import DocumentError

TOLERANCE = 1e-9
"""Relative: what is less is rounding."""


def similarity(label, matrix) -> tuple[Placement, float]:
    """The placement and the scale that ``matrix`` stands for; a ``Placement`` of it would have a wrong rotation.

    Errors: ``DocumentError`` that names the object, if ``matrix`` stretches or mirrors it.
    """
    numbers = np.reshape(matrix.A, (4, 4))
    axes = numbers[:3, :3]
    scale = float(np.cbrt(np.linalg.det(axes)))
    if not scale > 0 or abs(axes.T @ axes / scale**2 - np.eye(3)).max() > TOLERANCE:
        raise DocumentError(
            f"{label} is stretched or mirrored by the scale of a link; let the link have one scale for all axes, "
            "greater than 0."
        )
    axes /= scale
    return Placement(Matrix(*numbers.ravel().tolist())), scale
