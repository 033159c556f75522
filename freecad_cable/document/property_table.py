# SPDX-License-Identifier: LGPL-2.1-or-later
"""Properties as rows of a table: the same table makes a new object and completes an old one."""

from dataclasses import dataclass

import FreeCAD
from FreeCAD import Units

from ..errors import DocumentError
from ..problem.checked import LARGEST
from .sentences import in_language

# Attributes of ``addProperty``.
READ_ONLY, HIDDEN, OUTPUT = 1, 4, 8

SCHEMA_VERSION = 1
"""Of the properties of all our objects; counts up when an old file needs a migration."""


@dataclass(frozen=True)
class Prop:
    """A property of an object of ours."""

    name: str
    kind: str
    """type in FreeCAD, without ``App::Property``"""
    group: str
    text: str
    """for the user; names the unit if the type carries none"""
    value: object = None
    """at the start"""
    unit: str = ""
    """in which a message says the value; of a ``Quantity`` also the unit of the property"""
    choices: tuple = ()
    """of an enumeration"""
    result: bool = False
    """written by ``execute``, so writing it must not ask for another"""
    hidden: bool = False


VERSION = Prop("SchemaVersion", "Integer", "Base", "Version of the properties", hidden=True)


def complete(obj, table):
    """Add the properties of ``table`` that ``obj`` lacks, and the units that files do not keep."""
    for prop in (*table, VERSION):
        new = prop.name not in obj.PropertiesList
        if new:
            _add(obj, prop)
        # A fresh one has no unit, and files keep the number only; in a file from before it may be of another type.
        if obj.getTypeIdOfProperty(prop.name) == "App::PropertyQuantity":
            setattr(obj, prop.name, Units.Quantity(f"1 {prop.unit}").Unit)
        if new and prop.value is not None:
            setattr(obj, prop.name, prop.value)
    if obj.SchemaVersion > SCHEMA_VERSION:
        said = in_language(
            f"{obj.Label} was stored by a later version of the Cable workbench; what this one does not know it leaves "
            "alone. Update the workbench."
        )
        FreeCAD.Console.PrintWarning(f"{said}\n")
    elif obj.SchemaVersion < SCHEMA_VERSION:
        obj.SchemaVersion = SCHEMA_VERSION


def _add(obj, prop):
    attributes = (OUTPUT | READ_ONLY if prop.result else 0) | (HIDDEN if prop.hidden else 0)
    obj.addProperty(f"App::Property{prop.kind}", prop.name, prop.group, prop.text, attributes)
    if prop.choices:
        setattr(obj, prop.name, list(prop.choices))


def reset(obj, table):
    """Set the results of ``table`` that a user sees back to what they are at the start."""
    for prop in table:
        if prop.result and not prop.hidden and "Link" not in prop.kind:
            setattr(obj, prop.name, _empty(obj, prop))


def _empty(obj, prop):
    if prop.value is not None:
        return prop.value
    now = getattr(obj, prop.name)
    return 0 if isinstance(now, Units.Quantity) else type(now)()


def wrong(obj, name, complaint) -> DocumentError:
    """The error of a property: ``complaint`` says value, bound, and what to do."""
    return DocumentError(f"{obj.Label}, {name}: {complaint}")


class Checked:
    """The numbers of an object, in the units of its table. Errors: ``DocumentError``."""

    def __init__(self, obj, table):
        self.obj = obj
        self.units = {prop.name: prop.unit for prop in table}

    def number(self, name, *, above=None, at_least=None):
        """The property in its unit, finite and within the bound."""
        value, unit = getattr(self.obj, name), self.units[name]
        if isinstance(value, Units.Quantity):
            value = float(value.getValueAs(unit))
        shown = f" {unit}" if unit else ""
        if not abs(value) <= LARGEST:
            raise wrong(
                self.obj,
                name,
                f"is {value:g}{shown}; it must be a finite number, at most {LARGEST:g}{shown} in size.",
            )
        if above is not None and not value > above:
            raise wrong(
                self.obj, name, f"is {value:g}{shown}; it must be greater than {above:g}{shown}."
            )
        if at_least is not None and not value >= at_least:
            raise wrong(
                self.obj, name, f"is {value:g}{shown}; it must be at least {at_least:g}{shown}."
            )
        return value
