# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of shapes and of curvature; the only file that needs matplotlib.

A cable is a thick line, its spline route a dashed one in the same colour, the equipment glass.
"""

import math

import matplotlib
import numpy as np

matplotlib.use("Agg")

import matplotlib.pyplot as plt
from matplotlib.cm import ScalarMappable
from matplotlib.colors import LinearSegmentedColormap, Normalize
from matplotlib.lines import Line2D
from matplotlib.patheffects import withStroke

from ..study.colours import STOPS
from .colours import COLOURS

METAL, EDGE, LIMIT, GREY = "#8fa3b5", "#54606b", "#b00020", "0.25"

DASHED = (0, (4, 2))

SMALL_EDGE, SMALL_FACE = 8.0, 20.0
"""[mm] Of the equipment, what is smaller would only darken the picture and slow it down."""

DEFLECTION = 2.0
"""[mm] of the triangles of the faces."""

WIDTH = 0.5
"""Points of a line for a millimetre of diameter: about to scale."""

DOTS_PER_INCH = 92

FAMILY_PANELS = ("Smallest bend radius [mm]", "End force [N]", "Energy [J]")
"""Heads of the spreadsheet of a study whose numbers are drawn."""

plt.rcParams.update(
    {
        "font.size": 9,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "grid.color": "#dde3e8",
    }
)


def picture_shapes(path, title, comparisons, parts, view):
    """Cables, their spline routes and the solids ``parts`` of the equipment, to scale.

    view: azimuth and elevation [degrees] of the viewer, and a factor for the size.
    """
    azimuth, elevation, zoom = view
    figure = plt.figure(figsize=(9.6, 6.6))
    axes = figure.add_axes((0, 0, 1, 1), projection="3d", computed_zorder=False)
    axes.view_init(elevation, azimuth)
    _draw_equipment(axes, parts)
    depth = [c.cable.points.mean(axis=0) @ _towards_viewer(azimuth, elevation) for c in comparisons]
    for rank, k in enumerate(np.argsort(depth)):
        _draw_lines(axes, comparisons[k], _colour(k), 10 + 3 * rank)
    _frame(axes, [line.points for c in comparisons for line in (c.cable, c.spline)], parts, zoom)
    figure.suptitle(title, y=0.97, fontsize=12)
    _legend(figure)
    figure.savefig(path, dpi=DOTS_PER_INCH)
    plt.close(figure)


def picture_curvature(path, title, comparisons, columns):
    """Curvature over arc length, a panel for each cable, and the curvature that its bend radius allows."""
    rows = math.ceil(len(comparisons) / columns)
    size = (max(9.6, 2.6 * columns), 0.9 + 2.3 * rows)
    figure, grid = plt.subplots(rows, columns, figsize=size, sharey=True, squeeze=False)
    for k, (axes, comparison) in enumerate(zip(grid.flat, comparisons, strict=True)):
        _draw_curvature(axes, comparison, _colour(k))
    # A spline may bend as sharply as it likes; three times what a cable bears is enough to show.
    limit = 1 / min(c.allowed for c in comparisons)
    highest = max(line.curvature.max() for c in comparisons for line in (c.cable, c.spline))
    grid[0, 0].set_ylim(0, 1e3 * min(max(1.3 * limit, 1.1 * highest), 3 * limit))
    for axes in grid[:, 0]:
        axes.set_ylabel("curvature [1/m]")
    for axes in grid[-1]:
        axes.set_xlabel("along the cable [mm]")
    figure.suptitle(title, fontsize=12)
    _legend(figure, Line2D([], [], color=LIMIT, lw=1.2, label="tightest bend allowed"))
    figure.tight_layout(rect=(0, 0.3 / size[1], 1, 1))
    figure.savefig(path, dpi=DOTS_PER_INCH)
    plt.close(figure)


def picture_family(path, family, parts, view):
    """The shapes of a study, coloured by their values, beside what it recorded."""
    azimuth, elevation, zoom = view
    colours = ScalarMappable(
        Normalize(min(family.values), max(family.values)),
        LinearSegmentedColormap.from_list("family", STOPS),
    )
    figure = plt.figure(figsize=(11.2, 6.2))
    axes = figure.add_axes((0, 0.02, 0.56, 0.94), projection="3d", computed_zorder=False)
    axes.view_init(elevation, azimuth)
    _draw_equipment(axes, parts)
    for value, line in zip(family.values, family.lines, strict=True):
        axes.plot(*line.T, color=colours.to_rgba(value), lw=1.8, zorder=10)
    _frame(axes, family.lines, parts, zoom)
    scale = figure.colorbar(colours, cax=figure.add_axes((0.575, 0.12, 0.012, 0.76)))
    scale.set_label(family.name)
    grid = figure.add_gridspec(3, 1, left=0.69, right=0.985, top=0.93, bottom=0.09, hspace=0.38)
    panels = grid.subplots(sharex=True)
    for panel, head in zip(panels, FAMILY_PANELS, strict=True):
        _draw_numbers(panel, family, head, colours)
    panels[0].axhline(family.allowed, color=LIMIT, lw=1.2, label="allowed")
    panels[0].legend(loc="upper right", frameon=False)
    panels[-1].set_xlabel(family.name)
    figure.suptitle(family.title, y=0.985, fontsize=12)
    figure.savefig(path, dpi=DOTS_PER_INCH)
    plt.close(figure)


def _draw_numbers(axes, family, head, colours):
    """A number of each value; a line where the cable jumps to another shape."""
    numbers = family.numbers(head)
    axes.plot(family.values, numbers, color=GREY, lw=1, zorder=1)
    axes.scatter(family.values, numbers, c=colours.to_rgba(family.values), s=14, zorder=2)
    for jump in family.jumps:
        axes.axvline(jump, color=LIMIT, lw=0.8, ls=DASHED)
    axes.set_title(head, loc="left", fontsize=9)
    axes.grid(True)


def _colour(k):
    return COLOURS[k % len(COLOURS)]


def _legend(figure, *more):
    lines = (
        Line2D([], [], color=GREY, lw=3, label="cable, solved"),
        Line2D([], [], color=GREY, lw=1.3, ls=DASHED, label="spline route"),
    )
    handles = [*lines, *more]
    figure.legend(handles=handles, loc="lower center", ncol=len(handles), frameon=False)


def _draw_curvature(axes, comparison, colour):
    cable, spline = comparison.cable, comparison.spline
    axes.plot(spline.arc_length, 1e3 * spline.curvature, color=colour, lw=1.3, ls=DASHED)
    axes.plot(cable.arc_length, 1e3 * cable.curvature, color=colour, lw=2.2)
    axes.set_xlim(0, max(cable.arc_length[-1], spline.arc_length[-1]))
    limit = 1e3 / comparison.allowed
    axes.axhline(limit, color=LIMIT, lw=1.2)
    axes.axhspan(limit, 10 * limit, color=LIMIT, alpha=0.06, lw=0)
    axes.set_title(comparison.label, color=colour, loc="left", fontweight="bold")


def _draw_equipment(axes, parts):
    """Faces as glass, and the larger edges."""
    corners, triangles, edges = [], [], []
    for part in parts:
        for face in (f for f in part.Faces if f.BoundBox.DiagonalLength > SMALL_FACE):
            points, faces = face.tessellate(DEFLECTION)
            triangles += [[len(corners) + k for k in triangle] for triangle in faces]
            corners += [tuple(point) for point in points]
        for edge in (e for e in part.Edges if e.BoundBox.DiagonalLength > SMALL_EDGE):
            straight = edge.Curve.TypeId == "Part::GeomLine"
            edges += [tuple(point) for point in edge.discretize(2 if straight else 32)]
            edges.append((np.nan, np.nan, np.nan))
    glass = {"color": METAL, "alpha": 0.1, "linewidth": 0, "shade": False, "zorder": 1}
    axes.plot_trisurf(*np.transpose(corners), triangles=triangles, **glass)
    axes.plot(*np.transpose(edges), color=EDGE, lw=0.5, alpha=0.55, zorder=2)


def _draw_lines(axes, comparison, colour, order):
    """The cable in a white seam, so that crossings show which is in front; the name at its middle."""
    cable, width = comparison.cable.points.T, WIDTH * comparison.diameter
    axes.plot(*comparison.spline.points.T, color=colour, lw=1.3, ls=DASHED, zorder=order)
    axes.plot(*cable, color="white", lw=width + 2, zorder=order + 1, solid_capstyle="butt")
    axes.plot(*cable, color=colour, lw=width, zorder=order + 2, solid_capstyle="butt")
    axes.text(
        *(cable[:, cable.shape[1] // 2] + (0, 0, comparison.diameter + 3)),
        comparison.label,
        color=colour,
        fontweight="bold",
        horizontalalignment="center",
        path_effects=[withStroke(linewidth=2.5, foreground="white")],
        zorder=1000,
    )


def _frame(axes, points, parts, zoom):
    """The same scale along all axes, in mm."""
    boxes = [part.BoundBox for part in parts]
    corners = [[(b.XMin, b.YMin, b.ZMin), (b.XMax, b.YMax, b.ZMax)] for b in boxes]
    everything = np.concatenate([*points, *corners])
    low, high = everything.min(axis=0) - 5, everything.max(axis=0) + 5
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
    axes.set(xlabel="x [mm]", ylabel="y [mm]", zlabel="z [mm]")
    axes.set_box_aspect(high - low, zoom=zoom)
    for axis in (axes.xaxis, axes.yaxis, axes.zaxis):
        axis.set_major_locator(plt.MultipleLocator(100))
        axis.set_pane_color((0.97, 0.975, 0.98, 1))


def _towards_viewer(azimuth, elevation):
    """Unit vector (3,)."""
    a, e = math.radians(azimuth), math.radians(elevation)
    return np.array([math.cos(e) * math.cos(a), math.cos(e) * math.sin(a), math.sin(e)])
