# SPDX-License-Identifier: LGPL-2.1-or-later
"""The front door of the core: a scene in, its equilibrium out."""

import numpy as np

from .errors import SolverMissingError
from .geometry import rotation
from .problem import Scene
from .problem.reduce import Model, reduce
from .result import (
    Balance,
    Energy,
    Load,
    Solution,
    balance,
    end_violation,
    is_near,
    smallest_bend_radius,
    support_violation,
)
from .status import Status

NO_SLACK = 1e-7
"""Slack, relative to the length, below which an inextensible cable has no finite tension that a
computation could resolve (it grows like 1/slack², `docs/theory.md`)."""

HEAVIEST = 5e6
"""Weight ratio above which no case was ever solved; a wrong unit is likelier than such a cable."""
HELD = 1e-5
"""Violation of an end or a support above which no answer passes; the solver leaves 1e-7 at most."""
UNBALANCED = 0.2
"""Residual of the independent balance check above which no answer passes as one. Splines through the nodes of
good answers stay below 0.1, those of wrong ones reach 1."""


def find_equilibrium(scene: Scene, *, start: Solution | None = None) -> Solution:
    """The stable equilibrium of a scene, to the tolerance of its options.

    ``start``, the solution of a scene that differs little, keeps the branch that the cable is on and is quicker;
    one that differs much is ignored.
    Not finding one is an outcome: see ``Solution.status``. Errors: ``SolverMissingError`` without CasADi.
    """
    model = reduce(scene)
    if (sentence := _without_slack(scene)) is not None:
        return Solution(scene=scene, status=Status.INFEASIBLE, message=sentence)
    try:
        from .solve.search import find
        from .solve.trial import Problem, TimeUpError
    except ImportError as error:
        if error.name and error.name.split(".")[0] != "casadi":
            raise
        raise SolverMissingError(
            "CasADi is not installed, so no cable can be solved; what was solved before can still be seen. "
            "Install it with: python3 -m pip install --no-deps casadi"
        ) from error
    problem = Problem.of(scene, model)
    if problem.scaling.weight_ratio > HEAVIEST:
        message = (
            f"{Status.NOT_CONVERGED.value} Its weight against its bending stiffness, w L³/EI, is "
            f"{problem.scaling.weight_ratio:.0e}, and {HEAVIEST:.0e} is the most that this version can solve: check "
            "mass, stiffness and length for a wrong unit."
        )
        return Solution(scene=scene, status=Status.NOT_CONVERGED, message=message)
    try:
        trial = find(problem, None if start is None else _nodes(start, problem))
    except TimeUpError:
        message = f"{Status.TIME_LIMIT.value} It is {scene.options.time_limit:g} s."
        return Solution(scene=scene, status=Status.TIME_LIMIT, message=message)
    if trial is None:
        return Solution(
            scene=scene,
            status=Status.NOT_CONVERGED,
            message=f"{Status.NOT_CONVERGED.value} {_advice(scene)}",
            solver=_effort(problem, None),
        )
    return _solution(problem, trial, model)


def _without_slack(scene):
    rod = scene.rod
    if rod.axial_stiffness is not None:
        return None
    if not scene.spans:
        return None
    slack = 1 - scene.chord / rod.length
    if slack >= NO_SLACK:
        return None
    return (
        f"cable.length: is {rod.length:.9g} m and the ends are {scene.chord:.9g} m apart, which leaves no "
        f"slack; an inextensible cable needs at least {scene.chord * (1 + 1e-5):.9g} m, or give it an axial stiffness"
    )


def _advice(scene):
    if scene.spans:
        ratio = scene.rod.length / max(scene.chord, 1e-12)
        if ratio < 1.001:
            return (
                f"Its length is only {100 * (ratio - 1):.3g} % above the chord; give it more slack."
            )
    return "Check lengths, stiffness and mass for a wrong unit; a different length may be easier."


def _nodes(solution, problem):
    """The nodes of an earlier solution, without units, as a start for this one; None if it is too far."""
    from .transcription.shape import Joint, Shape

    scene, scaling = problem.scene, problem.scaling
    if solution.position is None or not is_near(solution, scene):
        return None
    span = solution.arc_length[-1]
    frames = rotation.matrix(solution.quaternion)

    def strain(curvature):
        return np.concatenate([curvature * span, np.zeros_like(curvature)], axis=-1)

    joints = []
    for node, load in zip(solution.support_nodes, solution.support_reactions, strict=True):
        moment = frames[node].T @ (solution.moment[node] - load.moment)
        beyond = scene.rod.natural_curvature + moment / scene.rod.stiffness
        force, turning = load.force / scaling.force, load.moment / scaling.energy
        joints.append(Joint(node, strain(beyond), force, turning))
    return Shape(
        _arc_lengths(solution, scene),
        scaling.point(solution.position),
        rotation.continuous(solution.quaternion),
        strain(solution.curvature),
        solution.force / scaling.force,
        solution.moment / scaling.energy,
        tuple(joints),
    )


def _arc_lengths(solution, scene):
    """Those of the nodes of an earlier solution, relative to the length, with those of the supports where they are
    given now."""
    before = solution.arc_length / solution.arc_length[-1]
    given = [
        (before[node], support.arc_length / scene.rod.length)
        for node, support in zip(solution.support_nodes, scene.supports, strict=True)
        if not support.slides
    ]
    return np.interp(before, *np.transpose([(0.0, 0.0), *given, (1.0, 1.0)]))


def _solution(problem, trial, model: Model) -> Solution:
    scene, scaling, shape = problem.scene, problem.scaling, trial.shape
    rod, length = scene.rod, scaling.length
    arc_length = shape.arc_length * length
    position = scaling.origin + shape.position * length
    force, moment = shape.force * scaling.force, shape.moment * scaling.energy
    curvature = shape.strain[:, :3] / length
    check = _balance(rod, scene.weight, scaling, shape)
    nodes = tuple(joint.node for joint in shape.joints)
    violation = max(
        end_violation(scene, position, shape.quaternion),
        support_violation(scene, nodes, arc_length, position, shape.quaternion),
    )
    status, message = _verdict(scene, trial, check, violation)
    return Solution(
        scene=scene,
        status=status,
        message=message,
        arc_length=arc_length,
        position=position,
        quaternion=shape.quaternion,
        force=force,
        moment=moment,
        curvature=curvature,
        energy=_energy(problem, trial),
        start_reaction=Load(-force[0], -moment[0]),
        end_reaction=Load(force[-1], moment[-1]),
        support_reactions=tuple(
            Load(joint.force * scaling.force, joint.moment * scaling.energy)
            for joint in shape.joints
        ),
        support_nodes=nodes,
        min_bend_radius=min(
            smallest_bend_radius(part.arc_length * length, part.strain[:, :3] / length)
            for part in shape.parts()
        ),
        stable=trial.stable,
        position_error=trial.error * length,
        balance=check,
        left_out=model.left_out,
        kept=model.kept,
        solver=_effort(problem, trial),
    )


def _balance(rod, weight, scaling, shape):
    """The worst of the stretches between supports."""
    found = [
        balance(
            rod,
            weight,
            part.arc_length * scaling.length,
            scaling.origin + part.position * scaling.length,
            part.quaternion,
            part.force * scaling.force,
        )
        for part in shape.parts()
    ]
    return Balance(max(b.moment for b in found), max(b.force for b in found))


def _energy(problem, trial):
    """In joules. The program measures gravity from its origin, which is the start unless that is free."""
    scaling = problem.scaling
    bending, torsion, stretch, gravity = (float(e) for e in trial.energies * scaling.energy)
    weight = problem.scene.weight * scaling.length
    gravity += float(weight @ trial.shape.position[0]) * scaling.length
    return Energy(bending, torsion, stretch, gravity)


def _verdict(scene, trial, check, violation):
    if trial.slipped:
        place = scene.supports[trial.slipped[0]].place
        return Status.NOT_CONVERGED, (
            f"{Status.NOT_CONVERGED.value} The cable slides through {place} until nothing is left on one side of it; "
            "give that support an arc length, or hold the cable elsewhere."
        )
    if not trial.stable:
        return Status.UNSTABLE, Status.UNSTABLE.value
    if violation > HELD:
        return (
            Status.NOT_CONVERGED,
            f"{Status.NOT_CONVERGED.value} The shape it ended with is not held as its ends and supports say.",
        )
    # Where a cable is formed its moments do not follow from its curvature, which is all that the check knows.
    if not trial.nlp.structure.bend_limit and max(check.moment, check.force) > UNBALANCED:
        return Status.INACCURATE, (
            f"{Status.INACCURATE.value} Recomputed from its nodes, its moments are out of balance by "
            f"{max(check.moment, check.force):.0%}."
        )
    tolerance = scene.options.tolerance
    if trial.error <= tolerance:
        return Status.CONVERGED, Status.CONVERGED.value
    shortfall = f"The position error is estimated at {trial.error:.2g} of the length; {tolerance:g} was asked for"
    if scene.options.elements is not None:
        # Who chooses the mesh chooses the accuracy; the estimate says which.
        return Status.CONVERGED, f"{Status.CONVERGED.value} {shortfall}, with elements fixed."
    return (
        Status.INACCURATE,
        f"{Status.INACCURATE.value} {shortfall}, and neither mesh nor time allowed more.",
    )


def _effort(problem, trial):
    return {
        "name": None if trial is None else trial.raw.solver,
        "scheme": problem.scheme,
        "elements": None if trial is None else len(trial.shape.steps),
        "iterations": problem.iterations,
        "build_time": problem.build_time,
        "solve_time": problem.solve_time,
    }
