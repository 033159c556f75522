# SPDX-License-Identifier: LGPL-2.1-or-later
"""Comparison curves without mechanics: what a drawing would show, beside what a cable does."""

from .methods import METHODS, catenary_route, chord_route, inputs, spline_route
from .route import LengthDifference, Route, compare

__all__ = [
    "METHODS",
    "LengthDifference",
    "Route",
    "catenary_route",
    "chord_route",
    "compare",
    "inputs",
    "spline_route",
]
