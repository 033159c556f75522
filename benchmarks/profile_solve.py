# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a solve spends its time: `python -m benchmarks.profile_solve` prints the table.

Functions of the solver are clocked as they call one another, each without what it calls, so that the parts sum up to
the whole. What happens inside fatrop it says itself.
"""

import time
from collections import Counter
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from functools import wraps
from unittest.mock import patch

from benchmarks.cases import CASES, moved, seed_paper
from freecad_cable.equilibrium import answer, find, find_equilibrium
from freecad_cable.options import SolveOptions
from freecad_cable.problem import Scene
from freecad_cable.result import Solution
from freecad_cable.solve import backend, mesh, own, problem, search, stability, strong_form
from freecad_cable.transcription import layout

REPEATS = 40

EVALUATION = "fatrop: evaluating energy, rows and derivatives"
DIRECTION = "fatrop: its own linear algebra"
ITERATION = "fatrop: the rest of its iterations"
AROUND = "CasADi around fatrop"
CROSSING = "between Python and CasADi"
REST = "everything else"
FATROP = (EVALUATION, DIRECTION, ITERATION)
"""What no other way to call fatrop on this program would save."""

CLOCKED = (
    ("the scene made ready", find, "_problem"),
    ("the start", search, "guess"),
    ("the start", layout, "variables"),
    ("the start", layout, "multipliers"),
    ("the start", find, "nodes"),
    ("the start", problem, "pack"),
    ("mesh", mesh, "uniform"),
    ("mesh", mesh, "refined"),
    (CROSSING, backend, "minimise"),
    ("reading the nodes", layout, "shape_of"),
    ("error estimate", strong_form, "correction"),
    ("stability", stability.SecondVariation, "__init__"),
    ("stability", stability, "proven"),
    ("stability", stability.SecondVariation, "lowest_mode"),
    ("the answer", find, "solution"),
    ("the answer: balance check", answer, "balanced"),
    ("the answer: bend radius", answer, "smallest_bend_radius"),
    ("cable through itself", own, "self_penetrations"),
)
"""(part, where the name is looked up, name); a part may have several."""


@dataclass(frozen=True)
class Part:
    """The time of one part of one solve, the quickest of some repeats, solvers built."""

    solve: str
    part: str
    seconds: float


def rows(repeats=REPEATS) -> list[Part]:
    """The parts of some solves, in the order of ``PARTS``."""
    paper, heavy = seed_paper(0.73), next(c.scene for c in CASES if c.name == "very heavy")
    fine = Scene(**(vars(paper) | {"options": SolveOptions(tolerance=1e-6)}))
    solves = {
        "Table 1, cold, 1e-4": (paper, None),
        "Table 1, warm drag step, 1e-4": (moved(paper), find_equilibrium(paper)),
        "Table 1, cold, 1e-6": (fine, None),
        "very heavy, cold, 1e-4": (heavy, None),
    }
    return [
        Part(name, part, seconds)
        for name, (scene, start) in solves.items()
        for part, seconds in _quickest(scene, start, repeats).items()
    ]


PARTS = tuple(
    dict.fromkeys((EVALUATION, DIRECTION, ITERATION, AROUND, *(c[0] for c in CLOCKED), REST))
)


def _quickest(scene: Scene, start: Solution | None, repeats) -> dict[str, float]:
    find_equilibrium(scene, start=start)  # builds
    runs = [_parts(scene, start) for _ in range(repeats)]
    return min(runs, key=lambda parts: sum(parts.values()))


def _parts(scene, start):
    """Part → seconds of one solve."""
    spent, inside = Counter(dict.fromkeys(PARTS, 0.0)), []

    def clocked(part, function):
        @wraps(function)
        def timed(*arguments, **named):
            inside.append(0.0)
            begin = time.perf_counter()
            try:
                return function(*arguments, **named)
            finally:
                whole = time.perf_counter() - begin
                spent[part] += whole - inside.pop()
                if inside:
                    inside[-1] += whole

        return timed

    with ExitStack() as stack:
        stack.enter_context(_heard(spent))
        for part, place, name in CLOCKED:
            stack.enter_context(patch.object(place, name, clocked(part, getattr(place, name))))
        clocked(REST, find_equilibrium)(scene, start=start)
    # What fatrop says of itself was spent between Python and CasADi, as this file's clocks see it.
    spent[CROSSING] -= sum(spent[part] for part in (*FATROP, AROUND))
    return {part: spent[part] for part in PARTS}


@contextmanager
def _heard(spent):
    """Solvers that add what they say of their last call to ``spent`` when they are asked for it."""

    class Heard:
        def __init__(self, solver):
            self.solver = solver

        def __call__(self, **inputs):
            # Evaluations are summed over all calls of a solver.
            self.before, begin = _evaluation(self.solver.stats()), time.perf_counter()
            answer = self.solver(**inputs)
            self.whole = time.perf_counter() - begin
            return answer

        def stats(self):
            said = self.solver.stats()
            evaluation = _evaluation(said) - self.before
            own = said["fatrop"]["time_total"]
            direction = said["fatrop"]["compute_sd_time"]
            spent[EVALUATION] += evaluation
            spent[DIRECTION] += direction
            spent[ITERATION] += own - evaluation - direction
            spent[AROUND] += self.whole - own
            return said

    built = backend.built
    with patch.object(backend, "built", lambda *key: Heard(built(*key))):
        yield


def _evaluation(said):
    """Seconds of evaluations in what a solver says."""
    return sum(said[name] for name in said if name.startswith("t_wall_nlp_"))


def table(parts: list[Part]) -> str:
    """Milliseconds, a column for each solve, the sum, and how far it is from what fatrop needs."""
    solves = list(dict.fromkeys(row.solve for row in parts))
    # Those that are stored: the solver may have others by now.
    names = list(dict.fromkeys(row.part for row in parts))
    at = {(row.solve, row.part): 1e3 * row.seconds for row in parts}
    lines = [("[ms]", *solves), ("---", *("---:" for _ in solves))]
    lines += [(part, *(f"{at[solve, part]:.2f}" for solve in solves)) for part in names]
    wholes = [sum(at[solve, part] for part in names) for solve in solves]
    needs = [sum(at[solve, part] for part in FATROP) for solve in solves]
    lines.append(("**whole**", *(f"{whole:.2f}" for whole in wholes)))
    ratios = [f"{whole / need:.1f}" for whole, need in zip(wholes, needs, strict=True)]
    lines.append(("whole over what fatrop itself needs", *ratios))
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


if __name__ == "__main__":
    print(table(rows()))
