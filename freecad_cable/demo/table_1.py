# SPDX-License-Identifier: LGPL-2.1-or-later
"""Table 1 of the seed paper: one cable in four lengths between the same two connectors.

Du, Jiang, Xiong, Computer-aided optimal design for flexible cable in aerospace products based on dynamic
analogy modeling, Scientific Reports 12 (2022), doi 10.1038/s41598-022-09880-9. The paper does not say where
down is; here it is −z. Its density is read as 1.16 g/cm³.
"""

import Part
from FreeCAD import Placement, Rotation, Vector

from ..document import make
from ..shape.units import placement_from_si
from .circles import Circles

TITLE = "Four lengths between the same connectors: solved, and as a spline would route them"

VIEW = 35, 15, 0.87
"""Azimuth and elevation [degrees] of the viewer, and the size of the picture."""

COLUMNS = 2
"""of panels in the picture of curvature"""

SHORTEST = False
"""Whether the lengths are the answer, so that their sum says something."""

LENGTHS = (550, 640, 730, 820)
"""[mm]"""

FAMILY = 500, 900, 41
"""First and last length [mm] of the family, and how many."""

START = (0, 0, 0), (0.7071, 0.7071, 0, 0)
END = (0.16, -0.235, 0.33), (0.5, 0.5, 0.5, 0.5)
"""Position [m] and Euler parameters, scalar first, of the section; its third axis runs along the cable."""

RADIUS = 5.0
"""[mm] of the edge of a connector"""

HALF_TURN = Placement(Vector(), Rotation(Vector(1, 0, 0), 180))
"""A connector looks out, and at its end the cable runs in."""


def build(document):
    """Yield the pairs (cable, route), not yet recomputed."""
    kind = make.cable_type(
        document,
        "Cable of Table 1",
        outer_diameter="7 mm",
        youngs_modulus="10 MPa",
        shear_modulus="20 MPa",
        density="1160 kg/m^3",
        min_bend_radius="42 mm",
        provenance="Table 1 of the paper; bend radius: 6 diameters, NASA-STD-8739.4",
    )
    start = _terminal(document, "Start", placement_from_si(*START))
    end = _terminal(document, "End", placement_from_si(*END) * HALF_TURN)
    for length in LENGTHS:
        cable = make.cable(document, start=start, end=end, cable_type=kind, length=f"{length} mm")
        cable.Label = f"{length} mm"
        yield cable, make.route(document, cable)


def family(document, cables):
    """The study of one of the cables over its length, not yet run."""
    cable = cables[LENGTHS.index(730)]
    first, last, count = FAMILY
    study = make.study(document, cable, varied="Length", start=first, stop=last, count=count)
    study.Label = "The same cable from 500 to 900 mm"
    return study


def parts(document):
    """The objects that are not ours."""
    return [obj for obj in document.Objects if obj.Name.startswith("Connector")]


def _terminal(document, label, placement):
    """A terminal on the edge of a plain connector."""
    connector = document.addObject("Part::Feature", "Connector")
    connector.Label = f"{label} connector"
    flange = Part.makeCylinder(2 * RADIUS, 4, Vector(0, 0, -20))
    connector.Shape = Part.makeCylinder(RADIUS, 20, Vector(0, 0, -20)).fuse(flange).Solids[0]
    connector.Placement = placement
    return make.terminal(document, Circles(connector).reference(placement.Base, RADIUS))
