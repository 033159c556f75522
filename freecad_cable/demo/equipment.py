# SPDX-License-Identifier: LGPL-2.1-or-later
"""An equipment panel from a STEP file, and the cables of the wiring list between its connectors."""

from pathlib import Path

import Import

from ..document import make
from .circles import Circles
from .harness import CONNECTORS, RUNS, TYPES
from .plug import plugged

TITLE = "Ten cables on an equipment panel: solved, and as a spline would route them"

VIEW = -62, 27, 1.12
"""Azimuth and elevation [degrees] of the viewer, and the size of the picture."""

COLUMNS = 5
"""of panels in the picture of curvature"""

SHORTEST = False
"""Whether the lengths are the answer, so that their sum says something."""

STEP = Path(__file__).parents[2] / "resources" / "demo" / "equipment.step"


def build(document):
    """Yield the pairs (cable, route), not yet recomputed."""
    # As a link group, FreeCAD 0.20 crashes on assemblies.
    Import.insert(str(STEP), document.Name, useLinkGroup=False)
    circles = Circles(document.getObject("Equipment"))
    kinds = {name: make.cable_type(document, name, **given) for name, given in TYPES.items()}
    terminals = {name: plugged(document, circles, name, each) for name, each in CONNECTORS.items()}
    for name, run in RUNS.items():
        cable = make.cable(
            document,
            start=terminals[run.start],
            end=terminals[run.end],
            cable_type=kinds[run.type],
            length=f"{run.length} mm",
        )
        cable.Label = name
        yield cable, make.route(document, cable)


def parts(document):
    """The objects that are not ours."""
    return [document.getObject("Equipment")]
