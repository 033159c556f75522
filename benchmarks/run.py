# SPDX-License-Identifier: LGPL-2.1-or-later
"""Error against run time: problem × scheme × solver × tolerance, and a grid of extreme problems.

Writes rows, pictures and a report of them into docs/benchmarks/.
"""

import sys
import time
from dataclasses import replace
from itertools import product
from pathlib import Path

# Run by its path, it would find neither itself nor the package.
sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from benchmarks import left_out, machine, plot, report, stored
from benchmarks.cases import CASES, TABLE_1, extreme_grid
from benchmarks.guarded import Guarded
from benchmarks.measure import Exact, cell, mesh, race, works
from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.options import SolveOptions

SCHEMES = ("magnus", "helix")
SOLVERS = ("fatrop", "ipopt")
TOLERANCES = (1e-3, 1e-4, 1e-5, 1e-6)
MESHES = (8, 16, 32, 64, 128, 256, 512)
MESHED = ("table 1, 0.73 m", "anisotropic")
RACE_ELEMENTS, RACE_ROUNDS = 50, 15
TIME_LIMIT = 10.0
"""[s] of a cell of the grid; elsewhere the first run builds, which must not count as failing"""


def main():
    stored.FOLDER.mkdir(parents=True, exist_ok=True)
    begin = time.perf_counter()
    facts = machine.facts()
    exact = Exact()

    def say(what):
        print(f"bench: {time.perf_counter() - begin:4.0f} s  {what}", flush=True)

    say("meshes")
    meshed = [case for case in CASES if case.name in MESHED]
    stored.write([mesh(*each, exact) for each in product(meshed, SCHEMES, MESHES)])
    say("fatrop against ipopt")
    races = [race(TABLE_1, scheme, RACE_ELEMENTS, RACE_ROUNDS) for scheme in SCHEMES]
    stored.write(sum(races, []))
    wanted = [
        SolveOptions(tolerance=tolerance, scheme=scheme, solver=solver)
        for tolerance, scheme, solver in product(TOLERANCES, SCHEMES, SOLVERS)
    ]
    rows = []
    for case in CASES:
        say(case.name)
        rows += works(case, wanted, exact)
    stored.write(rows)
    say("what is left out")
    stored.write(left_out.rows())
    say("extreme grid")
    limited = SolveOptions(time_limit=TIME_LIMIT)
    with Guarded(find_equilibrium, 1.5 * TIME_LIMIT, (CASES[0].scene,)) as solve:
        cells = []
        for weight_ratio, length_ratio, scene in extreme_grid():
            solve.ready()
            scene = replace(scene, options=limited)
            cells.append(cell(weight_ratio, length_ratio, scene, solve))
    stored.write(cells)
    say("pictures and report")
    plot.main()
    report.write(facts, exact.uncertainty, time.perf_counter() - begin)


if __name__ == "__main__":
    main()
