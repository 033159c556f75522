# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parts of a profile are those of the solver as it is now, and sum up to the whole."""

import time

from benchmarks import profile_solve
from benchmarks.cases import seed_paper
from freecad_cable.equilibrium import find_equilibrium


def test_parts_sum_up_to_the_whole():
    scene = seed_paper(0.73)
    before = find_equilibrium(scene)
    for start in (None, before):
        begin = time.perf_counter()
        parts = profile_solve._parts(scene, start)
        whole = time.perf_counter() - begin
        assert set(parts) == set(profile_solve.PARTS)
        assert min(parts.values()) >= 0
        assert 0.5 * whole < sum(parts.values()) <= whole
        for part in (profile_solve.EVALUATION, "error estimate", "stability", "the answer"):
            assert parts[part] > 0
