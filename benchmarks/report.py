# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report of a run: tables of the stored rows, and sentences that quote them."""

from collections import Counter
from statistics import median

import numpy as np

from benchmarks import (
    plot,
    ratios,
    report_contact,
    report_extreme,
    report_studies,
    report_times,
    stored,
)
from benchmarks.among import Among
from benchmarks.cases import CASES, DRAG, TABLE_1
from benchmarks.left_out import LeftOut
from benchmarks.markdown import dash, ends, milliseconds, outcome, table
from benchmarks.measure import Mesh, Race, Work
from benchmarks.profile_solve import Part
from benchmarks.runs import Run
from benchmarks.scaling import Drag, Scaling
from benchmarks.studies import Study

SHORT = (1e-4, 1e-6)
"""Tolerances of the short tables; all are in the rows."""


def write():
    """``docs/benchmarks/README.md`` from the stored rows."""
    sections = [
        "# Benchmarks\n\nWritten by `./run bench`; do not edit.",
        *report_times.runs(stored.read(Run)),
        "Times are wall-clock times of one process; of repeats the least, because other work on the machine "
        "only ever adds time. *Cold* is a whole `find_equilibrium` from nothing but the scene, its solvers built; "
        f"*warm* the same after a drag step of {DRAG:.1%} of the length, from the solution before it. Errors are "
        "the largest distance of a node from its exact place, relative to the length of the cable.",
        "Rows: "
        + ", ".join(f"[{name}]({name})" for name in stored.FILES.values())
        + "; the classes in `benchmarks/` that they are rows of say what their columns mean.",
        "## Asked and measured\n\n"
        + table(("ratio of times in one run", "asked", "measured"), ratios.asked_and_measured()),
        "## Cases\n\n" + table(("case", "what"), [(case.name, case.about) for case in CASES]),
        *_races(stored.read(Race)),
        *ratios.peers_section(),
        *_times(stored.read(Work)),
        *_failures(stored.read(Work)),
        *report_extreme.estimates(),
        *_orders(stored.read(Mesh)),
        *report_times.scaling(stored.read(Scaling)),
        *report_times.drags(stored.read(Drag)),
        *report_times.profile(stored.read(Part)),
        *_left_out(stored.read(LeftOut)),
        *report_studies.section(stored.read(Study)),
        *report_extreme.section(),
        *report_contact.section(stored.read(Among)),
    ]
    text = "\n\n".join(sections) + "\n"
    (stored.FOLDER / "README.md").write_text(text, encoding="utf-8")


def _races(rows):
    if not rows:
        return
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
    yield table(heads, lines)
    ratios = " and ".join(f"{line[3]} ({line[0]})" for line in sums)
    yield (
        f"On {rows[0].elements} elements, cold, fatrop needs {ratios} of the time of ipopt, summed over the "
        f"{len(TABLE_1)} lengths of Table 1 ({ends(rows)})."
    )


def _left_out(rows):
    if not rows:
        return
    yield "## What is left out"
    yield (
        "Times of a solve with and without a part of the model, and the distance between the two shapes: where the "
        "scene does not need the part, what the core saves by leaving it out; where it does, the error that would "
        "cost, which is why it stays in."
    )
    heads = ("part", "scene", "needed", "with [ms]", "without [ms]", "ratio", "error")
    yield table(
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
    if not rows:
        return
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
    yield "With fatrop:\n\n" + table(
        (*heads, "true error", "estimate", "energy error", "status"),
        [
            (
                row.case,
                f"{row.tolerance:.0e}",
                row.scheme,
                milliseconds(row.cold),
                milliseconds(row.warm),
                dash(row.iterations),
                dash(row.warm_iterations),
                dash(row.elements),
                *(dash(value, ".1e") for value in (row.error, row.estimate, row.energy_error)),
                outcome(row),
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


def _failures(rows):
    if not rows:
        return
    solved = [row for row in rows if row.error is not None]
    within = sum(row.error <= row.tolerance for row in solved if row.status == "CONVERGED")
    converged = [row for row in rows if row.status == "CONVERGED"]
    yield "## Failures"
    yield (
        f"{len(rows)} rows: {ends(rows)}. Of those that converged, {within} of {len(converged)} have a true error "
        "within the tolerance asked for."
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
        yield table(
            heads,
            [
                (r.case, r.scheme, r.solver, f"{r.tolerance:.0e}", outcome(r))
                + (dash(r.elements), dash(r.error, ".1e"), r.message)
                for r in failed
            ],
        )


def _orders(rows):
    if not rows:
        return
    yield "## Order\n\n![error against unknowns](order.png)"
    lines = []
    for case, scheme in dict.fromkeys((row.case, row.scheme) for row in rows):
        own = [row for row in rows if (row.case, row.scheme) == (case, scheme)]
        finest = max((row for row in own if row.cold is not None), key=lambda row: row.elements)
        slope, _ = plot.order(own)
        lines.append(
            (case, scheme, f"{slope:.2f}", finest.elements, f"{finest.error:.1e}")
            + (milliseconds(finest.cold), f"{finest.build:.1f}")
        )
    yield table(
        ("case", "scheme", "order", "most elements", "true error", "cold [ms]", "building [s]"),
        lines,
    )
    yield (
        f"Orders are fitted to uniform meshes from {plot.FITTED} elements on, while the error is above "
        f"{plot.FLOOR:.0e} ({len(rows)} meshes: {ends(rows)}). Building a solver happens once in a process for a "
        "number of elements: in the first case above, and the second finds it built."
    )
