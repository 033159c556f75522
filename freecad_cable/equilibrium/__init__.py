# SPDX-License-Identifier: LGPL-2.1-or-later
"""The front door of the core: a scene in, its equilibrium out. Loads without CasADi."""

from .find import find_equilibria, find_equilibrium

__all__ = ["find_equilibria", "find_equilibrium"]
