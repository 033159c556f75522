# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report on cables that meet obstacles."""

from statistics import median

from benchmarks.among import ANOTHER, FINER, HELD, LEFT_OUT, LIMITED, SAMPLES, Among
from benchmarks.markdown import dash, ends, milliseconds, outcome, table


def section(rows: list[Among]):
    if not rows:
        return
    deep = [row for row in rows if _converged(row) and row.depth > LEFT_OUT]
    bad = [row for row in rows if not _converged(row)]
    families = {name: [row for row in rows if row.family == name] for name in _names(rows)}
    yield "## Contact"
    yield (
        f"{len(rows)} random scenes: {ends(rows)}. *Plates*: a cable through rings in 1 to 3 triangulated plates with "
        "round holes; *obstacles*: one whose free shape passes through 1 or 2 boxes, spheres, cylinders or thin "
        f"plates. Each is solved once, cold, one at a time, to {LIMITED.tolerance:.0e}; the time limit is "
        f"{LIMITED.time_limit:g} s. `benchmarks/among.py` draws them."
    )
    heads = ("family", "scenes", "converged", "told", "failed", "touching", "median [ms]")
    yield table(
        (*heads, "slowest [s]", "deepest [radii]"),
        [_family(name, own) for name, own in families.items()],
    )
    yield (
        "*Told*: there is a shape, and the answer says that it is less accurate than asked for, or that it enters the "
        "rim of a ring. *Median*: of the converged. *Deepest*: how far the surface of a converged cable really is in "
        f"an obstacle, found from the nodes alone at {SAMPLES} places a radius, nearer than {HELD:g} radii to an end "
        "left out; less than 0 where it keeps clear. The solver leaves 0.01 between nodes, and what lies between its "
        f"samples, 1/128; deeper than that: {', '.join(f'{r.family} {r.seed}' for r in deep) or 'none'}."
    )
    if bad:
        yield table(
            ("family", "seed", "status", "seconds", "message"),
            [(r.family, r.seed, _status(r), dash(r.seconds, ".1f"), r.message) for r in bad],
        )
    yield from _truth(families)


def _names(rows):
    return dict.fromkeys(row.family for row in rows)


def _converged(row):
    return row.status == "CONVERGED" and not row.rims


def _told(row):
    return row.rims or row.status == "INACCURATE"


def _status(row):
    return f"{outcome(row)}, in a rim" if row.rims else outcome(row)


def _family(name, own):
    done = [row for row in own if _converged(row)]
    told = sum(map(_told, own))
    return (
        name,
        len(own),
        len(done),
        told,
        len(own) - len(done) - told,
        sum(bool(row.contacts) for row in own),
        milliseconds(median(row.seconds for row in done) if done else None),
        dash(max(row.seconds for row in own), ".1f"),
        dash(max((row.depth for row in done), default=None), ".3f"),
    )


def _truth(families):
    """Text: estimates against true errors, and of how many these are not known."""
    lines = [(name, *_honest(own)) for name, own in families.items()]
    yield table(
        (
            "family",
            "asked",
            "known",
            "true ≤ estimate + that of the finer",
            "median of estimate / true",
            "another equilibrium",
            "not solved finer",
        ),
        lines,
    )
    yield (
        f"True errors of every second scene, if it converged: against the same cable solved from there to {FINER:g} of "
        "the tolerance, so known to within the estimate of the finer answer. Unknown where that is more than "
        f"{ANOTHER:g} of the length away, which is another equilibrium, or did not converge."
    )


def _honest(own):
    asked = [row for row in own if row.finer]
    known = [row for row in asked if row.error is not None]
    within = sum(row.error <= row.estimate + row.finer_estimate for row in known)
    ratios = [row.estimate / row.error for row in known if row.error]
    return (
        len(asked),
        len(known),
        f"{within / len(known):.1%}" if known else "–",
        dash(median(ratios) if ratios else None, ".2f"),
        sum(row.finer == "CONVERGED" and row.error is None for row in asked),
        sum(row.finer != "CONVERGED" for row in asked),
    )
