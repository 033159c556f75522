# SPDX-License-Identifier: LGPL-2.1-or-later
"""A study from its file to its rows and its summary, as the command line runs it."""

import math
import multiprocessing
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict

from .cases import Verdict, run
from .motion import motion, needed_length
from .path import follow
from .row import Row
from .study_file import PathStudy, ToleranceStudy


def rows_and_summary(
    study: PathStudy | ToleranceStudy, processes: int, say: Callable[[str], None]
) -> tuple[list[Row], dict]:
    """``say`` is told how far it is. Errors: ``ProblemError``, ``SolverMissingError``."""
    if isinstance(study, ToleranceStudy):
        return _tolerance(study, processes, say)
    steps = []
    for step in follow(study.scene_at, study.values, precision=study.precision):
        steps.append(step)
        say(f"{len(steps)}/{len(study.values)} {study.names[0]} = {step.value:.6g}{_said(step)}")
    summary = {}
    if any(step.solved for step in steps):
        summary = asdict(motion(steps))
    if study.needed_length:
        say("the length that all values need")
        summary["needed_length"] = asdict(needed_length(study.scene_at, study.values))
    return [step.row for step in steps], _finite(summary)


def _said(step):
    row = step.row
    return f". {row.note}" * bool(row.note) + f". {row.error}" * bool(row.error)


def _tolerance(study, processes, say):
    rows, count = [], study.cases.count
    every = max(1, count // 100)
    executor = None
    if processes > 1:
        # A fresh interpreter each: a copy of one that has threads may stand still.
        context = multiprocessing.get_context("spawn")
        executor = ProcessPoolExecutor(processes, mp_context=context)
    try:
        for row in run(study.scene, study.cases, executor=executor):
            rows.append(row)
            if len(rows) % every == 0 or len(rows) == count:
                say(f"{len(rows)}/{count} cases, {sum(r.holds for r in rows)} hold")
    finally:
        if executor is not None:
            executor.shutdown(cancel_futures=True)
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
