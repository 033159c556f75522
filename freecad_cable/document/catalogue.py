# SPDX-License-Identifier: LGPL-2.1-or-later
"""The library of cable types: ``resources/cable_types.csv``, and the user's own in files of the same form.

A line is a type; the columns are those of the built-in file. Behind every number stands where it is from: a kind of
``KINDS``, a comma, and the source. What the user has counts before what is built in.
"""

import csv
import math
from pathlib import Path

import FreeCAD

from ..errors import DocumentError

BUILT_IN = Path(__file__).parents[2] / "resources" / "cable_types.csv"

KINDS = ("measured", "datasheet", "standard", "derived", "user", "placeholder")
"""Of where a number is from. A placeholder is there because something must be, and wants to be replaced."""

LARGEST = 1e6
"""Of any number in its unit: larger ones are a slip of the pen or a wrong unit."""

NUMBERS = {
    "outer_diameter": ("OuterDiameter", "mm", "mm"),
    "mass_per_length": ("MassPerLength", "g_m", "g/m"),
    "bending_stiffness": ("BendingStiffness", "N_m2", "N*m^2"),
    "slip_bending_stiffness": ("SlipBendingStiffness", "N_m2", "N*m^2"),
    "stick_bending_stiffness": ("StickBendingStiffness", "N_m2", "N*m^2"),
    "second_bending_stiffness": ("SecondBendingStiffness", "N_m2", "N*m^2"),
    "torsional_stiffness": ("TorsionalStiffness", "N_m2", "N*m^2"),
    "axial_stiffness": ("AxialStiffness", "N", "N"),
    "min_bend_radius": ("MinBendRadius", "mm", "mm"),
    "min_bend_radius_moving": ("MinBendRadiusMoving", "mm", "mm"),
}
"""Name of a number: property of a ``CableType``, unit in the name of the column, unit in FreeCAD."""

NEEDED = ("outer_diameter", "mass_per_length", "bending_stiffness", "torsional_stiffness")

CONVENTION = "bend_radius_convention"
CONVENTIONS = {"": "Inside", "inside": "Inside", "centreline": "Centreline"}

COLUMNS = [
    "name",
    *(
        column
        for name, (_, unit, _) in NUMBERS.items()
        for column in (f"{name}_{unit}", f"{name}_from")
    ),
    CONVENTION,
]


def user_folder() -> Path:
    """Where the files of the user are, all ``*.csv`` in it; it need not exist."""
    return Path(FreeCAD.getUserAppDataDir()) / "Cable" / "cable_types"


def catalogue() -> dict:
    """Properties of a ``CableType``, by the name of the type; what cannot be read is left out, see ``complaints``."""
    return {name: found for name, found in _all().items() if isinstance(found, dict)}


def complaints() -> list[str]:
    """What is wrong in the files of the user, as sentences: file, line, column, value, bound."""
    return [str(found) for found in _all().values() if isinstance(found, DocumentError)]


def entry(name) -> dict | None:
    """The properties of the type of this name, None if there is none. Errors: ``DocumentError`` if it cannot be
    read."""
    found = _all().get(name)
    if isinstance(found, DocumentError):
        raise found
    return found


def save(cable_type, path=None) -> Path:
    """Put a ``CableType`` of a document into a file of the user, in the place of one of its name; returns the path.

    Errors: ``DocumentError`` if the file cannot be read or written.
    """
    path = Path(path or user_folder() / "own.csv")
    lines = []
    try:
        if path.exists():
            lines = [line for _, line in _lines(path) if line["name"].strip() != cable_type.Label]
        path.parent.mkdir(parents=True, exist_ok=True)
        with path.open("w", encoding="utf-8", newline="") as file:
            writer = csv.DictWriter(file, COLUMNS, lineterminator="\n", extrasaction="ignore")
            writer.writeheader()
            writer.writerows([*lines, _line(cable_type)])
    except OSError as error:
        raise DocumentError(f"{path} cannot be written: {error.strerror}.") from None
    return path


def _line(cable_type):
    line = {"name": cable_type.Label, CONVENTION: cable_type.BendRadiusConvention.lower()}
    sources = dict(said.split(": ", 1) for said in cable_type.Provenance if ": " in said)
    for name, (prop, short, unit) in NUMBERS.items():
        value = float(getattr(cable_type, prop).getValueAs(unit))
        if value or name in NEEDED:
            line[f"{name}_{short}"] = repr(value)
            source = sources.get(prop) or "; ".join(cable_type.Provenance) or "not given"
            line[f"{name}_from"] = source if _kind(source) in KINDS else f"user, {source}"
    return line


def _all():
    """Name of every type, or of what cannot be read: its properties or the ``DocumentError``."""
    found = {}
    for path in (*sorted(user_folder().glob("*.csv")), BUILT_IN):
        for name, properties in _read(path):
            found.setdefault(name, properties)
    return found


def _read(path):
    try:
        for number, line in _lines(path):
            name = (line["name"] or "").strip()
            where = f"{path}, line {number}"
            try:
                if not name:
                    raise DocumentError(f"{where}, name: is empty; every type needs one.")
                yield name, _properties(where, line, path)
            except DocumentError as error:
                yield name or where, error
    except DocumentError as error:
        yield str(path), error


def _lines(path):
    """Pairs of the number of a line and what its columns hold. Errors: ``DocumentError``."""
    try:
        # Programs that write tables put a mark of their encoding in front.
        with path.open(encoding="utf-8-sig", newline="") as file:
            reader = csv.DictReader(file, strict=True)
            missing = [column for column in COLUMNS[:3] if column not in (reader.fieldnames or ())]
            unknown = [column for column in reader.fieldnames or () if column not in COLUMNS]
            if missing or unknown:
                said = f"has no column {missing[0]}" if missing else f"has a column {unknown[0]!r}"
                raise DocumentError(
                    f"{path}, line 1: {said}; the columns are {', '.join(COLUMNS)}."
                )
            return [(reader.line_num, line) for line in reader]
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise DocumentError(f"{path} cannot be read as a table in UTF-8: {error}.") from None


def _properties(where, line, path):
    if None in line or None in line.values():
        raise DocumentError(
            f"{where}: has more or fewer values than columns; put text with commas in quotes."
        )
    known, provenance = {}, []
    for name, (prop, short, unit) in NUMBERS.items():
        value = _number(where, f"{name}_{short}", line.get(f"{name}_{short}", ""), name in NEEDED)
        known[prop] = f"{value!r} {unit}"
        if value:
            source = line.get(f"{name}_from", "").strip()
            provenance.append(f"{prop}: {_source(where, f'{name}_from', source, path)}")
    slip, mean, stick = (
        float(known[f"{each}BendingStiffness"].split()[0]) for each in ("Slip", "", "Stick")
    )
    if slip > mean or 0 < stick < mean:
        raise DocumentError(
            f"{where}, bending_stiffness_N_m2: is {mean:g}; it must lie between the bounds {slip:g} (strands slip) and "
            f"{stick:g} (they stick)."
        )
    convention = line.get(CONVENTION, "").strip().lower()
    if convention not in CONVENTIONS:
        raise DocumentError(
            f"{where}, {CONVENTION}: is {convention!r}; it must be inside or centreline."
        )
    return known | {"BendRadiusConvention": CONVENTIONS[convention], "Provenance": provenance}


def _number(where, column, text, needed):
    """0 if there is none."""
    if not text.strip() and not needed:
        return 0.0
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not 0 < value <= LARGEST:
        raise DocumentError(
            f"{where}, {column}: is {text!r}; it must be a number greater than 0 and at most {LARGEST:g}"
            f"{'' if needed else ', or empty'}."
        )
    return value


def _source(where, column, text, path):
    if not text and path != BUILT_IN:
        return f"user, {path.name}"
    if _kind(text) not in KINDS:
        raise DocumentError(
            f"{where}, {column}: is {text!r}; it must begin with one of {', '.join(KINDS)}, a comma, and the source."
        )
    return text


def _kind(source):
    return source.partition(",")[0].strip()
