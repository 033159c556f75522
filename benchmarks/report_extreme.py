# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report on extreme scenes, and on estimates against true errors."""

from statistics import median

from benchmarks import stored
from benchmarks.markdown import dash, ends, milliseconds, outcome, table
from benchmarks.measure import Work
from benchmarks.outcomes import TIME_LIMIT, Outcome, failed

WORST = 60
"""Failures that get a row in the report; all are in the file."""


def section():
    rows = stored.read(Outcome)
    if not rows:
        return
    bad = [row for row in rows if failed(row)]
    yield "## Extreme scenes\n\n![how extreme scenes end, by family](extreme.png)"
    yield (
        f"{len(rows)} scenes: {ends(rows)}; {len(bad)} are neither a verified equilibrium to the tolerance of 1e-04 "
        "nor a named infeasibility. Each is solved once, two at a time, in processes that are ended if they do not "
        f"come back; the time limit is {TIME_LIMIT:g} s with the building of solvers. `benchmarks/extreme.py` says "
        "what the families are."
    )
    heads = (
        "family",
        "scenes",
        "converged",
        "infeasible",
        "failed",
        "median [ms]",
        "slowest [s]",
        "balance",
    )
    yield table(heads, [_family(name, own) for name, own in _families(rows)])
    if bad:
        yield table(
            ("family", "row", "column", "status", "seconds", "message"),
            [
                (r.family, r.row, r.column, outcome(r), dash(r.seconds, ".1f"), r.message)
                for r in bad[:WORST]
            ],
        )
    if len(bad) > WORST:
        yield f"And {len(bad) - WORST} more in [extreme.csv](extreme.csv)."


def _families(rows):
    for name in dict.fromkeys(row.family for row in rows):
        yield name, [row for row in rows if row.family == name]


def _family(name, own):
    done = [row for row in own if row.status == "CONVERGED"]
    balances = [max(row.balance_moment, row.balance_force) for row in done]
    return (
        name,
        len(own),
        len(done),
        sum(row.status == "INFEASIBLE" for row in own),
        sum(map(failed, own)),
        milliseconds(median(row.seconds for row in done) if done else None),
        dash(max((row.seconds for row in own if row.seconds is not None), default=None), ".1f"),
        f"{max(balances, default=0):.0e}",
    )


def estimates():
    """Text: the share of true errors within their estimates, and by how much estimates are too large."""
    groups = {"cases above": [(r.estimate, r.error) for r in stored.read(Work)]}
    for name, own in _families(stored.read(Outcome)):
        groups[name] = [(r.estimate, r.error) for r in own if not failed(r)]
    lines, everything = [], []
    for name, pairs in groups.items():
        known = [(a, b) for a, b in pairs if a and b]
        everything += known
        if known:
            lines.append((name, *_honest(known)))
    if not lines:
        return
    yield "## Estimate against truth"
    lines.append(("**all**", *_honest(everything)))
    yield table(
        ("scenes", "known", "true ≤ estimate", "true ≤ 1.1 estimate", "median of estimate / true"),
        lines,
    )
    yield (
        "Asked for: true at most the estimate in 95 %, and a median of at most 20. True errors are those of the strong "
        "form, which knows no supports and no obstacles, and of every second extreme and every tenth random scene; "
        "where it leads to another equilibrium or does not converge in time, none is known."
    )


def _honest(pairs):
    within = sum(true <= estimate for estimate, true in pairs)
    nearly = sum(true <= 1.1 * estimate for estimate, true in pairs)
    ratio = median(estimate / true for estimate, true in pairs)
    return len(pairs), f"{within / len(pairs):.1%}", f"{nearly / len(pairs):.1%}", f"{ratio:.2f}"
