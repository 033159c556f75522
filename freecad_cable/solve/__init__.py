# SPDX-License-Identifier: LGPL-2.1-or-later
"""From an optimal control problem to an equilibrium: solvers, continuation, mesh, stability, error."""
