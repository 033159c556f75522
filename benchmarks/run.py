# SPDX-License-Identifier: LGPL-2.1-or-later
"""Error against run time, peers, extreme scenes, contact: writes rows, pictures and a report into docs/benchmarks/.

Named parts alone are run anew and the others keep their rows; every part stores its rows when it is done.
"""

import sys
import time
from itertools import product
from pathlib import Path

# Run by its path, it would find neither itself nor the package.
sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from benchmarks import (
    among,
    left_out,
    machine,
    plot,
    profile_solve,
    report,
    scaling,
    stored,
    studies,
)
from benchmarks.cases import CASES, TABLE_1
from benchmarks.exact import Exact
from benchmarks.extreme import families, random_scenes
from benchmarks.measure import mesh, race, works
from benchmarks.outcomes import outcomes
from benchmarks.peers import parent
from benchmarks.runs import Run
from freecad_cable.options import SolveOptions

SCHEMES = ("magnus", "helix")
SOLVERS = ("fatrop", "ipopt")
TOLERANCES = (1e-3, 1e-4, 1e-5, 1e-6)
MESHES = (8, 16, 32, 64, 128, 256, 512)
MESHED = ("table 1, 0.73 m", "anisotropic")
RACE_ELEMENTS, RACE_ROUNDS = 50, 15
TRUTHS, RANDOM_TRUTHS = 2, 10
"""Of so many scenes, extreme ones and in contact, and random ones, one is asked for its true error, which takes longer
than solving it."""


def _profile(say, exact):
    yield from profile_solve.rows()


def _meshes(say, exact):
    meshed = [case for case in CASES if case.name in MESHED]
    yield from (mesh(*each, exact) for each in product(meshed, SCHEMES, MESHES))


def _race(say, exact):
    for scheme in SCHEMES:
        yield from race(TABLE_1, scheme, RACE_ELEMENTS, RACE_ROUNDS)


def _work(say, exact):
    wanted = [
        SolveOptions(tolerance=tolerance, scheme=scheme, solver=solver)
        for tolerance, scheme, solver in product(TOLERANCES, SCHEMES, SOLVERS)
    ]
    for case in CASES:
        say(case.name)
        yield from works(case, wanted, exact)


def _scaling(say, exact):
    yield from (scaling.scaling(*each) for each in product(SCHEMES, scaling.ELEMENTS))


def _drag(say, exact):
    yield from map(scaling.drag, TABLE_1)


def _left_out(say, exact):
    yield from left_out.rows()


def _peers(say, exact):
    yield from parent.rows(say)


def _studies(say, exact):
    yield from studies.rows(say)


def _extreme(say, exact):
    yield from outcomes(families(), TRUTHS)
    say("random scenes")
    yield from outcomes(random_scenes(), RANDOM_TRUTHS)


def _contact(say, exact):
    yield from among.outcomes(among.scenes(), TRUTHS)


PARTS = {
    "profile": _profile,
    "meshes": _meshes,
    "race": _race,
    "work": _work,
    "drag": _drag,
    "scaling": _scaling,
    "left-out": _left_out,
    "peers": _peers,
    "extreme": _extreme,
    "contact": _contact,
    "studies": _studies,
}


def main(wanted):
    if unknown := set(wanted) - set(PARTS):
        sys.exit(f"bench: no part {', '.join(unknown)}; there are {', '.join(PARTS)}")
    begin = time.perf_counter()

    def say(what):
        print(f"bench: {time.perf_counter() - begin:4.0f} s  {what}", flush=True)

    for part in wanted or PARTS:
        say(part)
        facts, exact, here = machine.facts(), Exact(), time.perf_counter()
        stored.write(list(PARTS[part](say, exact)))
        seconds = time.perf_counter() - here
        run = Run(part, **facts, seconds=seconds, uncertainty=exact.uncertainty)
        others = [other for other in stored.read(Run) if other.part != part]
        order = list(PARTS)
        stored.write(sorted([*others, run], key=lambda each: order.index(each.part)))
    say("pictures and report")
    plot.main()
    report.write()


if __name__ == "__main__":
    main(sys.argv[1:])
