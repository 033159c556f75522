# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two bays of a satellite from a STEP file: cables through holes, in P-clips and over what is round, each as short as
its bend radius and its clearance allow."""

import math
from pathlib import Path

import Import
from FreeCAD import Placement, Rotation, Vector

from ..document import make, solving
from ..errors import DocumentError
from .circles import Circles
from .plug import plugged
from .satellite_wiring import (
    CLEARANCE,
    CLIP_WIDTH,
    CLIPS,
    CONNECTORS,
    HOLES,
    RIM,
    RUNS,
    THICKNESS,
    TYPES,
)

TITLE = "Nine cables through two bays of a satellite: the shortest that bend as they may, and the spline routes"

VIEW = -62, 27, 1.12
"""Azimuth and elevation [degrees] of the viewer, and the size of the picture."""

COLUMNS = 3
"""of panels in the picture of curvature"""

SHORTEST = True
"""Whether the lengths are the answer, so that their sum says something."""

STEP = Path(__file__).parents[2] / "resources" / "demo" / "satellite.step"


def build(document):
    """Yield the pairs (cable, route), with the lengths found, not yet recomputed."""
    # As a link group, FreeCAD 0.20 crashes on assemblies.
    Import.insert(str(STEP), document.Name, useLinkGroup=False)
    satellite = document.getObject("Satellite")
    circles = Circles(satellite)
    kinds = {name: make.cable_type(document, name, **given) for name, given in TYPES.items()}
    ends = {name: plugged(document, circles, name, each) for name, each in CONNECTORS.items()}
    holds = {name: _ring(document, circles, name) for name in HOLES}
    holds |= {name: _clip(document, circles, name) for name in CLIPS}
    document.recompute()
    for name, run in RUNS.items():
        cable = make.cable(
            document,
            start=ends[run.start],
            end=ends[run.end],
            cable_type=kinds[run.type],
            length_mode="Shortest",
            supports=[holds[support] for support in run.over],
            obstacles=[_reference(satellite, label) for label in run.lies_on],
        )
        cable.Label = name
        document.recompute()
        solving.wait(document)
        cable.LengthMode, cable.Length = "Fixed", _cut(cable)
        cable.Obstacles = _obstacles(satellite)
        cable.Clearance = 0 if run.lies_on else CLEARANCE
        yield cable, make.route(document, cable)


def _cut(cable):
    """Its shortest length [mm], rounded up. Obstacles that a cable does not touch do not change it, and whether it does
    is seen when it is solved among all of them."""
    if not cable.isValid():
        raise DocumentError(cable.Status)
    return math.ceil(cable.ShortestLength.Value)


def parts(document):
    """The objects that are not ours."""
    return [document.getObject("Satellite")]


def _obstacles(satellite):
    """All but the P-clips, which hold the cables."""
    names = satellite.getSubObjects()
    return [(satellite, name) for name in names if _label(satellite, name) != "Clips"]


def _reference(satellite, label):
    """Of a solid of the structure."""
    for part in satellite.getSubObjects():
        if _label(satellite, part) == "Structure":
            for name in satellite.getSubObject(part, retType=1).getSubObjects():
                if _label(satellite, part + name) == label:
                    return satellite, part + name
    raise DocumentError(f"The structure has no {label}.")


def _label(satellite, path):
    return satellite.getSubObject(path, retType=1).Label


def _ring(document, circles, name):
    hole = HOLES[name]
    reference = circles.reference(hole.centre, hole.radius)
    middle = Placement(Vector(0, 0, -THICKNESS / 2), Rotation())
    return _labelled(make.ring(document, reference, clearance=RIM, offset=middle), name)


def _clip(document, circles, name):
    """A P-clip lets the cable turn; tightened last, it lets it slide, too."""
    clip = CLIPS[name]
    edge = Vector(*clip.centre) + Vector(*clip.direction) * (CLIP_WIDTH / 2)
    reference = circles.reference(edge, clip.bore)
    middle = Placement(Vector(0, 0, -CLIP_WIDTH / 2), Rotation())
    if clip.position is None:
        return _labelled(make.sleeve(document, reference, offset=middle), name)
    return _labelled(make.clip(document, reference, position=clip.position, offset=middle), name)


def _labelled(obj, label):
    obj.Label = label
    return obj
