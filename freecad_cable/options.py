# SPDX-License-Identifier: LGPL-2.1-or-later
"""How to solve, as plain data, so that the document can name it without CasADi."""

from dataclasses import dataclass

from .errors import ProblemError

SOLVERS = ("auto", "fatrop", "ipopt")
SCHEMES = ("auto", "helix", "magnus")
EFFECTS = ("torsion", "shear", "stretch")
"""What the model of a rod may leave out."""


@dataclass(frozen=True, kw_only=True)
class SolveOptions:
    """Options of one solve. Errors: ``ProblemError`` naming the option."""

    tolerance: float = 1e-4
    """Largest position error asked for, relative to the length of the cable."""
    solver: str = "auto"
    """``fatrop``, ``ipopt``, or ``auto``: fatrop first, ipopt when it is missing or fails."""
    scheme: str = "auto"
    """``helix`` (order 2), ``magnus`` (order 4), or ``auto``."""
    elements: int | None = None
    """Number of elements; None lets the error estimate decide."""
    keep: tuple[str, ...] = ()
    """Which of ``EFFECTS`` to keep in the model although the scene does not seem to need them."""
    time_limit: float = 60.0
    """Seconds of wall-clock time after which the solve gives up."""

    def __post_init__(self):
        if not 1e-10 <= self.tolerance <= 0.1:
            raise ProblemError(
                "options.tolerance", f"is {self.tolerance!r}; it must be between 1e-10 and 0.1"
            )
        if self.solver not in SOLVERS:
            raise ProblemError(
                "options.solver", f"is {self.solver!r}; it must be one of {', '.join(SOLVERS)}"
            )
        if self.scheme not in SCHEMES:
            raise ProblemError(
                "options.scheme", f"is {self.scheme!r}; it must be one of {', '.join(SCHEMES)}"
            )
        if self.elements is not None and not 2 <= self.elements <= 10000:
            raise ProblemError(
                "options.elements", f"is {self.elements!r}; it must be between 2 and 10000"
            )
        unknown = [name for name in self.keep if name not in EFFECTS]
        if unknown:
            raise ProblemError(
                "options.keep", f"has {unknown[0]!r}; it may have {', '.join(EFFECTS)}"
            )
        if not self.time_limit > 0:
            raise ProblemError(
                "options.time_limit", f"is {self.time_limit!r} s; it must be greater than 0"
            )
