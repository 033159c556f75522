# SPDX-License-Identifier: LGPL-2.1-or-later
"""To what length a cable is cut: what lies between the terminals, what the connectors take, rounded up."""

import math

from .property_table import Checked, Prop

ROUNDING = 1e-9
"""Of a length in steps: that a computed length is a little over a full step does not cost another one."""

TABLE = (
    Prop(
        "StartAllowance",
        "Distance",
        "Cut",
        "Length added at the start, inside the connector and to strip",
        unit="mm",
    ),
    Prop("EndAllowance", "Distance", "Cut", "The same at the end", unit="mm"),
    Prop(
        "RoundUpTo",
        "Distance",
        "Cut",
        "The cut length is rounded up to a multiple of this; 0: not rounded",
        unit="mm",
    ),
    Prop(
        "CutLength",
        "Length",
        "Result",
        "Length to cut: the solved length and both allowances, rounded up",
        result=True,
    ),
)


def write(cable):
    """Errors: ``DocumentError`` if an allowance is negative."""
    checked = Checked(cable, TABLE)
    length = cable.SolvedLength.Value + sum(
        checked.number(name, at_least=0) for name in ("StartAllowance", "EndAllowance")
    )
    step = checked.number("RoundUpTo", at_least=0)
    cable.CutLength = math.ceil(length / step - ROUNDING) * step if step else length
