# SPDX-License-Identifier: LGPL-2.1-or-later
"""The front door of the core: a scene in, its equilibrium out."""

import sys
import threading
from collections.abc import Callable
from functools import partial

from ..errors import ProblemError, SolverMissingError
from ..problem import Mesh, Scene
from ..problem.reach import stations
from ..problem.reduce import reduce, tautness
from ..result import Solution, is_near
from ..status import Status
from . import stretches
from .answer import effort, solution
from .earlier import by_steps, follows, nodes, pull
from .length_design import shortest

NO_SLACK = 1e-7
"""Slack, relative to the length, below which an inextensible cable has no finite tension that a
computation could resolve (it grows like 1/slack², `docs/theory.md`)."""

ENTERED = 0.02
"""Depth in an obstacle, in radii, from which an earlier solution is one that was let through the rim of a ring."""

A_STEP = 0.01
"""Change up to which a scene is one step of a drag from an earlier one (see ``is_near``)."""

ONE_AT_A_TIME = threading.RLock()
"""CasADi's functions are not safe in threads (two that solved at once crashed Python), so of those of one process one
solves; to use more of a machine takes processes."""


INSTALL = f"python{sys.version_info.major}.{sys.version_info.minor} -m pip install --no-deps"
"""With this Python, whose modules CasADi has to fit; without its NumPy, which would shadow the one that is there."""


def find_equilibrium(
    scene: Scene,
    *,
    start: Solution | None = None,
    watch: Callable[[str], None] | None = None,
    apart: bool = True,
) -> Solution:
    """The stable equilibrium of a scene, to the tolerance of its options.

    ``start``, the solution of a scene that differs little, keeps the branch that the cable is on and is quicker;
    one that differs much is ignored. Where the scene asks for its length, that is found too.
    ``watch`` is called before each run of a solver, with what is about to be done; what it raises ends the search
    (``StoppedError`` is there for that). ``apart``: whether a cable that would run through itself is brought apart from
    itself, which takes a hundred times longer; if not, that is its status.
    Not finding one is an outcome: see ``Solution.status``. Errors: ``SolverMissingError`` without CasADi. May be called
    from several threads, which wait for each other.
    """
    with ONE_AT_A_TIME:
        return _found(scene, start, watch, apart)


def _found(scene, start, watch, apart):
    solve = partial(find_equilibrium, watch=watch, apart=apart)
    if scene.asks_length:
        # A length at which a cable loops through itself is none to design.
        return shortest(scene, partial(solve, apart=False))
    if stretches.cuts(scene):
        found = stretches.solved(scene, solve, start)
        if not stretches.touch(found):
            return found
    return _in_one_piece(scene, start, watch, apart)


def _in_one_piece(scene, start, watch, apart, before=None):
    """``before``: the problem that was followed to no answer."""
    problem = _problem(scene, watch, pull(start))
    if isinstance(problem, Solution):
        return problem
    problem.parts = apart
    if before is not None:
        problem.anew, problem.deadline = True, before.deadline
    if start is not None and _entered(start, scene) and is_near(start, scene, A_STEP):
        # What was not to be found beside the rims of rings is not looked for at each step of a drag.
        problem.surroundings = problem.surroundings.without_rims()
    from ..solve.effects import find
    from ..solve.passing import passed_through
    from ..solve.problem import TimeUpError
    from ..solve.refining import finer

    follows(problem, start)
    warm = nodes(start, problem)
    try:
        trial = find(problem, warm, lambda: by_steps(problem, start))
    except TimeUpError:
        message = f"{Status.TIME_LIMIT.value} It is {scene.options.time_limit:g} s."
        return Solution(scene=scene, status=Status.TIME_LIMIT, message=message)
    if trial is None:
        return Solution(
            scene=scene,
            status=Status.NOT_CONVERGED,
            message=f"{Status.NOT_CONVERGED.value} {_advice(scene)}",
            solver=effort(problem, None),
        )
    found = solution(problem, trial)
    if trial.error <= scene.options.tolerance and not found.status.success:
        # The checks put splines through the nodes, and may need more of these than the answer.
        better = finer(problem, trial)
        if not passed_through(problem, trial.shape, better.shape):
            trial = better
            found = solution(problem, trial)
    if start is not None and not found.status.success:
        # From there it may have come to a place from which there is no way on.
        other = _in_one_piece(scene, None, watch, apart, None if warm is None else problem)
        return other if other.status.success else found
    return found


def _entered(start, scene):
    return (start.min_clearance or 0.0) < -ENTERED * scene.rod.radius


def find_equilibria(scene: Scene) -> list[Solution]:
    """The stable equilibria of a scene that many starts lead to, lowest energy first; the first is not always the one
    that ``find_equilibrium`` gives, nor the one that a cable is in. Empty if none is found in the time limit. Errors:
    ``ProblemError`` if the length is asked for or clamps cut the cable in stretches, ``SolverMissingError``."""
    if scene.asks_length or stretches.cuts(scene):
        raise ProblemError(
            "scene", "has no one set of equilibria; give a length, and ask for each stretch alone"
        )
    with ONE_AT_A_TIME:
        problem = _problem(scene)
        if isinstance(problem, Solution):
            return []
        from ..solve.branches import find_all

        return [solution(problem, trial) for trial in find_all(problem)]


def _problem(scene, watch=None, pull=0.0):
    """The ``Problem`` of a scene, in which forces may be as large as ``pull`` [N], or the ``Solution`` that says why it
    is none. Enters the rooms that need CasADi."""
    model = reduce(scene)
    if (sentence := _without_slack(scene)) is not None:
        return Solution(scene=scene, status=Status.INFEASIBLE, message=sentence)
    try:
        from ..solve.problem import Problem
    except ImportError as error:
        if error.name and error.name.split(".")[0] != "casadi":
            raise
        raise SolverMissingError(
            "CasADi is not installed, so no cable can be solved; what was solved before can still be seen. "
            f"Install it with: {INSTALL} casadi"
        ) from error
    return Problem.of(scene, model, watch, pull)


def _without_slack(scene):
    """A sentence if an inextensible cable has no slack somewhere."""
    if scene.rod.axial_stiffness is not None or 1 - tautness(scene) >= NO_SLACK:
        return None
    if scene.spans and not scene.supports:
        return (
            f"cable.length: is {scene.rod.length:.9g} m and the ends are {scene.chord:.9g} m apart, which leaves no "
            f"slack; an inextensible cable needs at least {scene.chord * (1 + 1e-5):.9g} m, or give it an axial "
            "stiffness"
        )
    return (
        "supports: the way through them leaves no slack between two of them; an inextensible cable needs some, or "
        "give it an axial stiffness"
    )


def _advice(scene):
    if scene.spans:
        ratio = scene.rod.length / max(scene.chord, 1e-12)
        if ratio < 1.001:
            return (
                f"Its length is only {100 * (ratio - 1):.3g} % above the chord; give it more slack."
            )
    if scene.obstacles:
        return _advice_among(scene)
    return "Check lengths, stiffness and mass for a wrong unit; a different length may be easier."


def _advice_among(scene):
    for held in stations(scene):
        for obstacle in scene.obstacles:
            depth = -float(obstacle.nearest(held.position[None]).distance[0])
            if depth > scene.rod.radius:
                return (
                    f"{held.place} holds the cable {depth:.3g} m inside {obstacle.place}: hold it outside, or leave "
                    "that obstacle out."
                )
    for obstacle in scene.obstacles:
        if isinstance(obstacle, Mesh) and not obstacle.closed:
            return (
                f"{obstacle.place} is an open mesh, so all that is behind its front is inside: close it if it is a "
                "solid, or leave it out."
            )
    return (
        "It may be too short to get past the obstacles, or have no way between them: try it longer, or with some of "
        "them left out."
    )
