# SPDX-License-Identifier: LGPL-2.1-or-later
"""What can go wrong, as sentences for a person: what, where, which value, which bound, what to do."""


class CableError(Exception):
    """Base of every error this package raises on purpose."""


class ProblemError(CableError, ValueError):
    """The statement of the problem is wrong.

    ``field`` names the place in the words of the scene file (``cable.length``, ``start.quaternion``),
    so that the command line, a macro and the document can all point at it.
    """

    def __init__(self, field: str, message: str):
        super().__init__(f"{field}: {message}")
        self.field = field
        self.message = message


class NotYetError(ProblemError):
    """The statement is right, but this version cannot solve it."""


class SolverMissingError(CableError, ImportError):
    """CasADi is not installed."""


class StoppedError(CableError):
    """Whoever watched a solve has stopped it."""


class SolveError(CableError):
    """No equilibrium was found; raised on request only and carries the solution with its status."""

    def __init__(self, solution):
        super().__init__(solution.message)
        self.solution = solution


class DocumentError(CableError):
    """A link, a shape or a property of the document cannot be used."""
