# SPDX-License-Identifier: LGPL-2.1-or-later
"""What was found: the solution, checked independently of how it was found. NumPy and SciPy."""

from .balance import Balance, Pushes, balance
from .bend import smallest_bend_radius
from .ends import end_violation, support_violation
from .near import is_near
from .solution import Contact, Energy, Formed, LengthBound, Load, Solution

__all__ = [
    "Balance",
    "Contact",
    "Energy",
    "Formed",
    "LengthBound",
    "Load",
    "Pushes",
    "Solution",
    "balance",
    "end_violation",
    "is_near",
    "smallest_bend_radius",
    "support_violation",
]
