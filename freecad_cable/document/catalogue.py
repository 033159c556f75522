# SPDX-License-Identifier: LGPL-2.1-or-later
"""The built-in cable types: ``resources/cable_types.csv``, every number with its source."""

import csv
from pathlib import Path

PATH = Path(__file__).parents[2] / "resources" / "cable_types.csv"


def catalogue():
    """Properties of a ``CableType``, by the name of the type."""
    with PATH.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    return {
        row["name"]: {
            "OuterDiameter": f"{row['outer_diameter_mm']} mm",
            "MassPerLength": f"{row['mass_per_length_g_m']} g/m",
            "BendingStiffness": f"{row['bending_stiffness_N_m2']} N*m^2",
            "TorsionalStiffness": f"{row['torsional_stiffness_N_m2']} N*m^2",
            "Provenance": row["source"],
        }
        for row in rows
    }
