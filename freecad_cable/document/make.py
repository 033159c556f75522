# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a macro calls. Each function makes one object and returns it; ``doc.recompute()`` computes.

Further keywords are properties of the object in small letters (``min_bend_radius="40 mm"``): a string with its
unit, a ``Quantity``, or, of a length or an angle, a number in mm or degrees. Wrong arguments raise
``DocumentError`` with a sentence, and leave nothing behind.
"""

import re
from contextlib import contextmanager

from ..errors import DocumentError
from .cable import Cable
from .cable_type import CHANGED, SOURCED, CableType
from .catalogue import catalogue, entry
from .centreline import Centreline
from .material_card import read_card
from .proxy import proxy_of
from .reference import based_beside, container, pairs
from .route import Route
from .stored_solution import nearest_node
from .study import Study
from .support import Clamp, Clip, Ring, Sleeve, Support
from .terminal import Terminal
from .varied import plain

NEEDS_UNIT = ("Quantity", "Force", "Pressure")
"""A plain number here, unless degrees, would be in FreeCAD's internal unit, which nobody means."""


def terminal(doc, reference, *, inside=None, **properties):
    """A terminal at ``reference``: an object, or (object, "Edge7"), or (assembly, "Part.Body.Face6"), in any
    form the selection gives; at a vertex a list with a local coordinate system as second entry. None for a free
    end.

    ``inside`` is the part or assembly that the terminal belongs to and moves with; None: the top of the
    document. Properties: condition ("Clamped", "Swivel", "Pinned", "Free"), reverse, roll, offset.
    """
    return _attached(doc, Terminal, reference, inside, properties)


def clamp(doc, reference, *, position=None, inside=None, **properties):
    """A clamp at ``reference``, as of a terminal. ``position`` ("250 mm") is the length of the cable from its start to
    here. Properties: reverse, roll, offset, slides.
    """
    return _support(doc, Clamp, reference, position, inside, properties)


def clip(doc, reference, *, position=None, inside=None, **properties):
    """A clip, as a clamp that lets the cable twist. Properties: reverse, offset, slides."""
    return _support(doc, Clip, reference, position, inside, properties)


def sleeve(doc, reference, *, position=None, inside=None, **properties):
    """A sleeve: the cable slides and twists in it; with a ``position`` it twists. Properties: reverse, offset."""
    return _support(doc, Sleeve, reference, position, inside, properties)


def ring(doc, reference, *, position=None, inside=None, **properties):
    """A hole that the cable passes, from its circular edge; with a ``position`` it does not slide.

    Properties: clearance, offset, and radius if the reference is no circle.
    """
    return _support(doc, Ring, reference, position, inside, properties)


def cable_type(doc, name, *, card=None, **properties):
    """A cable type called ``name``; one of the library (see ``catalogue``) has its numbers, another one those given.

    ``card`` is the path of a material card, or from FreeCAD 1.0 on a material of its library: of a cable it states all
    this; of a material, as do youngs_modulus, shear_modulus, density, the stiffness follows from it and outer_diameter.
    Other properties: mass_per_length, bending_stiffness,
    second_bending_stiffness, slip_bending_stiffness, stick_bending_stiffness, torsional_stiffness, axial_stiffness,
    shear_stiffness, natural_curvature, min_bend_radius, min_bend_radius_moving, moving, bend_radius_convention,
    provenance (text, or lines as "MassPerLength: measured, on our scale").
    """
    if not isinstance(name, str):
        raise DocumentError(f"The name is {name!r}; it must be text.")
    known = entry(name) or {}
    material = read_card(card) if card else {}
    told = properties.pop("provenance", None) or material.pop("Provenance", ())
    with _made(doc, "App::FeaturePython", "CableType", CableType) as obj:
        obj.Label = name
        if {"youngs_modulus", "shear_modulus", "density"} & set(properties):
            obj.Source = "Material"
        for key, value in (known | material).items():
            setattr(obj, key, value)
        _apply(obj, properties)
        _tell_sources(obj, [told] if isinstance(told, str) else list(told))
    return obj


def cable(
    doc,
    *,
    start,
    end,
    cable_type=None,
    length=None,
    slack=None,
    supports=(),
    obstacles=None,
    **properties,
):
    """A cable between two terminals, with its centreline, beside them in their container.

    ``length`` ("730 mm") or ``slack``, (length − distance) / distance; neither: 10 % slack. ``cable_type`` None:
    the first of the document, or a built-in one. ``supports`` in order along the cable. ``obstacles`` is an object, a
    list of them, or of (assembly, "Part.Body."). Properties: clearance, length_mode ("Shortest"),
    bend_radius_mode ("Check", "Enforce"), gravity (m/s²), tolerance, profile, start_allowance, end_allowance,
    round_up_to.
    """
    if length is not None and slack is not None:
        raise DocumentError("A cable has either a length or a slack; give one of them.")
    for name, end_terminal in (("start", start), ("end", end)):
        if proxy_of(end_terminal, Terminal) is None:
            raise DocumentError(f"The {name} is {_said(end_terminal)}; it must be a terminal.")
    if start is end:
        raise DocumentError(f"Both ends are {_said(end)}; a cable needs two terminals.")
    if cable_type is not None and proxy_of(cable_type, CableType) is None:
        raise DocumentError(
            f"The cable type is {_said(cable_type)}; make one with make.cable_type."
        )
    supports, obstacles = _listed(supports), pairs(obstacles)
    _check_supports(supports)
    _check_document(doc, start, end, cable_type, *supports)
    inside = container(start)
    with _made(doc, "Part::FeaturePython", "Cable", Cable, inside) as obj:
        obj.LengthMode = "Fixed" if length is not None else "Slack"
        _apply(obj, properties | _given(length=length, slack=slack))
        obj.Start, obj.End, obj.Supports = start, end, supports
        obj.Obstacles = [based_beside(obj, pair) for pair in obstacles]
        obj.CableType = cable_type or _some_type(doc)
        with _made(doc, "Part::FeaturePython", "Centreline", Centreline, inside) as line:
            line.Cable = obj
        obj.Centreline = line
    return obj


def hold(cable, support):
    """Put a support among those of a cable, where it is nearest to the cable on its way as it is now."""
    if proxy_of(cable, Cable) is None:
        raise DocumentError(f"The cable is {_said(cable)}; it must be a cable.")
    _check_supports([support])
    support.recompute()
    *nodes, here = (nearest_node(cable, each.Frame.Base) for each in (*cable.Supports, support))
    order = list(cable.Supports)
    order.insert(sum(node <= here for node in nodes), support)
    cable.Supports = order


def route(doc, cable, *, method="Spline"):
    """A comparison route of a cable; ``method`` is "Spline", "Catenary" or "Chord"."""
    if proxy_of(cable, Cable) is None:
        raise DocumentError(f"The cable is {_said(cable)}; it must be a cable.")
    with _made(doc, "Part::FeaturePython", "Route", Route, container(cable)) as obj:
        obj.Cable = cable
        _apply(obj, {"method": method})
    return obj


def study(doc, cable, *, varied=None, start=None, stop=None, **properties):
    """A study of a cable; ``studying.run(study)`` runs it.

    ``varied`` is (object, "Placement.Base.x"), or the name of a property of the cable; ``start`` and ``stop``
    ("500 mm", or a number as FreeCAD computes) are the first and the last value. Properties: count, values,
    find_needed_length, record, draw ("Solids", "Centrelines", "Envelope"); kind "Random" or "Corners" with
    length_tolerance, position_tolerance, angle_tolerance, stiffness_factor, cases, seed.
    """
    if proxy_of(cable, Cable) is None:
        raise DocumentError(f"The cable is {_said(cable)}; it must be a cable.")
    obj, path = varied if isinstance(varied, (tuple, list)) and len(varied) == 2 else (None, varied)
    if not isinstance(path, (str, type(None))) or not hasattr(obj or cable, "Document"):
        raise DocumentError(f"varied is {varied!r}; it must be a name, or (object, name).")
    _check_document(doc, obj)
    with _made(doc, "Part::FeaturePython", "Study", Study, container(cable)) as made:
        made.Cable, made.VariedObject = cable, obj
        _apply(made, _given(varied_property=path))
        for name, key, value in (("start", "from", start), ("stop", "to", stop)):
            if value is not None:
                properties[key] = plain(made, name, value)
        if isinstance(properties.get("values"), (list, tuple)):
            properties["values"] = [plain(made, "values", each) for each in properties["values"]]
        _apply(made, properties)
    return made


def _support(doc, kind, reference, position, inside, properties):
    if position is not None:
        properties = {"slides": False, "position": position} | properties
    return _attached(doc, kind, reference, inside, properties)


def _tell_sources(kind, lines):
    """What is told of the numbers of a cable type, one by one or of all that were given, in place of what stood
    there."""
    names = {line.partition(": ")[0] for line in lines}
    of_all = not names <= set(SOURCED)
    kept = [
        said
        for said in kind.Provenance
        if said.partition(": ")[0] not in names and not (of_all and said.endswith(f": {CHANGED}"))
    ]
    kind.Provenance = [*lines, *kept]


def _listed(supports):
    """One is as good as a list of one, and None as an empty one."""
    if supports is None:
        return []
    return list(supports) if isinstance(supports, (list, tuple)) else [supports]


def _check_document(doc, *objects):
    for obj in filter(None, objects):
        if obj.Document is not doc:
            raise DocumentError(
                f"{obj.Label} is in the document {obj.Document.Label}; it must be in {doc.Label}."
            )


def _check_supports(supports):
    for support in supports:
        if proxy_of(support, Support) is None:
            raise DocumentError(
                f"A support is {_said(support)}; it must be a clamp, sleeve, ring or clip."
            )


def _attached(doc, kind, reference, inside, properties):
    given = pairs(reference)
    with _made(doc, "Part::FeaturePython", kind.__name__, kind, inside) as obj:
        _apply(obj, properties)
        obj.Reference = [based_beside(obj, pair) for pair in given]
    return obj


@contextmanager
def _made(doc, kind, name, proxy, inside=None):
    """A new object with its proxy in its container; gone again if something is wrong with it."""
    if inside is not None:
        if not hasattr(inside, "addObject"):
            raise DocumentError(
                f"What it is to be inside is {_said(inside)}; it must be a part, an assembly or a group."
            )
        _check_document(doc, inside)
    obj = doc.addObject(kind, name)
    try:
        proxy(obj)
        if inside is not None:
            inside.addObject(obj)
        yield obj
    except BaseException:
        doc.removeObject(obj.Name)
        raise


def _apply(obj, properties):
    """Set the properties given by keyword."""
    table = {_keyword(p.name): p for p in obj.Proxy.TABLE if not p.result and "Link" not in p.kind}
    if proxy_of(obj, Cable):
        table["profile"] = next(p for p in Cable.TABLE if p.name == "Profile")
    for key, value in properties.items():
        prop = table.get(key)
        if prop is None:
            kind, known = type(obj.Proxy).__name__, ", ".join(sorted(table))
            raise DocumentError(f"{key} is no property of a {kind}; known are {known}.")
        if prop.choices and value not in prop.choices:
            raise DocumentError(f"{key} is {value!r}; it must be one of {', '.join(prop.choices)}.")
        needs_unit = prop.kind in NEEDS_UNIT and prop.unit != "deg"
        if needs_unit and isinstance(value, (int, float)):
            raise DocumentError(
                f"{key} is {value!r} without a unit; give it as '{value!r} {prop.unit}'."
            )
        try:
            setattr(obj, prop.name, value)
        except (ArithmeticError, AttributeError, RuntimeError, TypeError, ValueError):
            form = f"something in {prop.unit}" if prop.unit else f"a {prop.kind.lower()}"
            raise DocumentError(f"{key} is {value!r}; it must be {form}.") from None


def _keyword(name):
    return re.sub(r"(?<!^)(?=[A-Z])", "_", name).lower()


def _given(**values):
    return {key: value for key, value in values.items() if value is not None}


def _said(value):
    return getattr(value, "Label", None) or repr(value)


def _some_type(doc):
    found = (obj for obj in doc.Objects if proxy_of(obj, CableType))
    return next(found, None) or cable_type(doc, next(iter(catalogue())))
