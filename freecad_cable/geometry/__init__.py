# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rotations and curves in space, without mechanics. NumPy and SciPy only; no units of its own."""
