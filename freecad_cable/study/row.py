# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a study records of one value or one case."""

from dataclasses import dataclass, field

import numpy as np

from ..result import Solution


@dataclass(frozen=True, kw_only=True)
class Row:
    """Numbers of one solve, in SI units; None where there are none. Rows that differ in ``time`` only are equal."""

    values: tuple[float, ...]
    """of the parameters"""
    length: float | None = None
    """[m]"""
    smallest_bend_radius: float | None = None
    """[m] of the centreline; infinite if it is straight"""
    smallest_bend_radius_at: float | None = None
    """[m] from the start"""
    bend_radius_margin: float | None = None
    """[m] above the limit of the cable"""
    smallest_clearance: float | None = None
    """[m] to the obstacles in reach"""
    contact_force: float | None = None
    """[N] sum of what obstacles exert"""
    start_force: float | None = None
    """[N]"""
    start_moment: float | None = None
    """[N m]"""
    end_force: float | None = None
    end_moment: float | None = None
    energy: float | None = None
    """[J]"""
    stable: bool | None = None
    position_error: float | None = None
    """[m] estimated"""
    solved: bool = False
    """whether the shape may be used"""
    holds: bool = False
    """whether it is solved, keeps its bend radius and its clearance"""
    time: float = field(default=0.0, compare=False)
    """[s]"""
    note: str = ""
    """what happened on the way to this value, a jump to another equilibrium for one"""
    error: str = ""
    """why there is no answer, or why it does not hold"""

    @classmethod
    def of(cls, values, solution: Solution | None, *, time=0.0, note="", error="") -> "Row":
        """The row of a solution; with None, of what failed for the reason ``error``."""
        given = {"values": tuple(map(float, values)), "time": time, "note": note}
        if solution is None or solution.position is None:
            return cls(**given, error=error or solution.message)
        complaint, (radius, place) = _complaint(solution), solution.min_bend_radius
        return cls(
            **given,
            length=solution.scene.rod.length,
            smallest_bend_radius=radius,
            smallest_bend_radius_at=place,
            bend_radius_margin=solution.bend_radius_margin,
            smallest_clearance=solution.min_clearance,
            contact_force=float(sum(np.linalg.norm(c.force) for c in solution.contacts)),
            start_force=float(np.linalg.norm(solution.start_reaction.force)),
            start_moment=float(np.linalg.norm(solution.start_reaction.moment)),
            end_force=float(np.linalg.norm(solution.end_reaction.force)),
            end_moment=float(np.linalg.norm(solution.end_reaction.moment)),
            energy=float(solution.energy.total),
            stable=bool(solution.stable),
            position_error=float(solution.position_error),
            solved=solution.status.success,
            holds=complaint is None,
            error=complaint or "",
        )


def _complaint(solution) -> str | None:
    """Why an answer does not hold."""
    scene = solution.scene
    if not solution.status.success:
        return solution.message
    if solution.bends_too_sharply:
        radius, place = solution.min_bend_radius
        return f"It bends to {radius:.4g} m at {place:.4g} m; the limit is {scene.rod.min_bend_radius:.4g} m."
    if (first := solution.pushed_clear) is not None:
        return (
            f"It must be pushed from {scene.obstacles[first.obstacle].place} at {first.arc_length:.4g} m to keep "
            f"{scene.clearance:.4g} m clear."
        )
    return None
