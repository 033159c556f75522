# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report on studies."""

from benchmarks.markdown import dash, milliseconds, table
from benchmarks.studies import ALONE, CASES, HERE, PATH, ROUNDS, TOLERANCE, Study


def section(rows: list[Study]):
    if not rows:
        return
    yield "## Studies"
    random = [row for row in rows if row.what == TOLERANCE]
    (alone,) = (row for row in random if row.way == HERE)
    heads = (
        "cases",
        "way",
        "workers",
        "seconds",
        "cases a second",
        "of one process",
        "solved",
        "rows that differ",
    )
    yield table(
        heads,
        [
            (row.values, row.way, row.workers, f"{row.seconds:.0f}")
            + (f"{1 / row.each:.1f}", f"{alone.each / row.each:.2f}", row.solved)
            + (dash(row.different),)
            for row in random
        ],
    )
    yield (
        f"Random cases of [tolerance.json](../tolerance.json), the same for all, in {ROUNDS} rounds in each of which "
        f"every way has its turn. One process solves the first {ALONE} of a round's {CASES}; "
        f"a case takes it {alone.each / alone.cold:.2f} of a cold solve, which is {milliseconds(alone.cold)} ms. "
        "*Rows that differ*: bit by bit from those of the line above, of as many as both have. Workers share the "
        "processors with the *other load* above, so they come as near to their number as processors are free."
    )
    for row in rows:
        if row.what == PATH:
            yield (
                f"A path of {row.values} values, Table 1 from 0.50 to 0.90 m, takes {row.seconds:.2f} s, "
                f"{row.seconds / row.cold:.1f} cold solves of {milliseconds(row.cold)} ms; "
                f"{row.solved} values are solved."
            )
