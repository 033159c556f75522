# SPDX-License-Identifier: LGPL-2.1-or-later
"""The script that a stored document of this folder was made with, by FreeCAD 0.20.2:

    freecadcmd -c "exec(open('tests/data/make_stored.py').read())"

From the first release on, a file here is never made anew: it stands for what users have, and what is recomputed without
CasADi must still be what was solved. A new ``SCHEMA_VERSION`` gets a new file beside it.
"""

import FreeCAD
import Part
from FreeCAD import Placement, Rotation, Vector

from freecad_cable.document import make
from freecad_cable.document.property_table import SCHEMA_VERSION


def pin(document, name, x):
    made = document.addObject("Part::Cylinder", name)
    made.Radius, made.Height = 4, 10
    made.Placement.Base = Vector(x, 0, -10)
    return made


def plate(document):
    made = document.addObject("Part::Feature", "Plate")
    hole = Part.makeCylinder(10, 4, Vector(0, 0, -2))
    made.Shape = Part.makeBox(80, 60, 2, Vector(-40, -30, -2)).cut(hole)
    made.Placement = Placement(Vector(60, 20, 60), Rotation(Vector(0, 0, 1), Vector(1, 0, 0)))
    edges = enumerate(made.Shape.Edges, 1)
    return made, next(f"Edge{i}" for i, edge in edges if isinstance(edge.Curve, Part.Circle))


def fill(document):
    """Every kind of object, and in the cable everything that it can keep."""
    unit = document.addObject("App::Part", "Unit")
    left, right, (wall, edge) = (
        pin(document, "Left", 0),
        pin(document, "Right", 120),
        plate(document),
    )
    unit.addObjects([left, right, wall])
    unit.Placement = Placement(Vector(5, -7, 11), Rotation(Vector(1, 2, 3), 20))
    document.recompute()
    kind = make.cable_type(document, "Hook-up wire AWG 20, ETFE", min_bend_radius="8 mm")
    start = make.terminal(document, (left, "Edge3"), inside=unit)
    end = make.terminal(document, (right, "Edge3"), inside=unit, condition="Swivel")
    ring = make.ring(document, (wall, edge), inside=unit)
    roof = document.addObject("Part::Box", "Roof")
    unit.addObject(roof)
    roof.Length = roof.Width = 300
    roof.Placement.Base = Vector(-90, -150, 95)
    cable = make.cable(
        document,
        start=start,
        end=end,
        cable_type=kind,
        length="340 mm",
        supports=[ring],
        obstacles=[roof],
        start_allowance="8 mm",
        round_up_to="5 mm",
    )
    make.route(document, cable)
    # Not on the way of the cable: only that they are there.
    for kind in (make.clamp, make.clip, make.sleeve):
        kind(document, (wall, "Vertex1"), inside=unit, position="60 mm")
    document.recompute()
    return cable


stored = FreeCAD.newDocument(f"schema-{SCHEMA_VERSION}")
solved = fill(stored)
assert solved.isValid(), solved.Status
assert solved.ContactForces and solved.SupportForces, solved.Status
assert all(obj.State == ["Up-to-date"] for obj in stored.Objects), stored.Objects
stored.saveAs(f"tests/data/schema-{SCHEMA_VERSION}.FCStd")
