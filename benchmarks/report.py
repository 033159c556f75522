# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report of a run: tables of the stored rows, and sentences that quote them."""

from collections import Counter
from statistics import median

import numpy as np

from benchmarks import plot, stored
from benchmarks.cases import CASES, DRAG, TABLE_1
from benchmarks.left_out import LeftOut
from benchmarks.measure import Cell, Mesh, Race, Work

SHORT = (1e-4, 1e-6)
"""Tolerances of the short tables; all are in the rows."""


def write(facts: dict[str, str], uncertainty: float, seconds: float):
    """``docs/benchmarks/README.md`` from the stored rows. ``uncertainty`` is that of the exact shapes,
    relative to the length; ``seconds`` what the whole run took."""
    facts = facts | {"whole run": f"{seconds:.0f} s"}
    rows, meshes = stored.read(Work), stored.read(Mesh)
    sections = [
        "# Benchmarks\n\nWritten by `./run bench`; do not edit.",
        _table(("", ""), facts.items()),
        "Times are wall-clock times of one process; of repeats the least, because other work on the machine "
        "only ever adds time. *Cold* is a whole `find_equilibrium` from nothing but the scene, its solvers built; "
        f"*warm* the same after a drag step of {DRAG:.1%} of the length, from the solution before it. Errors are "
        "the largest distance of a node from its exact place, relative to the length of the cable; the exact "
        f"shapes, from an independent solver of the strong form, are known to {uncertainty:.0e}.",
        "Rows: [work.csv](work.csv), [race.csv](race.csv), [mesh.csv](mesh.csv), "
        "[left-out.csv](left-out.csv), [grid.csv](grid.csv); "
        "`benchmarks/measure.py` says what their columns mean.",
        "## Cases\n\n" + _table(("case", "what"), [(case.name, case.about) for case in CASES]),
        *_races(stored.read(Race)),
        *_times(rows),
        *_honesty(rows),
        *_orders(meshes),
        *_left_out(stored.read(LeftOut)),
        *_grid(stored.read(Cell)),
    ]
    text = "\n\n".join(sections) + "\n"
    (stored.FOLDER / "README.md").write_text(text, encoding="utf-8")


def _races(rows):
    yield "## fatrop against ipopt"
    heads = ("length", "scheme", "fatrop [ms]", "ipopt [ms]", "ratio", "ratio of whole solves")
    lines, sums = [], []
    for scheme in dict.fromkeys(row.scheme for row in rows):
        pairs = {
            row.case: {other.solver: other for other in rows if _same(row, other)}
            for row in rows
            if row.scheme == scheme
        }
        times = [
            [(pair[solver].in_solver, pair[solver].whole) for solver in ("fatrop", "ipopt")]
            for pair in pairs.values()
        ]
        sums.append((scheme, *_ratio(np.sum(times, axis=0))))
        lines += [(case, scheme, *_ratio(t)) for case, t in zip(pairs, times, strict=True)]
        lines.append(("**sum**", *sums[-1]))
    yield _table(heads, lines)
    ratios = " and ".join(f"{line[3]} ({line[0]})" for line in sums)
    yield (
        f"On {rows[0].elements} elements, cold, fatrop needs {ratios} of the time of ipopt, summed over the "
        f"{len(TABLE_1)} lengths of Table 1 ({_ends(rows)})."
    )


def _left_out(rows):
    yield "## What is left out"
    yield (
        "Times of a solve with and without a part of the model, and the distance between the two shapes: where the "
        "scene does not need the part, what the core saves by leaving it out; where it does, the error that would "
        "cost, which is why it stays in."
    )
    heads = ("part", "scene", "needed", "with [ms]", "without [ms]", "ratio", "error")
    yield _table(
        heads,
        [
            (
                row.part,
                row.scene,
                row.needed,
                f"{1e3 * row.with_it:.1f}",
                f"{1e3 * row.without:.1f}",
                f"{row.with_it / row.without:.2f}",
                f"{row.error:.1e}",
            )
            for row in rows
        ],
    )


def _same(row, other):
    return (row.case, row.scheme) == (other.case, other.scheme)


def _ratio(times):
    (fatrop, whole), (ipopt, other) = times
    return (
        f"{1e3 * fatrop:.1f}",
        f"{1e3 * ipopt:.1f}",
        f"{fatrop / ipopt:.2f}",
        f"{whole / other:.2f}",
    )


def _times(rows):
    yield "## Time for an accuracy\n\n![error against run time](work-precision.png)"
    heads = (
        "case",
        "tolerance",
        "scheme",
        "cold [ms]",
        "warm [ms]",
        "iterations",
        "warm",
        "elements",
    )
    chosen = [row for row in rows if row.solver == "fatrop" and row.tolerance in SHORT]
    yield "With fatrop:\n\n" + _table(
        (*heads, "true error", "estimate", "energy error", "status"),
        [
            (
                row.case,
                f"{row.tolerance:.0e}",
                row.scheme,
                _milliseconds(row.cold),
                _milliseconds(row.warm),
                _dash(row.iterations),
                _dash(row.warm_iterations),
                _dash(row.elements),
                *(_dash(value, ".1e") for value in (row.error, row.estimate, row.energy_error)),
                plot.outcome(row),
            )
            for row in chosen
        ],
    )
    names = [case.name for case in TABLE_1]
    for scheme in dict.fromkeys(row.scheme for row in chosen):
        own = [r for r in chosen if r.scheme == scheme and r.case in names]
        if any(row.cold is None or row.warm is None for row in own):
            yield f"Table 1 was not solved throughout with {scheme} elements; see the rows."
            continue
        loose, fine = (sum(r.cold for r in own if r.tolerance == each) for each in SHORT)
        drag = sum(r.warm for r in own if r.tolerance == SHORT[0])
        yield (
            f"Table 1 in sum with {scheme} elements: {1e3 * loose:.0f} ms cold at {SHORT[0]:.0e} and "
            f"{1e3 * fine:.0f} ms at {SHORT[1]:.0e}, a factor of {fine / loose:.1f}; a warm drag step at "
            f"{SHORT[0]:.0e} takes {drag / loose:.2f} of a cold solve, in {median(_warm(own)):g} iterations "
            "in the median."
        )


def _warm(rows):
    return [row.warm_iterations for row in rows if row.tolerance == SHORT[0]]


def _honesty(rows):
    solved = [row for row in rows if row.error is not None]
    within = sum(row.error <= row.tolerance for row in solved if row.status == "CONVERGED")
    converged = [row for row in rows if row.status == "CONVERGED"]
    yield "## Estimate and failures"
    yield (
        f"{len(rows)} rows: {_ends(rows)}. Of those that converged, {within} of {len(converged)} have a true error "
        "within the tolerance asked for."
    )
    bounded = sum(row.error <= row.estimate for row in solved)
    yield (
        f"The true error is at most the estimate in {bounded} of {len(solved)} rows, at most 1.1 times in "
        f"{sum(row.error <= 1.1 * row.estimate for row in solved)}; the median of estimate over true error is "
        f"{median(row.estimate / row.error for row in solved):.2f}."
    )
    several = Counter(case for case, _ in {(row.case, row.equilibrium) for row in solved})
    several = [case for case, count in several.items() if count > 1]
    yield (
        f"Rows of one case found different equilibria in: {', '.join(several)}."
        if several
        else "All rows of a case found the same equilibrium."
    )
    failed = [row for row in rows if row.status != "CONVERGED"]
    if failed:
        heads = (
            "case",
            "scheme",
            "solver",
            "tolerance",
            "status",
            "elements",
            "true error",
            "message",
        )
        yield _table(
            heads,
            [
                (r.case, r.scheme, r.solver, f"{r.tolerance:.0e}", plot.outcome(r))
                + (_dash(r.elements), _dash(r.error, ".1e"), r.message)
                for r in failed
            ],
        )


def _orders(rows):
    yield "## Order\n\n![error against elements](order.png)"
    lines = []
    for case, scheme in dict.fromkeys((row.case, row.scheme) for row in rows):
        own = [row for row in rows if (row.case, row.scheme) == (case, scheme)]
        finest = max((row for row in own if row.cold is not None), key=lambda row: row.elements)
        slope, _ = plot.order(own)
        lines.append(
            (case, scheme, f"{slope:.2f}", finest.elements, f"{finest.error:.1e}")
            + (_milliseconds(finest.cold), f"{finest.build:.1f}")
        )
    yield _table(
        ("case", "scheme", "order", "most elements", "true error", "cold [ms]", "building [s]"),
        lines,
    )
    yield (
        f"Orders are fitted to uniform meshes from {plot.FITTED} elements on, while the error is above "
        f"{plot.FLOOR:.0e} ({len(rows)} meshes: {_ends(rows)}). Building a solver happens once in a process for a "
        "number of elements: in the first case above, and the second finds it built."
    )


def _grid(rows):
    yield "## Extreme grid\n\n![extreme grid](grid.png)"
    solved = [row for row in rows if row.status == "CONVERGED"]
    slowest = max(rows, key=lambda row: row.seconds)
    yield (
        f"{len(rows)} cells: {_ends(rows)}. Of the converged ones, half took at most "
        f"{median(row.seconds for row in solved):.2f} s; the slowest cell of all took {slowest.seconds:.1f} s "
        f"(w L³/EI = {slowest.weight_ratio:g}, length {slowest.length_ratio:g} times the chord). The largest residual "
        f"of the independent balance is {max(row.balance_moment for row in solved):.1e} of the largest "
        f"moment, its median {median(row.balance_moment for row in solved):.0e}. A cell is run once; building solvers "
        "is not counted."
    )
    failed = [row for row in rows if row.status != "CONVERGED"]
    if failed:
        yield _table(
            ("w L³/EI", "length / chord", "status", "seconds", "message"),
            [
                (f"{r.weight_ratio:g}", f"{r.length_ratio:g}", plot.outcome(r))
                + (f"{r.seconds:.1f}", r.message)
                for r in failed
            ],
        )


def _ends(rows):
    counts = Counter(plot.outcome(row) for row in rows).most_common()
    return ", ".join(f"{count} {name}" for name, count in counts)


def _dash(value, form=""):
    return "–" if value is None else format(value, form)


def _milliseconds(value):
    return "–" if value is None else f"{1e3 * value:.0f}"


def _table(heads, lines):
    lines = [heads, ["---"] * len(heads), *lines]
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in lines)
