# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which equations yield to fatrop: those of ends and supports, and no others."""

import pytest

from freecad_cable.solve.yielding import YieldingProgram
from freecad_cable.transcription.nlp import build
from freecad_cable.transcription.structure import Structure
from freecad_cable.transcription.writer import Writer

STRUCTURES = [
    Structure("magnus", (3,), "free", "clamped", (0, 1, 2)),
    Structure("helix", (3,), "clamped", "free", (0, 1, 2)),
    Structure("magnus", (4,), "clamped", "swivel", (0, 1), contacts=2, bend_limit=True),
    Structure("magnus", (2, 1, 2), "pinned", "free", (0, 1, 2), ("ring", "sleeve"), (True, False)),
]


@pytest.mark.parametrize("structure", STRUCTURES, ids=str)
def test_what_holds_the_cable_beyond_its_start_yields(structure):
    held = Writer(structure).held_rows
    nlp = build(structure)
    expected = [row for stage in sorted(held) if stage for row in held[stage] if nlp.equality[row]]
    assert YieldingProgram(nlp).rows.tolist() == expected
