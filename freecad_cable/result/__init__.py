# SPDX-License-Identifier: LGPL-2.1-or-later
"""What was found: the solution, checked independently of how it was found. NumPy only."""

from .solution import Energy, Load, Solution

__all__ = ["Energy", "Load", "Solution"]
