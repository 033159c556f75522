# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a solve ended."""

from enum import Enum


class Status(Enum):
    """Outcome of a solve; the value is the sentence a person reads."""

    CONVERGED = "The cable is in equilibrium."
    UNSTABLE = "The shape found is an equilibrium but not a stable one: the cable would leave it."
    INACCURATE = "An equilibrium was found, but not to the tolerance asked for."
    INFEASIBLE = "No shape of this cable satisfies all requirements."
    NOT_CONVERGED = "The solver found no equilibrium."
    TIME_LIMIT = "The time limit was reached before an equilibrium was found."

    @property
    def success(self) -> bool:
        """Whether the shape may be shown as the shape of the cable."""
        return self is Status.CONVERGED
