# SPDX-License-Identifier: LGPL-2.1-or-later
"""A study from its file to its rows and its summary, as the command line runs it."""

import math
from collections.abc import Callable
from contextlib import nullcontext, suppress
from dataclasses import asdict
from functools import partial

from ..equilibrium import find_equilibrium
from ..errors import ProblemError, StoppedError
from .cases import Verdict, run
from .motion import motion, needed_length
from .path import follow
from .row import Row
from .stopping import watch, workers
from .study_file import PathStudy, ToleranceStudy


def rows_and_summary(
    study: PathStudy | ToleranceStudy, processes: int, say: Callable[[str], None]
) -> tuple[list[Row], dict]:
    """``say`` is told how far it is. Inside ``stopping.waiting``, Ctrl-C ends it with the rows that there are. Errors:
    ``ProblemError``, ``SolverMissingError``."""
    if isinstance(study, ToleranceStudy):
        return _tolerance(study, processes, say)
    solve = partial(find_equilibrium, watch=watch)
    steps, needed = [], {}
    with suppress(StoppedError):
        for step in follow(study.scene_at, study.values, precision=study.precision, solve=solve):
            steps.append(step)
            say(f"{len(steps)}/{study.count} {study.names[0]} = {step.value:.6g}{_said(step)}")
            watch()
        if study.needed_length:
            say("the length that all values need")
            needed = {"needed_length": _needed(study, solve, say)}
    summary = asdict(motion(steps)) if any(step.solved for step in steps) else {}
    return [step.row for step in steps], _finite(summary | needed)


def _needed(study, solve, say):
    try:
        found = needed_length(study.scene_at, study.values, solve=solve)
    except ProblemError as error:
        say(f"no length will do everywhere: {error}")
        return None
    return asdict(found) | {"feasible": found.feasible}


def _said(step):
    row = step.row
    return f". {row.note}" * bool(row.note) + f". {row.error}" * bool(row.error)


def _tolerance(study, processes, say):
    rows, count = [], study.count
    every = max(1, count // 100)
    with suppress(StoppedError), workers(processes) if processes > 1 else nullcontext() as executor:
        for row in run(study.scene, study.cases, executor=executor, watch=watch):
            rows.append(row)
            if len(rows) % every == 0 or len(rows) == count:
                say(f"{len(rows)}/{count} cases, {sum(r.holds for r in rows)} hold")
            watch()
    if not rows:
        return rows, {}
    verdict = Verdict.of(rows)
    summary = asdict(verdict) | {"share": verdict.share}
    if study.cases.seed is not None:
        summary["share_between"] = verdict.between
    return rows, summary


def _finite(value):
    """Null for what JSON cannot say."""
    if isinstance(value, dict):
        return {key: _finite(item) for key, item in value.items()}
    if isinstance(value, (tuple, list)):
        return [_finite(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
