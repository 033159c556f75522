# SPDX-License-Identifier: LGPL-2.1-or-later
"""Material cards of FreeCAD: ``Key = value`` up to 0.21, ``Key: "value"`` under models from 1.0 on."""

import re
from pathlib import Path

from FreeCAD import Units

from ..errors import DocumentError

ENTRY = re.compile(r"""^\s*(\w+)\s*[=:]\s*["']?([^"'#;]*?)["']?\s*$""")


def read_card(path):
    """Properties of a ``CableType`` from a card: moduli, density, provenance.

    Without a shear modulus it is E/2(1+ν), as for any isotropic solid. Errors: ``DocumentError`` naming the
    card and what it lacks.
    """
    try:
        text = Path(path).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise DocumentError(f"The material card {path} cannot be read: {error}.") from None
    entries = dict(found.groups() for line in text.splitlines() if (found := ENTRY.match(line)))
    young = _quantity(path, entries, "YoungsModulus", "Pa")
    if entries.get("ShearModulus"):
        shear = _quantity(path, entries, "ShearModulus", "Pa")
    else:
        shear = young / (2 * (1 + _quantity(path, entries, "PoissonRatio", "")))
    source = f"user, material card {entries.get('Name') or Path(path).stem}"
    return {
        "YoungsModulus": f"{young!r} Pa",
        "ShearModulus": f"{shear!r} Pa",
        "Density": f"{_quantity(path, entries, 'Density', 'kg/m^3')!r} kg/m^3",
        "Provenance": [
            f"{name}: {source}" for name in ("YoungsModulus", "ShearModulus", "Density")
        ],
    }


def _quantity(path, entries, key, unit):
    value = entries.get(key)
    if not value:
        raise DocumentError(
            f"The material card {path} has no {key}; it may inherit it from another card. Choose that one."
        )
    try:
        return float(Units.Quantity(value).getValueAs(unit) if unit else Units.Quantity(value))
    except (ValueError, ArithmeticError, TypeError, OSError):
        raise DocumentError(
            f"The material card {path}, {key}: {value!r} is no number in {unit}."
        ) from None
