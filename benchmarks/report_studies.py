# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report on studies."""

from benchmarks.markdown import dash, milliseconds, table
from benchmarks.studies import HERE, PATH, TOLERANCE, Study


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
        "other load",
        "seconds",
        "cases a second",
        "of one process",
        "solved",
        "rows that differ",
    )
    yield table(
        heads,
        [
            (row.values, row.way, row.workers, f"{row.load:.1f}", f"{row.seconds:.0f}")
            + (f"{1 / row.each:.1f}", f"{alone.each / row.each:.2f}", row.solved)
            + (dash(row.different),)
            for row in random
        ],
    )
    yield (
        f"Random cases of [tolerance.json](../tolerance.json), the same for all. One process solves the first "
        f"{alone.values} of them, and its throughput is that of these; a case takes it {alone.each / alone.cold:.2f} "
        f"of a cold solve, which is {milliseconds(alone.cold)} ms. Seconds hold the start of the workers. *Rows that "
        "differ*: bit by bit from those of the line above, as far as both have them."
    )
    for row in rows:
        if row.what == PATH:
            yield (
                f"A path of {row.values} values, Table 1 from 0.50 to 0.90 m, takes {row.seconds:.2f} s, "
                f"{row.seconds / row.cold:.1f} cold solves of {milliseconds(row.cold)} ms; "
                f"{row.solved} values are solved."
            )
