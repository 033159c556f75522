# SPDX-License-Identifier: LGPL-2.1-or-later
"""Studies: one property of a scene over a range, a motion, a tolerance. Loads without CasADi.

A family of scenes is a function from a number to a ``Scene``: ``Parameter.of`` of a scene, or what a document gives.
"""

from .cases import corners, random_cases, run
from .motion import Motion, motion, needed_length
from .parameter import Parameter
from .path import Jump, Step, follow
from .row import Row
from .variation import Variation, length_tolerance

__all__ = [
    "Jump",
    "Motion",
    "Parameter",
    "Row",
    "Step",
    "Variation",
    "corners",
    "follow",
    "length_tolerance",
    "motion",
    "needed_length",
    "random_cases",
    "run",
]
