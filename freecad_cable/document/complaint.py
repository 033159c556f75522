# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the core complains about, in the words of the document: its properties and labels, and FreeCAD's units."""

from ..errors import DocumentError, ProblemError
from ..shape.units import sentence_from_si
from .property_table import wrong

IN_SCENE = {
    "cable.length": "Length",
    "cable.length_mode": "LengthMode",
    "start": "Start",
    "end": "End",
    "gravity": "Gravity",
    "clearance": "Clearance",
    "options": "Tolerance",
    "cable": "CableType",
    "supports": "Supports",
}
"""Fields of the scene, whole or up to the first dot, and the properties that state them."""

IN_SUPPORT = {
    "arc_length": "Position",
    "radius": "Radius",
    "position": "Reference",
    "quaternion": "Reference",
    "tangent": "Reference",
    "axis": "Reference",
}
"""Fields of a support of the scene and the properties that state them."""

IN_STUDY = {
    "tolerance.count": "Cases",
    "tolerance.seed": "Seed",
    "cable.length_mode": "FindNeededLength",
}
"""Fields of a study of the core and the properties of a study that state them."""

OBSTACLE = "obstacle "
SUPPORT = "support "


def place_of(support):
    """How a scene, and so every message about it, calls a support."""
    return f"{SUPPORT}{support.Label}"


def in_words(cable, sentence) -> str:
    """A sentence of the core for a person who sees the document."""
    labels = [obj.Label for obj in cable.Document.Objects]
    return sentence_from_si(sentence, labels).replace("cable.length: is", "its length is")


def in_row(cable, sentence) -> str:
    """What is wrong in a row of a study, which may begin with a field of the scene."""
    said = in_words(cable, sentence)
    field, _, complaint = said.partition(": ")
    known = field in IN_SCENE or field.rpartition(".")[0] in map(place_of, cable.Supports)
    if not known:
        return said
    return str(in_properties(cable, ProblemError(field, complaint.rstrip("."))))


def of_study(study, error: ProblemError) -> DocumentError:
    """The error of the property of a study, or of its cable, that states what is wrong."""
    if (name := IN_STUDY.get(error.field)) is not None:
        return wrong(study, name, f"{in_words(study.Cable, error.message).rstrip('.')}.")
    return DocumentError(f"{study.Label}: {in_row(study.Cable, str(error)).rstrip('.')}.")


def in_properties(cable, error: ProblemError) -> DocumentError:
    """The error of the property that states what is wrong in the scene of a cable."""
    message = in_words(cable, error.message)
    supports = {place_of(support): support for support in cable.Supports}
    if (support := supports.get(error.field)) is not None:
        return wrong(cable, "Supports", f"{support.Label} {message}.")
    place, _, field = error.field.rpartition(".")
    if (support := supports.get(place)) is not None:
        name = IN_SUPPORT[field.partition("[")[0]]
        return wrong(cable, "Supports", f"{support.Label}, {name}, {message}.")
    if place.startswith(OBSTACLE):
        return wrong(cable, "Obstacles", f"has {place.removeprefix(OBSTACLE)}: {message}.")
    name = IN_SCENE.get(error.field) or IN_SCENE[error.field.partition(".")[0].partition("[")[0]]
    return wrong(cable, name, f"{message}.")
