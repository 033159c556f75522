# SPDX-License-Identifier: LGPL-2.1-or-later
"""Material cards of FreeCAD 1.x from the library of cable types.

    python3 resources/make_material_cards.py

writes ``material_cards/*.FCMat``, one for each line of ``cable_types.csv``; ``material_models/Cable.yml`` says what is
in them.
"""

import csv
import re
from pathlib import Path
from uuid import NAMESPACE_URL, uuid5

HERE = Path(__file__).parent
CARDS, TYPES = HERE / "material_cards", HERE / "cable_types.csv"

MODEL = "0d6a2bd6-5f0a-5f43-9f0f-2b4f4f7f6a51"
"""UUID of ``material_models/Cable.yml``."""

UNITS = {"mm": "mm", "g_m": "g/m", "N_m2": "N*m^2", "N": "N"}
"""Unit in the name of a column: unit in FreeCAD."""

IN_A_FILE = str.maketrans("/µ", "-u")
"""FreeCAD calls a material as its file is called."""

COLUMN = re.compile(rf"(.+)_({'|'.join(UNITS)})")


def cards():
    """(name of the file, text) of every card."""
    with TYPES.open(encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            yield f"{row['name'].translate(IN_A_FILE)}.FCMat", _card(row)


def _card(row):
    lines = [
        "---",
        "# SPDX-License-Identifier: LGPL-2.1-or-later",
        "# Made from cable_types.csv by make_material_cards.py.",
        "General:",
        f'  UUID: "{uuid5(NAMESPACE_URL, "freecad_cable/" + row["name"])}"',
        '  License: "LGPL-2.1-or-later"',
        f'  Name: "{row["name"]}"',
        "Models:",
        "  Cable:",
        f'    UUID: "{MODEL}"',
    ]
    sources = []
    for column, value in row.items():
        found = COLUMN.fullmatch(column)
        if found and value:
            name = "".join(word.capitalize() for word in found[1].split("_"))
            lines.append(f'    {name}: "{value} {UNITS[found[2]]}"')
            sources.append(f"{name}: {row[f'{found[1]}_from']}")
    convention = row["bend_radius_convention"].capitalize() or "Inside"
    lines.append(f'    BendRadiusConvention: "{convention}"')
    lines += ["    Provenance: |2", *(f"      {source}" for source in sources)]
    return "\n".join([*lines, ""])


if __name__ == "__main__":
    CARDS.mkdir(exist_ok=True)
    for old in CARDS.glob("*.FCMat"):
        old.unlink()
    for file_name, text in cards():
        (CARDS / file_name).write_text(text, encoding="utf-8")
