# SPDX-License-Identifier: LGPL-2.1-or-later
"""A number somewhere in a document that is changed for a while, and everything as it was afterwards."""

import math
from contextlib import suppress

import FreeCAD
from FreeCAD import Units

from ..errors import DocumentError
from ..problem import Scene
from .made_up import DEGREES, FACTORS, MadeUp
from .property_table import wrong
from .read_scene import read_scene

COMPUTED = ("ExpressionEngine", "cells", "Label", "Proxy", "Visibility")
"""Properties that are not put back by assigning them."""

TAKEN = 1e-6
"""By how much a number may differ from what it was set to, relative or as FreeCAD computes: the solver of an assembly
moves parts by such."""


class Varied:
    """A number of an object: ``names`` lead to it, as ["Placement", "Base", "x"], ["Length"], ["Constraints",
    "width"], or the alias or address of a cell of a spreadsheet."""

    def __init__(self, study, obj, path):
        self.study, self.obj, self.path = study, obj, path
        self.names = path.split(".")
        self.cell = _cell(obj, path)
        if not path:
            raise wrong(study, "VariedProperty", "is empty; name a number, as Length.")
        value = self._get()
        if isinstance(value, bool) or not isinstance(value, (int, float, Units.Quantity)):
            raise self._wrong(
                f"of {obj.Label} is {value!r}, which is no number; choose a numeric one."
            )
        # A cell with a whole number takes any.
        self.whole = isinstance(value, int) and not self.cell
        self.unit = value.Unit if isinstance(value, Units.Quantity) else None
        if self.unit == Units.Unit():
            self.unit = None

    @property
    def unit_text(self) -> str:
        """Of a value, as FreeCAD computes; empty if it has none."""
        if self.unit is None:
            return ""
        return Units.Quantity(1.0, self.unit).toStr().partition(" ")[2]

    def set(self, value):
        """Errors: ``DocumentError`` if the property does not take it."""
        try:
            self._put(value)
        except (ArithmeticError, AttributeError, RuntimeError, TypeError, ValueError) as error:
            raise self._wrong(f"of {self.obj.Label} does not take {value:.6g}: {error}") from None
        if not self.cell:
            self.check(value)

    def check(self, value):
        """Whether the number is what it was set to: FreeCAD bounds many silently, and a recompute, without which a
        cell is not computed, may set others. Errors: ``DocumentError`` if not."""
        now = self._get()
        now = getattr(now, "Value", now)
        if isinstance(now, (int, float)) and math.isclose(now, value, rel_tol=TAKEN, abs_tol=TAKEN):
            return
        became = f"{now:.6g}" if isinstance(now, (int, float)) else repr(now)
        raise self._wrong(
            f"of {self.obj.Label} became {became} where {value:.6g} was set; give values that it can take."
        )

    def of(self, scene: Scene, _) -> Scene:
        """A scene that was read with this value."""
        return scene

    def release(self):
        """Take away what else gives the number its value; (path, expression) to put back."""
        found = [
            (path, text)
            for path, text in self.obj.ExpressionEngine
            if path.lstrip(".") in (self.path, self.names[0])
        ]
        for path, _ in found:
            self.obj.setExpression(path, None)
        return found

    def _get(self):
        if self.cell:
            return getattr(self.obj, self.cell, None)
        if self.names[0] == "Constraints" and len(self.names) == 2:
            with suppress(NameError, ValueError, RuntimeError):
                return self.obj.getDatum(self.names[1])
        # Expressions know units that Python does not: lengths in a placement, degrees of its angle. But they take what
        # has the name of a unit for that.
        with suppress(RuntimeError, FreeCAD.Base.FreeCADError):
            return self.obj.evalExpression(self.path)
        value = self.obj
        for name in self.names:
            value = getattr(value, name, None)
        return value

    def _put(self, value):
        value = round(value) if self.whole else value
        if self.cell:
            number = value if self.unit is None else Units.Quantity(value, self.unit)
            # FreeCAD reads no product above a line.
            above, line, below = self.unit_text.partition("/")
            text = f"{value!r} {above.replace('*', ' * 1 ')}{line}{below}".strip()
            self.obj.set(self.cell, f"={text}" if number else text)
        elif self.names[0] == "Constraints" and len(self.names) == 2:
            self.obj.setDatum(self.names[1], Units.Quantity(value, self.unit))
        else:
            if self.names[-2:] == ["Rotation", "Angle"]:
                value = math.radians(value)
            _assign(self.obj, self.names, value)

    def _wrong(self, complaint):
        return wrong(self.study, "VariedProperty", f"{self.path} {complaint}")


def varied_by(study) -> Varied | MadeUp:
    """What a study varies. Errors: ``DocumentError``."""
    obj, path = study.VariedObject or study.Cable, study.VariedProperty
    if obj is study.Cable and path in FACTORS | DEGREES:
        return MadeUp(path)
    return Varied(study, obj, path)


def plain(study, name, given) -> float:
    """A value for what a study varies, as FreeCAD computes, from a number or from a quantity ("500 mm"). Errors:
    ``DocumentError``."""
    number = given
    with suppress(ArithmeticError, ValueError):
        number = Units.Quantity(given) if isinstance(given, str) else given
    if isinstance(number, Units.Quantity):
        if number.Unit != Units.Unit():
            varied = varied_by(study)
            if number.Unit != varied.unit:
                of = (
                    f"a number with the unit {varied.unit_text}"
                    if varied.unit
                    else "a plain number"
                )
                raise DocumentError(f"{name} is {given}, and {varied.path} is {of}; give one.")
        number = number.Value
    if isinstance(number, bool) or not isinstance(number, (int, float)):
        raise DocumentError(f"{name} is {given!r}; it must be a number with its unit.")
    return float(number)


def _cell(obj, path):
    """Address of a cell of a spreadsheet, or None."""
    if obj.TypeId != "Spreadsheet::Sheet":
        return None
    return obj.getCellFromAlias(path) or path


def _assign(owner, names, value):
    """FreeCAD hands out copies of what is inside, so each must be put back into what it is from."""
    first, *rest = names
    if rest:
        inside = getattr(owner, first)
        _assign(inside, rest, value)
        value = inside
    setattr(owner, first, value)


class Kept:
    """Remembers what every property of the open documents was before it changed, and puts it back."""

    def __init__(self, varied: Varied):
        self.varied = varied
        self.before = {}

    def __enter__(self):
        varied = self.varied
        self.touched, self.invalid = _in_state("Touched"), _in_state("Invalid")
        self.contents = varied.cell and varied.obj.getContents(varied.cell)
        FreeCAD.addDocumentObserver(self)
        self.value = varied.names[0] == "Constraints" and varied._get()
        self.expressions = varied.release()
        return self

    def slotBeforeChangeObject(self, obj, name):
        key = obj.Document.Name, obj.Name, name
        if name not in COMPUTED and key not in self.before:
            with suppress(AttributeError, RuntimeError, TypeError):
                self.before[key] = getattr(obj, name)

    def __exit__(self, *_):
        FreeCAD.removeDocumentObserver(self)
        varied = self.varied
        if varied.cell:
            varied.obj.set(varied.cell, self.contents)
            varied.obj.recompute()
        elif varied.names[0] == "Constraints":
            varied.obj.setDatum(varied.names[1], self.value)
        for path, text in self.expressions:
            varied.obj.setExpression(path, text)
        # The last first: a shape takes its placement along, and was changed after it. And once more: what sits on a
        # part goes back to it as long as the part has not gone back itself, and what a number of a cable type changes
        # of it when it goes back, as where that is from, is to go back, too.
        self._put_back()
        # What failed at the last value would be in error with every property as it was.
        _recompute(_in_state("Invalid") - self.invalid)
        self._put_back()
        # Cells are computed from what is as it was now.
        _recompute({key[:2] for key in self.before}, "Spreadsheet::Sheet")
        for document, name in _in_state("Touched") - self.touched:
            FreeCAD.getDocument(document).getObject(name).purgeTouched()

    def _put_back(self):
        for (document, name, prop), value in reversed(self.before.items()):
            obj = FreeCAD.getDocument(document).getObject(name)
            if obj is not None and obj.TypeId != "Spreadsheet::Sheet":
                with suppress(AttributeError, RuntimeError, TypeError, ValueError):
                    if getattr(obj, prop) != value:
                        setattr(obj, prop, value)


def _recompute(which, kind=""):
    """Objects of a kind among some (document, object)."""
    for name in {document for document, _ in which}:
        document = FreeCAD.getDocument(name)
        own = [obj for obj in document.Objects if (name, obj.Name) in which]
        own = [obj for obj in own if not kind or obj.TypeId == kind]
        for obj in own:
            obj.touch()
        if own:
            document.recompute(own)


def _in_state(state):
    """(document, object) of all that are in a state, as "Touched": the next recompute would compute them."""
    return {
        (document.Name, obj.Name)
        for document in FreeCAD.listDocuments().values()
        for obj in document.Objects
        if state in obj.State
    }


class Family:
    """The scenes of a cable at values of a number of its document; inside ``Kept`` only."""

    def __init__(self, cable, varied: Varied):
        self.cable, self.varied = cable, varied
        # What the cable stands on, without the cable: that is what a study solves.
        self.ground = {
            document: [obj for obj in cable.OutListRecursive if obj.Document.Name == document]
            for document in {obj.Document.Name for obj in cable.OutListRecursive}
        }

    def scene(self, value, asks_length=False) -> Scene:
        """``asks_length``: as if the ``LengthMode`` of the cable were Shortest. Errors: ``DocumentError``."""
        self.varied.set(value)
        for document, objects in self.ground.items():
            FreeCAD.getDocument(document).recompute(objects)
        self.varied.check(value)
        for obj in self.ground.get(self.cable.Document.Name, ()):
            if not obj.isValid():
                raise DocumentError(
                    getattr(obj, "Status", "") or f"{obj.Label} cannot be computed."
                )
        for path, text in self.cable.ExpressionEngine:
            _assign(self.cable, path.lstrip(".").split("."), self.cable.evalExpression(text))
        return self.varied.of(read_scene(self.cable, asks_length), value)
