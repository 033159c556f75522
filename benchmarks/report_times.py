# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report on when and where it was run, on many elements, on drags and on where the time goes."""

from benchmarks import profile_solve
from benchmarks.cases import DRAG
from benchmarks.markdown import dash, milliseconds, outcome, table


def runs(rows):
    if not rows:
        return
    heads = ("part", "commit", "date", "other load", "seconds", "exact to")
    yield table(
        heads,
        [
            (r.part, r.commit, r.date, r.load, f"{r.seconds:.0f}")
            + (f"{r.uncertainty:.0e}" if r.uncertainty else "–",)
            for r in rows
        ],
    )
    with_what = {
        f"{r.cpu}; Python {r.python}, NumPy {r.numpy}, SciPy {r.scipy}, CasADi {r.casadi}"
        for r in rows
    }
    total = sum(r.seconds for r in rows)
    yield (
        f"On {' and '.join(sorted(with_what))}. All parts took {total:.0f} s; `./run bench PART` runs one alone. "
        "*Other load*: processes of others at its start."
    )


def scaling(rows):
    if not rows:
        return
    yield "## Many elements"
    heads = (
        "scheme",
        "elements",
        "unknowns",
        "cold [ms]",
        "in the solver [ms]",
        "iterations",
        "building [s]",
        "status",
    )
    yield table(
        heads,
        [
            (r.scheme, r.elements, r.unknowns, milliseconds(r.cold), milliseconds(r.in_solver))
            + (dash(r.iterations), f"{r.build:.1f}", outcome(r))
            for r in rows
        ],
    )
    yield "Table 1, 0.73 m, uniform meshes, cold.\n\n![seconds against elements](scaling.png)"


def drags(rows):
    if not rows:
        return
    yield "## A drag"
    heads = (
        "case",
        "steps",
        "converged",
        "cold [ms]",
        "warm [ms]",
        "ratio",
        "slowest [ms]",
        "iterations",
        "most",
    )
    yield table(
        heads,
        [
            (r.case, r.steps, r.kept, milliseconds(r.cold), milliseconds(r.warm))
            + (
                f"{r.warm / r.cold:.2f}",
                milliseconds(r.slowest),
                f"{r.iterations:g}",
                r.most_iterations,
            )
            for r in rows
        ],
    )
    yield (
        f"The end is led round a circle in steps of {DRAG:.1%} of the length, each solved from the one before and "
        "cold; medians, every step once."
    )


def profile(rows):
    if not rows:
        return
    yield "## Where the time goes\n\n" + profile_solve.table(rows)
    yield "The last row is how far a solve is from the time that fatrop itself needs for this program."
