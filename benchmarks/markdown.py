# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables and numbers of the report."""

from collections import Counter


def table(heads, lines) -> str:
    lines = [heads, ["---"] * len(heads), *lines]
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in lines)


def dash(value, form="") -> str:
    return "–" if value is None else format(value, form)


def milliseconds(value) -> str:
    return "–" if value is None else f"{1e3 * value:.3g}"


def outcome(row) -> str:
    """How a row ended in words; an exception by its name."""
    if row.status == "TimeoutError":
        return "did not return"
    return row.status.replace("_", " ").lower() if row.status.isupper() else row.status


def ends(rows) -> str:
    counts = Counter(outcome(row) for row in rows).most_common()
    return ", ".join(f"{count} {name}" for name, count in counts)
