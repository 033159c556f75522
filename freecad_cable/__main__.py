# SPDX-License-Identifier: LGPL-2.1-or-later
"""``python -m freecad_cable solve scene.json -o solution.json``: the core without FreeCAD.

Exit status: 0 converged, 2 the scene is wrong, 3 not solved; of several scenes the worst.
"""

import argparse
import json
import sys
from pathlib import Path

from .equilibrium import find_equilibrium
from .errors import ProblemError, SolverMissingError
from .problem.scene_file import read_scene
from .result.solution_file import solution_data

CONVERGED, WRONG_SCENE, NOT_SOLVED = 0, 2, 3


def main(arguments=None) -> int:
    """Exit status of a command line."""
    options = _parser().parse_args(arguments)
    if options.output and len(options.scenes) > 1:
        return _say("-o takes one scene; use --out-dir for several")
    worst = CONVERGED
    for scene in options.scenes:
        worst = max(worst, _solve(scene, _target(options, scene)))
    return worst


def _parser():
    parser = argparse.ArgumentParser(
        prog="freecad_cable", description=__doc__.split(":")[1].strip()
    )
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    solve = commands.add_parser("solve", help="find the equilibrium of scene files")
    solve.add_argument("scenes", nargs="+", type=Path, metavar="SCENE.json")
    solve.add_argument("-o", "--output", type=Path, help="solution file (default: standard output)")
    solve.add_argument("--out-dir", type=Path, help="folder for NAME.solution.json of each scene")
    return parser


def _target(options, scene):
    if options.out_dir:
        return options.out_dir / f"{scene.stem}.solution.json"
    return options.output


def _solve(path: Path, target: Path | None) -> int:
    try:
        solution = find_equilibrium(read_scene(_load(path)))
    except ProblemError as error:
        return _say(f"{path}: {error}")
    except SolverMissingError as error:
        return _say(str(error), NOT_SOLVED)
    text = json.dumps(solution_data(solution), indent=1, ensure_ascii=False)
    try:
        if target is None:
            print(text)
        else:
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(text + "\n", encoding="utf-8")
    except OSError as error:
        return _say(f"{target}: cannot be written: {error.strerror}")
    if solution.status.success:
        return CONVERGED
    return _say(f"{path}: {solution.message}", NOT_SOLVED)


def _load(path: Path):
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise ProblemError("scene", f"cannot be read: {error.strerror}") from error
    except (ValueError, RecursionError) as error:
        raise ProblemError("scene", f"is not JSON: {error}") from error


def _say(message: str, status: int = WRONG_SCENE) -> int:
    print(message, file=sys.stderr)
    return status


if __name__ == "__main__":
    sys.exit(main())
