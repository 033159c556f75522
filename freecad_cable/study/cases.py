# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tolerance: many cases of one scene, at random or in the corners, in this process or through an executor.

What is drawn for a case follows from seed and number of the case, and each case starts from the nominal solution: so
the rows do not depend on who solves them and in which order.
"""

from collections import deque
from collections.abc import Callable, Iterator
from concurrent.futures import Executor
from dataclasses import dataclass
from time import perf_counter

import numpy as np

from ..equilibrium import find_equilibrium
from ..errors import ProblemError
from ..problem import Scene
from ..problem.checked import shown
from ..result import Solution
from .row import Row
from .variation import Variation

MOST_CORNERS = 16
"""Parameters of which all corners are tried: 65,536 of them."""
CHUNK = 16
"""Cases that go to a worker at a time: some tenths of a second, against which sending scene and solution is
nothing."""
AHEAD = 256
"""Chunks that wait for workers at most: enough for as many of them, and few enough to be called back in a second where
each costs a message."""


@dataclass(frozen=True, eq=False)
class Cases:
    """Values of the parameters for each number from 0 to ``count``; nothing is kept of them."""

    variations: tuple[Variation, ...]
    count: int
    seed: int | None
    """None: the corners"""

    def values(self, index: int) -> tuple[float, ...]:
        if self.seed is None:
            bits = [(index >> k) & 1 for k in range(len(self.variations))]
            pairs = zip(self.variations, bits, strict=True)
            return tuple(each.high if bit else each.low for each, bit in pairs)
        random = np.random.default_rng([self.seed, index])
        return tuple(each.drawn(random) for each in self.variations)

    def scene(self, nominal: Scene, index: int) -> Scene:
        """The scene of a case. Errors: ``ProblemError`` if these values are none."""
        for each, value in zip(self.variations, self.values(index), strict=True):
            nominal = each.parameter.of(nominal, value)
        return nominal


def random_cases(variations, count: int, seed: int) -> Cases:
    """``count`` cases at random. Errors: ``ProblemError``."""
    for name, value, least in (("count", count, 1), ("seed", seed, 0)):
        if isinstance(value, bool) or not isinstance(value, int) or not least <= value < 2**63:
            raise ProblemError(
                f"tolerance.{name}", f"is {shown(value)}; it must be a whole number from {least}"
            )
    return Cases(_varied(variations), count, seed)


def corners(variations) -> Cases:
    """All combinations of the ends of the bands, 2^k of them. Errors: ``ProblemError`` for too many."""
    variations = _varied(variations)
    if len(variations) > MOST_CORNERS:
        raise ProblemError(
            "tolerance.variations",
            f"are {len(variations)}, which have {2 ** len(variations):.3g} corners; at most {MOST_CORNERS} can be "
            "tried; draw cases at random instead",
        )
    return Cases(variations, 2 ** len(variations), None)


def _varied(variations):
    variations = tuple(variations)
    if not variations:
        raise ProblemError("tolerance.variations", "are empty; name what varies")
    return variations


def run(
    scene: Scene,
    cases: Cases,
    *,
    start: Solution | None = None,
    executor: Executor | None = None,
    watch: Callable[[str], None] | None = None,
) -> Iterator[Row]:
    """A row for each case, in order. ``start`` is the solution of ``scene``, found if None.

    ``executor`` is any of ``concurrent.futures``, or the like, as ``get_executor()`` of a Dask client; None: here. A
    caller that wants no more rows closes the iterator, and what is not begun yet is not solved. ``watch`` is that of
    ``find_equilibrium``, called where a case is solved, so with an executor it is sent there.
    """
    if start is None:
        start = find_equilibrium(scene, watch=watch)
    starts = range(0, cases.count, CHUNK)
    if executor is None:
        yield from (_row(scene, cases, start, index, watch) for index in range(cases.count))
        return
    chunks = ((scene, cases, start, a, min(a + CHUNK, cases.count), watch) for a in starts)
    futures = deque()
    try:
        for chunk in chunks:
            futures.append(executor.submit(solve_chunk, *chunk))
            if len(futures) >= AHEAD:
                yield from futures.popleft().result()
        while futures:
            yield from futures.popleft().result()
    finally:
        for future in futures:
            future.cancel()


def solve_chunk(scene, cases, start, first, last, watch=None) -> list[Row]:
    """Rows of the cases from ``first`` to before ``last``; what a worker does."""
    return [_row(scene, cases, start, index, watch) for index in range(first, last)]


def solution(
    scene: Scene, cases: Cases, index: int, start: Solution | None, watch=None
) -> Solution:
    """The shape of a case, as the worst one, to look at. Errors: ``ProblemError`` if it has no scene."""
    return find_equilibrium(cases.scene(scene, index), start=start, watch=watch)


def _row(scene, cases, start, index, watch) -> Row:
    begin = perf_counter()
    try:
        found, error = solution(scene, cases, index, start, watch), ""
    except ProblemError as wrong:
        found, error = None, f"{wrong}."
    return Row.of(cases.values(index), found, time=perf_counter() - begin, error=error)


@dataclass(frozen=True)
class Verdict:
    """What the rows of a tolerance study say."""

    count: int
    holding: int
    worst: int
    """number of the case that fails, or that holds with the least margin"""

    @property
    def share(self) -> float:
        """of the cases that hold"""
        return self.holding / self.count

    @property
    def between(self) -> tuple[float, float]:
        """Between what the share of all possible cables lies, with 95 % confidence, if the cases are random: Wilson,
        J. Am. Stat. Assoc. 22 (1927) 209."""
        n, p, z = self.count, self.share, 1.96
        middle = (p + z**2 / 2 / n) / (1 + z**2 / n)
        half = z / (1 + z**2 / n) * np.sqrt(p * (1 - p) / n + z**2 / 4 / n**2)
        return float(max(middle - half, 0.0)), float(min(middle + half, 1.0))

    @classmethod
    def of(cls, rows) -> "Verdict":
        """Errors: ``ValueError`` without rows."""
        rows = list(rows)
        worst = min(range(len(rows)), key=lambda i: _severity(rows[i]))
        return cls(len(rows), sum(row.holds for row in rows), worst)


def _severity(row):
    """Without an answer first, then what does not hold, then by what is left."""
    infinite = float("inf")
    margin = infinite if row.bend_radius_margin is None else row.bend_radius_margin
    clearance = infinite if row.smallest_clearance is None else row.smallest_clearance
    radius = infinite if row.smallest_bend_radius is None else row.smallest_bend_radius
    return row.length is not None, row.holds, min(margin, clearance), radius
