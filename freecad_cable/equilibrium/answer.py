# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a converged trial says, in SI units, and whether it may pass as an answer."""

import numpy as np

from ..geometry.runs import runs
from ..problem import Tube
from ..result import (
    Energy,
    Formed,
    Load,
    Solution,
    end_violation,
    smallest_bend_radius,
    support_violation,
)
from ..status import Status
from .pushes import balanced, contacts_of

HELD = 1e-5
"""Violation of an end or a support above which no answer passes; the solver leaves 1e-7 at most."""
UNBALANCED = 0.2
"""Residual of the independent balance check above which no answer passes as one. Splines through the nodes of
good answers stay below 0.1, those of wrong ones reach 1."""


def solution(problem, trial) -> Solution:
    """The solution of a ``Problem`` from its ``Trial``."""
    scene, scaling, shape = problem.scene, problem.scaling, trial.shape
    model = problem.model
    length = scaling.length
    arc_length = shape.arc_length * length
    position = scaling.origin + shape.position * length
    force, moment = shape.force * scaling.force, shape.moment * scaling.energy
    curvature = shape.strain[:, :3] / length
    pushes = trial.with_itself.on_nodes(len(arc_length)) * scaling.force
    check = balanced(problem, trial, pushes)
    nodes = tuple(joint.node for joint in shape.joints)
    contacts = contacts_of(problem, trial) if trial.touches else ()
    formed = _formed(problem, trial) if trial.nlp.structure.bend_limit else ()
    violation = max(
        end_violation(scene, position, shape.quaternion),
        support_violation(scene, nodes, arc_length, position, shape.quaternion),
    )
    status, message = _verdict(problem, trial, None if formed else check, violation)
    if status.success and (sentence := _through_itself(problem, shape)):
        status, message = Status.INACCURATE, f"{Status.INACCURATE.value} {sentence}"
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
        start_reaction=Load(-force[0] - pushes[0], -moment[0]),
        end_reaction=Load(force[-1] - pushes[-1], moment[-1]),
        support_reactions=tuple(
            Load(joint.force * scaling.force - pushes[joint.node], joint.moment * scaling.energy)
            for joint in shape.joints
        ),
        support_nodes=nodes,
        min_bend_radius=min(
            smallest_bend_radius(
                part.arc_length * length,
                part.strain[:, :3] / length,
                kinked=bool(formed),
            )
            for part in shape.parts()
        ),
        formed=formed,
        contacts=contacts,
        min_clearance=_clearance(problem, shape),
        anew=problem.anew,
        stable=trial.stable,
        position_error=trial.error * length,
        balance=check,
        left_out=(
            *model.left_out,
            *_obstacles_left_out(problem, trial),
            *_pushes_left_out(scene, contacts),
            *_rims_left_out(problem, shape),
            *_idle_supports(scene, shape),
        ),
        kept=(*model.kept, *(["obstacles"] if trial.touches else [])),
        solver=effort(problem, trial),
    )


def _through_itself(problem, shape) -> str | None:
    """A sentence if the cable runs through itself, as a shape has it from which no way out was found."""
    found = problem.own.depths(shape)
    if not found:
        return None
    depth, here, there = problem.scaling.length * np.array(found[0])
    return (
        f"The cable runs through itself at {here:.3g} m and {there:.3g} m, {depth:.2g} m deep, and no equilibrium was "
        "found in which it does not; change its length or what holds it."
    )


AT_LIMIT = 1e-4
"""How near to the largest curvature, relative to it, a node is taken to be held there: the solvers stop so near."""


def _formed(problem, trial):
    """Runs of nodes whose curvature is held at the limit."""
    shape, scaling, rod = trial.shape, problem.scaling, problem.scene.rod
    moment = np.einsum("kij,ki->kj", trial.frames, shape.moment) * scaling.energy
    strain = shape.strain[:, :2] / scaling.length - rod.natural_curvature[:2]
    missing = np.linalg.norm(moment[:, :2] - rod.bending_stiffness * strain, axis=1)
    bend = np.linalg.norm(shape.strain[:, :2], axis=1) / scaling.length
    there = bend * rod.min_bend_radius > 1 - AT_LIMIT
    s = shape.arc_length * scaling.length
    return tuple(
        Formed(float(s[a]), float(s[b - 1]), float(missing[a:b].max())) for a, b in runs(there)
    )


def _clearance(problem, shape):
    if not problem.surroundings.obstacles:
        return None
    strict = problem.surroundings.strict
    smallest = strict.clearance(shape)
    if np.isinf(smallest):
        smallest = strict.bare.clearance(shape)
    return smallest * problem.scaling.length


def _obstacles_left_out(problem, trial):
    """Sentences about obstacles that the model did not need."""
    all_of_them, near = len(problem.scene.obstacles), len(problem.surroundings.obstacles)
    if near == 0 < all_of_them:
        yield f"obstacles: all {all_of_them} are out of reach of a cable of this length (exact)"
    elif all_of_them > near:
        yield (
            f"obstacles: {all_of_them - near} of {all_of_them} are out of reach of a cable of this length (exact)"
        )
    if near and not trial.touches and not problem.surroundings.strict.deepest(trial.shape):
        yield "obstacles in reach: the cable keeps clear of them by itself (exact)"


def _rims_left_out(problem, shape):
    """What was not to be kept beside rings."""
    if problem.surroundings.rims:
        return
    depth = problem.surroundings.strict.deepest(shape) * problem.scaling.length
    if depth > 0:
        yield (
            "rims of rings: no equilibrium was found that keeps clear of them; the cable passes one at an angle and is "
            f"{depth:.2g} m nearer to it than its radius allows"
        )


def _pushes_left_out(scene, contacts):
    """What the cable exerts on other cables: they stay where they were."""
    for index in sorted({c.obstacle for c in contacts if c.obstacle is not None}):
        if isinstance(scene.obstacles[index], Tube):
            force = max(np.linalg.norm(c.force) for c in contacts if c.obstacle == index)
            yield (
                f"{scene.obstacles[index].place}: a cable, which is taken as rigid: pushed with up to {force:.2g} N "
                "at a place, and that does not move it"
            )


IDLE = 1e-6
"""Load of a support, in the program's units, below which it does nothing: the solvers leave 1e-9."""


def _idle_supports(scene, shape):
    for support, joint in zip(scene.supports, shape.joints, strict=True):
        if max(np.abs(joint.force).max(), np.abs(joint.moment).max()) < IDLE:
            yield f"{support.place}: it does not act, the cable would be the same without it (exact)"


def _energy(problem, trial):
    """In joules. The program measures gravity from its origin, which is the start unless that is free."""
    scaling = problem.scaling
    bending, torsion, stretch, gravity = (float(e) for e in trial.energies * scaling.energy)
    weight = problem.scene.weight * scaling.length
    gravity += float(weight @ trial.shape.position[0]) * scaling.length
    return Energy(bending, torsion, stretch, gravity)


def _verdict(problem, trial, check, violation):
    """``check``: None where a cable is formed, for there its moments do not follow from its curvature, which is all
    that it knows."""
    scene = problem.scene
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
    if sentence := _too_near(problem, trial.shape):
        return Status.INACCURATE, f"{Status.INACCURATE.value} {sentence}"
    if check is not None and max(check.moment, check.force) > UNBALANCED:
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


def _too_near(problem, shape) -> str | None:
    """A sentence if the cable is nearer to an obstacle than it may be."""
    scene, length, around_it = problem.scene, problem.scaling.length, problem.surroundings
    if not around_it.deepest(shape):
        around_it = around_it.bare
    depth = around_it.deepest(shape) * length
    if not depth:
        return None
    place, obstacle = around_it.worst(shape)
    keep = "its radius"
    if around_it.scene.clearance:
        keep = f"its radius plus the clearance of {scene.clearance:g} m"
    return (
        f"At {place * length:.3g} m the cable is {depth:.2g} m nearer to {scene.obstacles[obstacle].place} than {keep} "
        "allows."
    )


def effort(problem, trial):
    return {
        "name": None if trial is None else trial.raw.solver,
        "scheme": problem.scheme,
        "elements": None if trial is None else len(trial.shape.steps),
        **vars(problem.effort),
    }
