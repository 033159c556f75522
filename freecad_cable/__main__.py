# SPDX-License-Identifier: LGPL-2.1-or-later
"""``python -m freecad_cable solve scene.json -o solution.json``: the core without FreeCAD.
``python -m freecad_cable study study.json -o rows.csv``: one property of a scene over a range, or a tolerance.

Exit status: 0 converged, 2 the scene or the study is wrong, 3 not solved; of several scenes, values or cases the worst.
130 stopped by Ctrl-C; the rows of a study until then are written.
"""

import argparse
import json
import sys
from pathlib import Path

from .equilibrium import find_equilibrium
from .errors import ProblemError, SolverMissingError, StoppedError
from .problem.scene_file import read_scene
from .result.solution_file import solution_data
from .study import stopping
from .study.program import rows_and_summary
from .study.rows_file import as_csv, as_json
from .study.study_file import read_study

CONVERGED, WRONG_SCENE, NOT_SOLVED = 0, 2, 3
STOPPED = 130
"""As shells have it: 128 and the number of the signal."""


def main(arguments=None) -> int:
    """Exit status of a command line."""
    options = _parser().parse_args(arguments)
    with stopping.waiting():
        if options.command == "study":
            return _study(options.study, options.output, options.processes)
        return _scenes(options)


def _parser():
    parser = argparse.ArgumentParser(
        prog="freecad_cable", description="The core of the Cable workbench, without FreeCAD."
    )
    commands = parser.add_subparsers(required=True, metavar="COMMAND", dest="command")
    solve = commands.add_parser("solve", help="find the equilibrium of scene files")
    solve.add_argument("scenes", nargs="+", type=Path, metavar="SCENE.json")
    solve.add_argument("-o", "--output", type=Path, help="solution file (default: standard output)")
    solve.add_argument("--out-dir", type=Path, help="folder for NAME.solution.json of each scene")
    study = commands.add_parser("study", help="solve one property over a range, or a tolerance")
    study.add_argument("study", type=Path, metavar="STUDY.json")
    study.add_argument(
        "-o", "--output", type=Path, help="rows as .csv or .json (default: CSV to standard output)"
    )
    study.add_argument(
        "--processes", type=_count, default=1, help="for the cases of a tolerance (default: 1)"
    )
    return parser


def _count(text):
    if not text.isdecimal() or not 1 <= int(text) <= 1024:
        raise argparse.ArgumentTypeError(f"{text} is no whole number from 1 to 1024")
    return int(text)


def _scenes(options) -> int:
    if options.output and len(options.scenes) > 1:
        return _say("-o takes one scene; use --out-dir for several")
    worst = CONVERGED
    for scene in options.scenes:
        try:
            worst = max(worst, _solve(scene, _target(options, scene)))
        except StoppedError:
            return _say(f"{scene}: stopped before it was solved", STOPPED)
    return worst


def _target(options, scene):
    if options.out_dir:
        return options.out_dir / f"{scene.stem}.solution.json"
    return options.output


def _solve(path: Path, target: Path | None) -> int:
    try:
        solution = find_equilibrium(read_scene(_load(path)), watch=stopping.watch)
    except ProblemError as error:
        return _say(f"{path}: {error}")
    except SolverMissingError as error:
        return _say(str(error), NOT_SOLVED)
    text = json.dumps(solution_data(solution), indent=1, ensure_ascii=False) + "\n"
    if not _written(text, target):
        return WRONG_SCENE
    if solution.status.success:
        if solution.bends_too_sharply:
            radius, place = solution.min_bend_radius
            limit = solution.scene.rod.min_bend_radius
            return _say(
                f"{path}: warning: it bends to {radius:.4g} m at {place:.4g} m; cable.min_bend_radius is {limit:.4g} m",
                CONVERGED,
            )
        return CONVERGED
    return _say(f"{path}: {solution.message}", NOT_SOLVED)


def _study(path: Path, target: Path | None, processes: int) -> int:
    try:
        if target is not None and target.suffix not in (".csv", ".json"):
            raise ProblemError("--output", f"is {target}; it must end with .csv or .json")
        study = read_study(_load(path, "study"), lambda name: _load(path.parent / name))
        rows, summary = rows_and_summary(study, processes, _say)
    except ProblemError as error:
        return _say(f"{path}: {error}")
    except SolverMissingError as error:
        return _say(str(error), NOT_SOLVED)
    stopped = stopping.pressed()
    if stopped and not rows:
        return _say(f"{path}: stopped before the first row; nothing is written", STOPPED)
    if target is not None and target.suffix == ".json":
        text = as_json(study.names, rows, summary)
    else:
        text = as_csv(study.names, rows)
    if not _written(text, target):
        return WRONG_SCENE
    if stopped:
        return _say(f"{path}: stopped; {len(rows)} of {study.count} rows are written", STOPPED)
    unsolved = sum(not row.solved for row in rows)
    if unsolved:
        return _say(
            f"{path}: {unsolved} of {len(rows)} are not solved; the rows say why", NOT_SOLVED
        )
    return CONVERGED


def _written(text, target) -> bool:
    try:
        if target is None:
            sys.stdout.write(text)
        else:
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(text, encoding="utf-8")
    except OSError as error:
        _say(f"{target}: cannot be written: {error.strerror}")
        return False
    return True


def _load(path: Path, what="scene"):
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise ProblemError(what, f"cannot be read: {error.strerror}") from error
    except (ValueError, RecursionError) as error:
        raise ProblemError(what, f"is not JSON: {error}") from error


def _say(message: str, status: int = WRONG_SCENE) -> int:
    print(message, file=sys.stderr)
    return status


if __name__ == "__main__":
    sys.exit(main())
