# SPDX-License-Identifier: LGPL-2.1-or-later
"""Material cards of FreeCAD: ``Key = value`` up to 0.21, ``Key: "value"`` under models from 1.0 on.

A card states a material, or with the model ``Cable`` (``resources/material_models``) a cable.
"""

import re
from pathlib import Path

from FreeCAD import Units

from ..errors import DocumentError
from .catalogue import CONVENTIONS, NEEDED, NUMBERS

ENTRY = re.compile(r"""^\s*(\w+)\s*[=:]\s*["']?([^"'#;]*?)["']?\s*$""")

LINES = re.compile(r"""^( *)Provenance:\s*[|>]\d?\s*\n((?:\1 +.*\n?|\s*\n)*)""", re.MULTILINE)
"""Text of more than one line."""


def read_card(card):
    """Properties of a ``CableType`` from a card: the path of its file, or a material of FreeCAD's library.

    Of a cable: what it states. Of a material: moduli, density, provenance; without a shear modulus that is E/2(1+ν), as
    for any isotropic solid. Errors: ``DocumentError`` naming the card and what it lacks.
    """
    name, entries, lines = _entries(card)
    if "BendingStiffness" in entries:
        return _cable(name, entries, lines)
    young = _quantity(name, entries, "YoungsModulus", "Pa")
    if entries.get("ShearModulus"):
        shear = _quantity(name, entries, "ShearModulus", "Pa")
    else:
        shear = young / (2 * (1 + _quantity(name, entries, "PoissonRatio", "")))
    source = _source(entries)
    return {
        "Source": "Material",
        "YoungsModulus": f"{young!r} Pa",
        "ShearModulus": f"{shear!r} Pa",
        "Density": f"{_quantity(name, entries, 'Density', 'kg/m^3')!r} kg/m^3",
        "Provenance": [
            f"{each}: {source}" for each in ("YoungsModulus", "ShearModulus", "Density")
        ],
    }


def _entries(card):
    """How messages call the card, its values by key, and the lines of its provenance."""
    if hasattr(card, "Properties"):  # of the library, with all that it inherits
        # What Properties says of numbers is rounded.
        entries = {
            key: card.getPhysicalValue(key) if card.hasPhysicalProperty(key) else value
            for key, value in card.Properties.items()
            if value
        }
        return card.Name, entries | {"Name": card.Name}, entries.get("Provenance", "").splitlines()
    try:
        text = Path(card).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise DocumentError(f"The material card {card} cannot be read: {error}.") from None
    block = LINES.search(text)
    found = (ENTRY.match(line) for line in LINES.sub("", text).splitlines())
    entries = dict(each.groups() for each in found if each)
    return card, {"Name": Path(card).stem} | entries, block[2].splitlines() if block else []


def _cable(name, entries, lines):
    told = [line.strip() for line in lines if line.strip()]
    known = {"Source": "Values"}
    for key, (prop, _, unit) in NUMBERS.items():
        if key in NEEDED or entries.get(prop):
            known[prop] = f"{_quantity(name, entries, prop, unit)!r} {unit}"
            if not any(line.startswith(f"{prop}: ") for line in told):
                told.append(f"{prop}: {_source(entries)}")
    convention = entries.get("BendRadiusConvention", "").lower()
    if convention not in CONVENTIONS:
        raise DocumentError(
            f"The material card {name}, BendRadiusConvention: is {convention!r}; it must be Inside or Centreline."
        )
    return known | {"BendRadiusConvention": CONVENTIONS[convention], "Provenance": told}


def _source(entries):
    return f"user, material card {entries['Name']}"


def _quantity(name, entries, key, unit):
    value = entries.get(key)
    if not value:
        raise DocumentError(
            f"The material card {name} has no {key}; it may inherit it from another card. Choose that one."
        )
    try:
        return float(Units.Quantity(value).getValueAs(unit) if unit else Units.Quantity(value))
    except (ValueError, ArithmeticError, TypeError, OSError):
        raise DocumentError(
            f"The material card {name}, {key}: {value!r} is no number in {unit}."
        ) from None
