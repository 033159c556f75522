# SPDX-License-Identifier: LGPL-2.1-or-later
"""Speed as ratios: what was asked of this project and what the stored rows say."""

from statistics import median

from benchmarks import stored
from benchmarks.cases import TABLE_1
from benchmarks.markdown import dash, milliseconds, outcome, table
from benchmarks.measure import Race, Work
from benchmarks.peers.asked import DYNAMIC, GIVEN, MODULES, OWN, PAPER, SEED, SOLVE_BVP, STATIC
from benchmarks.peers.parent import OURS, Peer
from benchmarks.scaling import Drag, Scaling
from benchmarks.studies import PATH, Study

ERROR = 1e-4
"""Relative position error at which peers are compared."""
NAMES = tuple(case.name for case in TABLE_1)


def quickest(rows: list[Peer], problem: str, peer: str, error: float, start="cold"):
    """The quickest answer of a peer that is at least so good; None if none is."""
    good = [
        r
        for r in rows
        if (r.problem, r.peer, r.start) == (problem, peer, start)
        and r.error is not None
        and r.error <= error
    ]
    return min(good, key=lambda row: row.relative, default=None)


def best(rows: list[Peer], problem: str, peer: str, start="cold"):
    """The answer of a peer with the least error; None if it has none."""
    own = [r for r in rows if (r.problem, r.peer, r.start) == (problem, peer, start)]
    return min((r for r in own if r.error is not None), key=lambda row: row.error, default=None)


def against(rows: list[Peer], theirs: Peer | None, error: float | None = None) -> float | None:
    """Their time over ours at an ``error``, by default that of theirs, cold."""
    ours = theirs and quickest(rows, theirs.problem, OURS, theirs.error if error is None else error)
    return theirs.relative / ours.relative if ours else None


def _each(rows, theirs: list[Peer | None]) -> str:
    """Their times over ours, both quickest at ``ERROR`` or better; and at the errors that they reach with that, which
    may be far less."""
    said, aside = (
        ", ".join(dash(against(rows, each, error), ".1f") for each in theirs)
        for error in (ERROR, None)
    )
    return said if said == aside else f"{said}; at the errors that it reaches with that {aside}"


def asked_and_measured() -> list[tuple[str, str, str]]:
    """(what, asked, measured)"""
    return [*_peers(stored.read(Peer)), *_ourselves()]


def _peers(rows):
    if not rows:
        return
    for variant, start in ((OWN, "ours"), (OWN, "cold"), (GIVEN, "ours"), (GIVEN, "cold")):
        own = [r for r in rows if r.variant == variant or r.peer == OURS]
        theirs = [quickest(own, name, SOLVE_BVP, ERROR, start) for name in NAMES]
        where = "the start that it likes best" if start == "cold" else "our own start"
        yield (
            f"SciPy's `solve_bvp` at {ERROR:.0e}, {variant}, from {where}, over ours, each length of Table 1",
            "10 where it converges, at least 4",
            _each(rows, theirs),
        )
    theirs = [quickest(rows, name, SEED, ERROR) for name in NAMES]
    literal = [r for r in rows if r.peer == SEED and r.variant == "three points"]
    errors = [r.error for r in literal if r.problem == PAPER and r.error is not None]
    yield (
        f"seed paper's formulation with ipopt at {ERROR:.0e}, cold, over ours, each length of Table 1",
        "5",
        _each(rows, theirs)
        + " with differences over two points; over three points it does not get there "
        + (f"(least error {min(errors):.0e})" if errors else ""),
    )
    for peers, asked, at in ((STATIC, 50, "the same error"), (DYNAMIC, 1000, "its best error")):
        for peer in peers:
            theirs = best(rows, PAPER, peer)
            factor = against(rows, theirs)
            got = "no answer" if theirs is None else f"{dash(factor, '.0f')} at {theirs.error:.1e}"
            near = best(rows, PAPER, peer, "answer")
            if near is not None:
                ratio = dash(against(rows, near), ".1f")
                got += f"; started from our answer {ratio} at {near.error:.1e}"
            yield f"{peer} over ours at {at}, {PAPER}, cold", str(asked), got


def _ourselves():
    rows = [r for r in stored.read(Work) if r.case in NAMES and r.solver == "fatrop"]
    own = {(r.case, r.tolerance): r for r in rows if r.scheme == "magnus"}
    if own:
        loose, fine = (sum(own[name, t].cold for name in NAMES) for t in (1e-4, 1e-6))
        yield "time at 1e-06 over time at 1e-04, Table 1", "at most 4", f"{fine / loose:.1f}"
    drags = stored.read(Drag)
    if drags:
        share = sum(d.warm for d in drags) / sum(d.cold for d in drags)
        yield "warm drag step over cold solve, Table 1", "at most 0.25", f"{share:.2f}"
        steps = median(d.iterations for d in drags)
        yield "iterations of a warm drag step, median", "under 3", f"{steps:g}"
    for row in stored.read(Study):
        if row.what == PATH:
            ratio = f"{row.seconds / row.cold:.1f}"
            yield f"study of {row.values} values over cold solve, Table 1", "at most 25", ratio
    for scheme in ("magnus", "helix"):
        times = {r.elements: r.cold for r in stored.read(Scaling) if r.scheme == scheme}
        if times:
            ratio = times[1600] / times[100]
            yield f"1600 over 100 {scheme} elements", "at most 20", f"{ratio:.1f}"
    by_weight = {
        r.case: r.cold
        for r in stored.read(Work)
        if (r.scheme, r.solver, r.tolerance) == ("magnus", "fatrop", 1e-4)
    }
    if by_weight:
        ratio = by_weight["very heavy"] / by_weight["light"]
        yield "w L³/EI = 10⁵ over w L³/EI = 1, at 1e-04", "at most 15", f"{ratio:.1f}"
    races = stored.read(Race)
    for scheme in dict.fromkeys(r.scheme for r in races):
        sums = {
            solver: sum(r.in_solver for r in races if (r.scheme, r.solver) == (scheme, solver))
            for solver in ("fatrop", "ipopt")
        }
        yield (
            f"fatrop over ipopt in the solver, {races[0].elements} {scheme} elements, cold",
            "under 0.5",
            f"{sums['fatrop'] / sums['ipopt']:.2f}",
        )


def peers_section():
    """Text of the report on peers."""
    rows = stored.read(Peer)
    if not rows:
        return
    yield "## Peers\n\n![error against run time, with peers](peers.png)"
    yield (
        "Each in a process of its own, with the error that it reaches against the exact shape of the rod that it "
        "solves: Exudyn's and PyElastica's stretches and shears, OpenSeesPy's stretches. *Cold* is from a smooth curve "
        "of the right length, or for a beam code straight and led to the task; *answer* is from our solution, which "
        "somebody has to have. The time is that of the solve alone, without importing, compiling and building; ours "
        "holds the error estimate, refinement, stability and the check, which no peer has. *Ratio*: its time over "
        "ours, cold, at its error, both in units of a solve of 0.55 m just before and after. "
        "How each is set up: `benchmarks/peers/`."
    )
    heads = (
        "problem",
        "peer",
        "start",
        "way",
        "elements",
        "steps",
        "unknowns",
        "error",
        "ms",
        "ratio",
        "status",
    )
    yield table(
        heads,
        [
            (
                r.problem,
                f"{r.peer} {r.version}",
                r.start,
                r.variant + (f", tolerance {r.tolerance:.0e}" if r.tolerance else ""),
                r.elements,
                r.steps if r.steps > 1 else "–",
                dash(r.unknowns),
                dash(r.error, ".1e"),
                milliseconds(r.seconds),
                dash(against(rows, r), ".1f") if r.error is not None else "–",
                outcome(r) if r.status == "CONVERGED" else f"{outcome(r)}: {r.message}",
            )
            for r in rows
            if r.peer in MODULES and r.problem in (PAPER, "cantilever")
        ],
    )
