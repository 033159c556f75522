# SPDX-License-Identifier: LGPL-2.1-or-later
"""References to parts of an assembly.

A reference is a pair (root, path): an object beside the one that refers, in the same container, and the
way down from it, ``Bracket.Body.Face6``. Only so does FreeCAD recompute the referrer when anything on the
way moves, through nested ``App::Part``s and ``App::Link``s, and does the graph stay without a cycle. What
is found is in the coordinates of the container that both share.
"""

from dataclasses import dataclass

import Part
from FreeCAD import DocumentObject, Matrix, Placement

from ..errors import DocumentError
from .proxy import in_use
from .similarity import similarity

MISSING = "?"
"""FreeCAD marks the name of an edge or face that is gone with it."""


@dataclass(frozen=True, eq=False)
class Found:
    """Where a reference leads, in the coordinates of the container of its root."""

    name: str
    """for messages: element and label"""
    matrix: Matrix
    """of the object"""
    element: Part.Shape | None = None
    """the edge, face or vertex; None if the whole object is meant"""
    whole: Part.Shape | None = None
    """the object that has the element"""

    @property
    def placement(self) -> Placement:
        """That of the object. Errors: ``DocumentError`` if a link stretches or mirrors it."""
        return similarity(self.name, self.matrix)[0]


def pairs(reference):
    """The pairs of whatever a user or the property gives: an object, (object, path), or a list of them.

    Errors: ``DocumentError`` if it is something else.
    """
    try:
        if reference is None:
            return []
        if _is_object(reference):
            return [(reference, "")]
        reference = list(reference)
        if len(reference) == 2 and _is_object(reference[0]) and _is_path(reference[1]):
            reference = [tuple(reference)]
        return [pair for item in reference for pair in _pairs(item)]
    except (TypeError, ValueError):
        raise DocumentError(
            f"The reference is {reference!r}; it must be an object, or a pair of an object and the name of "
            "its edge or face, as in (connector, 'Edge7')."
        ) from None


def _pairs(item):
    obj, paths = (item, "") if _is_object(item) else item
    paths = [paths] if isinstance(paths, str) else list(paths) or [""]
    if not _is_object(obj) or not all(isinstance(path, str) for path in paths):
        raise TypeError
    return [(obj, path) for path in paths]


def _is_path(value):
    """Whether ``value`` is a path, or a list of them as the selection gives it."""
    some = [value] if isinstance(value, str) else value
    return isinstance(some, (list, tuple)) and all(isinstance(path, str) for path in some)


def _is_object(value):
    return isinstance(value, DocumentObject)


def container(obj):
    """The object whose placement moves ``obj`` along, or None."""
    group = obj.getParentGeoFeatureGroup()
    if group:
        return group
    # A link group, or a link to several instances.
    return next((p for p in obj.InList if obj in getattr(p, "ElementList", ())), None)


def rebase(obj, name):
    """Say the references in the property ``name`` from roots beside ``obj``, whatever form a user, a macro or a move
    left them in."""
    if not in_use(obj) or obj.Document.Transacting:
        return
    given = pairs(getattr(obj, name))
    try:
        based = [based_beside(obj, pair) for pair in given]
    except DocumentError:
        obj.touch()  # it is said when the object is computed
        return
    if based != given:
        setattr(obj, name, based)


def based_beside(referrer, pair):
    """``pair`` with the root that is beside ``referrer``. Errors: ``DocumentError`` if there is none."""
    *down, element = _split(*pair)
    way = [(step.Name, step) for step in (*_containers(pair[0]), pair[0])]
    way += [(name, _at(pair[0], down[: i + 1])) for i, name in enumerate(down)]
    target = way[-1][1]
    # A plain group has no placement; as a root it could hold the referrer itself.
    way = [(name, step) for name, step in way if step is target or not is_plain_group(step)]
    own = _containers(referrer)
    if [step for _, step in way[: len(own)]] != own:
        raise DocumentError(
            f"{target.Label} is not inside {own[-1].Label}, where {referrer.Label} is, so the one cannot "
            "follow the other. Put both into the same part or assembly."
        )
    way = way[len(own) :]
    if not way:
        raise DocumentError(
            f"{target.Label} contains {referrer.Label}; refer to an edge, a face or an object inside it."
        )
    return way[0][1], ".".join([*(name for name, _ in way[1:]), element])


def refuse_stray(referrer, given):
    """Errors: ``DocumentError`` if the root of one of these pairs is not, or no longer, beside ``referrer``."""
    own = container(referrer)
    for pair in given:
        root, path = pair
        # Of two hundred obstacles nearly all are what they seem, and this is quicker.
        if not path and container(root) is own:
            continue
        if based_beside(referrer, pair) != pair:
            raise DocumentError(f"leads out of its container; choose {root.Label} anew.")


def from_the_top(obj):
    """The pair that leads to ``obj`` from the top of its document."""
    root, *down = *_containers(obj), obj
    return root, "".join(f"{step.Name}." for step in down)


def find(pair) -> Found:
    """Follow a pair. Errors: ``DocumentError`` saying what is missing."""
    root, path = pair
    *down, element = _split(root, path)
    obj = _at(root, down)
    way = "".join(f"{name}." for name in down)
    matrix = root.getSubObject(way, retType=4)
    if not element:
        return Found(obj.Label, matrix)
    name = f"{element.lstrip(MISSING)} of {obj.Label}"
    whole = shape_at(root, way)
    if MISSING in element or Part.getShape(root, way + element, needSubElement=True).isNull():
        raise DocumentError(f"{name} is missing: the part has changed. Choose another.")
    return Found(name, matrix, whole.getElement(element), whole)


def shape_at(root, way):
    """The shape at the end of a way down from ``root``. Not by ``Part.getShape``, which remembers it and does not
    notice when a part of a flexible sub-assembly moves."""
    return root.getSubObject(way)


def _at(root, down):
    """The object at the end of a way down from ``root``."""
    obj = root.getSubObject("".join(f"{name}." for name in down), retType=1) if down else root
    if obj is None:
        raise DocumentError(
            f"{'.'.join(down)} is not inside {root.Label}: it was deleted or moved. Choose another."
        )
    return obj


def _split(root, path):
    """The names on the way, and the element, which may be empty."""
    *down, element = path.split(".")
    if element and MISSING not in element and root.getSubObject(f"{path}.", retType=1) is not None:
        return [*down, element, ""]
    return [*down, element]


def _containers(obj):
    """The containers of an object, outermost first."""
    found = []
    while (obj := container(obj)) is not None:
        found.insert(0, obj)
    return found


def is_plain_group(obj):
    """Whether it has members but no placement."""
    return obj.isDerivedFrom("App::DocumentObjectGroup") and not hasattr(obj, "Placement")
