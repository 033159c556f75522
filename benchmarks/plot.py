# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pictures, from the stored rows and nothing else: `python -m benchmarks.plot` draws them anew."""

import matplotlib
import numpy as np

matplotlib.use("Agg")

import matplotlib.pyplot as plt
from matplotlib.colors import LinearSegmentedColormap, LogNorm
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from benchmarks import stored
from benchmarks.measure import Cell, Mesh, Work

COLOURS = {"magnus": "#1f6fb4", "helix": "#d9541e"}
LINES = {"fatrop": "-", "ipopt": (0, (4, 2))}
FAILED, INFEASIBLE, GREY = "#b00020", "#8fa3b5", "0.35"
SECONDS = LinearSegmentedColormap.from_list("seconds", ("#eef7f0", "#8ecfae", "#2c8c86"))
DOTS_PER_INCH = 100

FITTED = 16
"""Elements from which the order is fitted: coarser meshes are not yet in its range."""
FLOOR = 2e-8
"""Error below which a row is left out of the fit: the solvers stop at 1e-9 of their own residual, and what
that leaves of position is up to ten times as much."""

plt.rcParams.update(
    {
        "font.size": 9,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.grid": True,
        "axes.axisbelow": True,
        "grid.color": "#dde3e8",
        "lines.markersize": 5,
    }
)


def main():
    work_precision(stored.read(Work))
    orders(stored.read(Mesh))
    grid(stored.read(Cell))


def order(rows: list[Mesh]) -> tuple[float, float]:
    """(order, log of the factor) of error = factor · elements^−order, by least squares of logarithms."""
    fitted = [(r.elements, r.error) for r in rows if _fits(r)]
    elements, errors = np.log(fitted).T
    slope, factor = np.polyfit(elements, errors, 1)
    return -slope, factor


def _fits(row):
    return row.error is not None and row.elements >= FITTED and row.error > FLOOR


def work_precision(rows: list[Work]):
    """True error against seconds: a panel for each case, a line for each scheme and solver."""
    names = list(dict.fromkeys(row.case for row in rows))
    figure, panels = plt.subplots(
        2, -(-len(names) // 2), figsize=(13.5, 6.4), sharex=True, sharey=True, squeeze=False
    )
    for name, axes in zip(names, panels.flat, strict=False):
        for scheme, colour in COLOURS.items():
            for solver, line in LINES.items():
                own = [r for r in rows if (r.case, r.scheme, r.solver) == (name, scheme, solver)]
                _line(axes, [r for r in own if r.error and r.cold], colour, line)
        axes.set(xscale="log", yscale="log", title=name)
    for axes in panels[-1]:
        axes.set_xlabel("seconds, cold, solvers built")
    for axes in panels[:, 0]:
        axes.set_ylabel("true error / length")
    figure.suptitle("Error against run time at tolerances 1e-3, 1e-4, 1e-5, 1e-6", fontsize=12)
    legend = [
        Line2D(
            [], [], color=colour, ls=line, marker="o", mfc=_fill(colour, line), label=f"{a}, {b}"
        )
        for a, colour in COLOURS.items()
        for b, line in LINES.items()
    ]
    legend.append(Line2D([], [], color=GREY, marker="x", ls="", label="not converged"))
    figure.legend(handles=legend, loc="lower center", ncols=5, frameon=False)
    figure.tight_layout(rect=(0, 0.05, 1, 1))
    _save(figure, "work-precision.png")


def _line(axes, rows, colour, line):
    seconds, errors = [r.cold for r in rows], [r.error for r in rows]
    axes.plot(seconds, errors, color=colour, ls=line, marker="o", mfc=_fill(colour, line))
    wrong = [r for r in rows if r.status != "CONVERGED"]
    axes.plot([r.cold for r in wrong], [r.error for r in wrong], "x", color=GREY, ms=10, zorder=5)


def _fill(colour, line):
    return colour if line == "-" else "white"


def orders(rows: list[Mesh]):
    """True error against elements with the fitted order, and seconds against elements."""
    names = list(dict.fromkeys(row.case for row in rows))
    figure, panels = plt.subplots(1, len(names) + 1, figsize=(12.5, 4.3), squeeze=False)
    for name, axes in zip(names, panels[0], strict=False):
        for scheme, colour in COLOURS.items():
            own = [r for r in rows if (r.case, r.scheme) == (name, scheme) and r.error]
            elements = np.array([r.elements for r in own if _fits(r)])
            slope, factor = order(own)
            fit = np.exp(factor) * elements**-slope
            axes.plot(elements, fit, color=colour, label=f"{scheme}, order {slope:.2f}")
            axes.plot([r.elements for r in own], [r.error for r in own], "o", color=colour)
        axes.set(title=name, ylabel="true error / length")
        axes.legend(frameon=False)
    axes = panels[0, -1]
    for scheme, colour in COLOURS.items():
        own = [r for r in rows if (r.case, r.scheme) == (names[0], scheme) and r.cold]
        axes.plot([r.elements for r in own], [r.cold for r in own], "o-", color=colour)
        axes.plot(
            [r.elements for r in own], [r.build for r in own], "s:", color=colour, mfc="white"
        )
    axes.set(title=f"{names[0]}, fatrop", ylabel="seconds")
    legend = [
        Line2D([], [], color=GREY, marker="o", label="cold solve, solver built"),
        Line2D([], [], color=GREY, marker="s", mfc="white", ls=":", label="building the solver"),
    ]
    axes.legend(handles=legend, frameon=False)
    for axes in panels[0]:
        axes.set(xscale="log", yscale="log", xlabel="elements of a uniform mesh")
        meshes = sorted({row.elements for row in rows})
        axes.set_xticks(meshes, meshes)
        axes.minorticks_off()
    figure.tight_layout()
    _save(figure, "order.png")


def grid(rows: list[Cell]):
    """How every cell of the extreme grid ended, and the seconds it took."""
    columns = sorted({row.weight_ratio for row in rows})
    lines = sorted({row.length_ratio for row in rows})
    figure, axes = plt.subplots(figsize=(10.4, 6.6))
    norm = LogNorm(0.03, 10)
    for row in rows:
        x, y = columns.index(row.weight_ratio), lines.index(row.length_ratio)
        failed = row.status not in ("CONVERGED", "INFEASIBLE")
        colour = SECONDS(norm(max(row.seconds, norm.vmin)))
        if row.status != "CONVERGED":
            colour = FAILED if failed else INFEASIBLE
        axes.add_patch(plt.Rectangle((x, y), 1, 1, facecolor=colour, edgecolor="white", lw=2))
        detail = outcome(row) if row.status != "CONVERGED" else f"{row.elements} elements"
        ink = "white" if failed else "0.1"
        axes.text(x + 0.5, y + 0.6, f"{row.seconds:.2g} s", ha="center", color=ink, fontsize=10)
        axes.text(x + 0.5, y + 0.25, detail, ha="center", color=ink, fontsize=7)
    axes.set_xlim(0, len(columns))
    axes.set_ylim(0, len(lines))
    axes.set_xticks(np.arange(len(columns)) + 0.5, [_power(value) for value in columns])
    axes.set_yticks(np.arange(len(lines)) + 0.5, [f"{value:g}" for value in lines])
    axes.set(xlabel="weight against bending, w L³/EI", ylabel="length / chord")
    axes.tick_params(length=0)
    axes.spines[:].set_visible(False)
    axes.grid(visible=False)
    axes.set_title(
        "Clamped, slightly tilted ends: how the search ended, and after how long", pad=12
    )
    scale = figure.colorbar(
        plt.cm.ScalarMappable(norm, SECONDS), ax=axes, label="seconds, converged", shrink=0.6
    )
    scale.outline.set_visible(False)
    legend = [
        Patch(color=SECONDS(0.5), label="converged"),
        Patch(color=INFEASIBLE, label="named infeasible"),
        Patch(color=FAILED, label="failed"),
    ]
    figure.legend(handles=legend, loc="lower right", frameon=False)
    figure.tight_layout()
    _save(figure, "grid.png")


def outcome(row) -> str:
    """How a row ended in words; an exception by its name."""
    if row.status == "TimeoutError":
        return "did not return"
    return row.status.replace("_", " ").lower() if row.status.isupper() else row.status


def _power(value):
    exponent = int(np.log10(value)) if value else 0
    return f"{value:g}" if exponent < 2 else f"$10^{exponent}$"


def _save(figure, name):
    figure.savefig(stored.FOLDER / name, dpi=DOTS_PER_INCH)
    plt.close(figure)


if __name__ == "__main__":
    main()
