# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pictures, from the stored rows and nothing else: `python -m benchmarks.plot` draws them anew."""

import matplotlib
import numpy as np

matplotlib.use("Agg")

import matplotlib.pyplot as plt
from matplotlib.lines import Line2D

from benchmarks import plot_extreme, stored
from benchmarks.measure import Mesh, Work
from benchmarks.outcomes import Outcome
from benchmarks.peers.asked import ELASTICA, EXUDYN, MUJOCO, OPENSEES, PAPER, SEED, SOLVE_BVP
from benchmarks.peers.parent import OURS, Peer
from benchmarks.scaling import Scaling

COLOURS = {"magnus": "#1f6fb4", "helix": "#d9541e"}
LINES = {"fatrop": "-", "ipopt": (0, (4, 2))}
GREY = "0.35"
PEERS = {
    OURS: ("#1f6fb4", "o"),
    SOLVE_BVP: ("#2c8c86", "s"),
    SEED: ("#7a5195", "D"),
    EXUDYN: ("#d9541e", "^"),
    OPENSEES: ("#e0a100", "v"),
    ELASTICA: ("#b00020", "P"),
    MUJOCO: ("#5c6b77", "X"),
}

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
    peers(stored.read(Peer))
    orders(stored.read(Mesh))
    scaling(stored.read(Scaling))
    plot_extreme.families(stored.read(Outcome))


def order(rows: list[Mesh]) -> tuple[float, float]:
    """(order, log of the factor) of error = factor · unknowns^−order, by least squares of logarithms."""
    fitted = [(r.unknowns, r.error) for r in rows if _fits(r)]
    unknowns, errors = np.log(fitted).T
    slope, factor = np.polyfit(unknowns, errors, 1)
    return -slope, factor


def _fits(row):
    return row.error is not None and row.elements >= FITTED and row.error > FLOOR


def work_precision(rows: list[Work]):
    """True error against seconds: a panel for each case, a line for each scheme and solver."""
    if not rows:
        return
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
    plot_extreme.save(figure, "work-precision.png")


def _line(axes, rows, colour, line):
    seconds, errors = [r.cold for r in rows], [r.error for r in rows]
    axes.plot(seconds, errors, color=colour, ls=line, marker="o", mfc=_fill(colour, line))
    wrong = [r for r in rows if r.status != "CONVERGED"]
    axes.plot([r.cold for r in wrong], [r.error for r in wrong], "x", color=GREY, ms=10, zorder=5)


def _fill(colour, line):
    return colour if line == "-" else "white"


def orders(rows: list[Mesh]):
    """True error against unknowns with the fitted order, and seconds against unknowns."""
    if not rows:
        return
    names = list(dict.fromkeys(row.case for row in rows))
    figure, panels = plt.subplots(1, len(names) + 1, figsize=(12.5, 4.3), squeeze=False)
    for name, axes in zip(names, panels[0], strict=False):
        for scheme, colour in COLOURS.items():
            own = [r for r in rows if (r.case, r.scheme) == (name, scheme) and r.error]
            unknowns = np.array([r.unknowns for r in own if _fits(r)], float)
            slope, factor = order(own)
            fit = np.exp(factor) * unknowns**-slope
            axes.plot(unknowns, fit, color=colour, label=f"{scheme}, order {slope:.2f}")
            axes.plot([r.unknowns for r in own], [r.error for r in own], "o", color=colour)
        axes.set(title=name, ylabel="true error / length")
        axes.legend(frameon=False)
    axes = panels[0, -1]
    for scheme, colour in COLOURS.items():
        own = [r for r in rows if (r.case, r.scheme) == (names[0], scheme) and r.cold]
        axes.plot([r.unknowns for r in own], [r.cold for r in own], "o-", color=colour)
        axes.plot(
            [r.unknowns for r in own], [r.build for r in own], "s:", color=colour, mfc="white"
        )
    axes.set(title=f"{names[0]}, fatrop", ylabel="seconds")
    legend = [
        Line2D([], [], color=GREY, marker="o", label="cold solve, solver built"),
        Line2D([], [], color=GREY, marker="s", mfc="white", ls=":", label="building the solver"),
    ]
    axes.legend(handles=legend, frameon=False)
    for axes in panels[0]:
        axes.set(xscale="log", yscale="log", xlabel="unknowns, uniform mesh")
    figure.tight_layout()
    plot_extreme.save(figure, "order.png")


def peers(rows: list[Peer]):
    """True error against seconds of all, on Table 1 and on a cantilever."""
    if not rows:
        return
    figure, panels = plt.subplots(1, 2, figsize=(13.5, 5.4), sharex=True, sharey=True)
    for problem, axes in zip((PAPER, "cantilever"), panels, strict=True):
        for peer, (colour, marker) in PEERS.items():
            for start in ("cold", "answer"):
                lines = {}
                for r in rows:
                    if (r.problem, r.peer, r.start) == (problem, peer, start) and r.error:
                        lines.setdefault(
                            (r.variant, r.steps if r.peer != OPENSEES else 0), []
                        ).append(r)
                for own in lines.values():
                    own.sort(key=lambda row: row.error)
                    axes.plot(
                        [r.seconds for r in own],
                        [r.error for r in own],
                        color=colour,
                        marker=marker,
                        ls="-" if start == "cold" else ":",
                        mfc=colour if start == "cold" else "white",
                    )
        axes.set(xscale="log", yscale="log", title=problem, xlabel="seconds")
    panels[0].set_ylabel("true error / length")
    legend = [
        Line2D([], [], color=colour, marker=marker, label=peer)
        for peer, (colour, marker) in PEERS.items()
    ]
    legend.append(
        Line2D([], [], color=GREY, ls=":", marker="o", mfc="white", label="from our answer")
    )
    figure.suptitle("Error against run time: everybody at the error that they reach", fontsize=12)
    figure.legend(handles=legend, loc="lower center", ncols=4, frameon=False)
    figure.tight_layout(rect=(0, 0.1, 1, 1))
    plot_extreme.save(figure, "peers.png")


def scaling(rows: list[Scaling]):
    """Seconds against elements up to thousands."""
    if not rows:
        return
    figure, axes = plt.subplots(figsize=(6.4, 4.3))
    for scheme, colour in COLOURS.items():
        own = [r for r in rows if r.scheme == scheme and r.status == "CONVERGED"]
        elements = [r.elements for r in own]
        axes.plot(elements, [r.cold for r in own], "o-", color=colour, label=scheme)
        axes.plot(elements, [r.in_solver for r in own], "o:", color=colour, mfc="white")
    if own:
        linear = own[0].cold / own[0].elements * np.array(elements)
        axes.plot(elements, linear, color=GREY, lw=0.8, label="linear")
    axes.plot([], [], "o:", color=GREY, mfc="white", label="in the solver alone")
    axes.set(xscale="log", yscale="log", xlabel="elements", ylabel="seconds, cold, solver built")
    axes.set_title("table 1, 0.73 m, fatrop")
    axes.legend(frameon=False)
    figure.tight_layout()
    plot_extreme.save(figure, "scaling.png")


if __name__ == "__main__":
    main()
