# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of the extreme scenes: how each ended, by family."""

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
from matplotlib.colors import LinearSegmentedColormap, LogNorm
from matplotlib.patches import Patch

from benchmarks import stored
from benchmarks.outcomes import Outcome, failed

FAILED, INFEASIBLE = "#b00020", "#8fa3b5"
SECONDS = LinearSegmentedColormap.from_list("seconds", ("#eef7f0", "#8ecfae", "#2c8c86"))
NORM = LogNorm(0.03, 10)
DOTS_PER_INCH = 100
PANELS_A_LINE = 4


def families(rows: list[Outcome]):
    """A panel for each family, a cell for each scene."""
    if not rows:
        return
    names = list(dict.fromkeys(row.family for row in rows))
    lines = -(-len(names) // PANELS_A_LINE)
    figure, panels = plt.subplots(lines, PANELS_A_LINE, figsize=(16, 4.2 * lines), squeeze=False)
    for axes in panels.flat:
        axes.axis("off")
    for name, axes in zip(names, panels.flat, strict=False):
        axes.axis("on")
        _family(axes, name, [row for row in rows if row.family == name])
    legend = [
        Patch(color=SECONDS(0.5), label="converged (the darker, the longer: 0.03 to 10 s)"),
        Patch(color=INFEASIBLE, label="named infeasible"),
        Patch(color=FAILED, label="failed"),
    ]
    figure.legend(handles=legend, loc="lower center", ncols=3, frameon=False)
    figure.tight_layout(rect=(0, 0.04, 1, 1))
    save(figure, "extreme.png")


def _family(axes, name, rows):
    random = name == "random"
    down = list(dict.fromkeys(row.row for row in rows))
    across = {line: [] for line in down}
    columns = list(dict.fromkeys(row.column for row in rows))
    for row in rows:
        y = down.index(row.row)
        # Random scenes have no two in a column: they fill their lines.
        x = len(across[row.row]) if random else columns.index(row.column)
        across[row.row].append(row)
        colour = SECONDS(NORM(min(max(row.seconds, NORM.vmin), NORM.vmax)))
        if row.status != "CONVERGED":
            colour = FAILED if failed(row) else INFEASIBLE
        axes.add_patch(plt.Rectangle((x, y), 1, 1, facecolor=colour, edgecolor="white", lw=0.8))
    width = max(map(len, across.values())) if random else len(columns)
    axes.set_xlim(0, width)
    axes.set_ylim(len(down), 0)
    bad = sum(map(failed, rows))
    axes.set_title(f"{name}: {bad} of {len(rows)} failed")
    axes.grid(visible=False)
    axes.tick_params(length=0, labelsize=6)
    axes.spines[:].set_visible(False)
    axes.set_xticks([] if random else [k + 0.5 for k in range(width)])
    axes.set_yticks([] if random else [k + 0.5 for k in range(len(down))])
    if not random:
        axes.set_xticklabels(columns, rotation=90)
        axes.set_yticklabels(down)


def save(figure, name):
    figure.savefig(stored.FOLDER / name, dpi=DOTS_PER_INCH)
    plt.close(figure)
