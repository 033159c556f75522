# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a problem to a stable equilibrium on a mesh that is fine enough.

Plain attempts first, dearer ones only when they fail: a warm or a guessed start; continuation in weight and in
the distance of the ends; starts that send the slack elsewhere. Then off any saddle, then refinement.
"""

import time
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace

import numpy as np

from ..geometry.runs import runs
from ..problem import Swivel
from ..problem.reduce import orientation, reduce
from ..transcription.guess import guess, hangs, hold, holds_turns, roll_mismatch, rolled, turned
from ..transcription.shape import Shape
from . import contact, mesh
from .continuation import continued, taut_chord
from .drawing_in import drawn_in
from .laying import laden
from .leading import led
from .letting_out import SLACK, let_out
from .looking import unhindered
from .problem import LEADEN, Problem, TimeUpError
from .refining import GARBAGE, refined
from .saddle import descended
from .trial import Trial

HEAVY = 3e3
"""Weight ratio above which a cold start is wasted time (measured: from here it needs over 100 iterations or
fails) and continuation in weight is the first thing to try."""
SCARCE = 1e-3
"""Slack, relative to the length, below which continuation comes first."""
SOFT = 0.2
"""GJ/EI below which a cable hardly resists twist."""
LIMP = 4e-3
"""GJ/EI below which a first mesh is finer, like 1/√: on a coarse one the error of an element of order 4 is more than
what little a twist costs, and the iteration twists the cable to exploit it (measured down to 1e-4)."""
LOOSE = 0.65
"""Chord, relative to the length, below which a cable may as well loop as hang: both are tried."""
HELD_AT = 1e-3
"""How near to the limit, relative to it, a curvature is taken to be held there."""
KINK = 2e-3
"""Shortest elements beside a kink of the curvature, relative to the length: an element with a kink in it misses its own
share of the moment."""
PLAIN = 0.5
"""Of the time that is left, what a cable among obstacles is looked for in as it is."""
DOUBTFUL_ROLL = 2.0
"""Twist [rad] of a guess beyond which the other way round may cost less (at π they are alike)."""


def find(problem: Problem, warm: Shape | None = None, by_steps=lambda: None) -> Trial | None:
    """A stable equilibrium to the tolerance asked for, or the best that was found, or None. ``by_steps()`` is what is
    found from where ``warm`` comes from, if it is not from there at once."""
    if warm is not None:
        found = followed(problem, warm) or by_steps()
        if found is not None:
            return found
        problem.anew, problem.pushers = True, {}
        if warm.error is None and not problem.surroundings.obstacles:
            warm = None  # there is nothing that was in its way
    search = _among_obstacles if problem.surroundings.obstacles else _through_itself
    found = search(problem, warm)
    return None if found is None else apart(problem, found)


def followed(problem: Problem, warm: Shape) -> Trial | None:
    """The equilibrium that an earlier one has become; None if there is none near."""
    return _undisturbed(problem, warm) or contact.resumed(problem, warm)


def _among_obstacles(problem, warm):
    """As it is, or, where that does not come to rest in its part of the time, from cables that are easier to find."""
    now, deadline, found = time.perf_counter(), problem.deadline, None
    problem.deadline = now + PLAIN * (deadline - now)
    with suppress(TimeUpError):
        found = _through_itself(problem, warm)
    problem.deadline = deadline
    if contact.rests(problem, found):
        return found
    try:
        return _from_easier(problem) or found
    except TimeUpError:
        if found is None:
            raise
        return found


def _from_easier(problem):
    """From cables that are shorter, lighter or longer; those that are short and free of all obstacles take the least
    time."""
    return (
        let_out(problem, _free)
        or laden(problem, _through_itself)
        or drawn_in(problem, _through_itself)
        or let_out(problem, _through_itself, SLACK[:1])
        or drawn_in(
            problem, lambda longer, _: let_out(longer, _free) or laden(longer, _through_itself)
        )
    )


def _undisturbed(problem, warm):
    """From an equilibrium that touches nothing to one that does not either, if nothing can have been in its way.
    Cheaper than to keep away from all that is near."""
    obstacles, formed = problem.on_the_way.obstacles, problem.scene.enforce_bend_radius
    if warm.error is not None or (obstacles and formed):
        return None
    found = _followed(problem, warm)
    if found is None:
        return None
    found = refined(problem, found)
    if formed:
        found = _formed(problem, found)
    if found is None or (obstacles and not unhindered(problem.on_the_way, warm, found.shape)):
        return None
    return apart(problem, found)


def apart(problem, trial):
    """From a shape that may run through itself to one that does not; the same if none is found, or none is wanted."""
    if not problem.parts:
        return trial
    found = contact.apart(problem, trial)
    return found if found is trial or found.touches else refined(problem, found)


def _through_itself(problem, warm):
    """As if nothing kept the cable from that."""
    found = _free(problem, warm)
    if found is not None and problem.scene.enforce_bend_radius:
        found = _formed(problem, found)
    if found is None or not problem.surroundings.obstacles:
        return found
    found = contact.around(problem, found)
    return found if found is None or found.touches else refined(problem, found)


def _formed(problem, trial):
    """From a free shape to one that bends nowhere more sharply than it may; the free one if it does so by itself."""
    limit = problem.scaling.length / problem.scene.rod.min_bend_radius
    bends = [part.strain[:, :2] for part in trial.shape.parts()]
    if max(np.linalg.norm(bend, axis=1).max() for bend in bends) <= limit:
        return trial
    problem.formed = True
    found = problem.solve(trial.shape)
    if found is None or problem.scene.options.elements is not None:
        return found
    return _kinked(problem, refined(problem, found), limit)


def _kinked(problem, trial, limit):
    """With nodes where the limit begins and ends to act: there the curvature has a kink."""
    bend, s = np.linalg.norm(trial.shape.strain[:, :2], axis=1), trial.shape.arc_length
    places = [s[k] for a, b in runs(bend > limit * (1 - HELD_AT)) for k in (a, b - 1)]
    nodes = mesh.gathered(trial.shape, mesh.size(3 * len(trial.shape.steps)), places, KINK)
    try:
        finer = problem.solve(trial.shape.on(nodes))
    except TimeUpError:
        return trial
    return trial if finer is None or not finer.stable else finer


def _free(problem, warm):
    """As if there were no obstacles."""
    found = None if warm is None else _followed(problem, warm)
    if found is None:
        for trial in _attempts(problem, _first_mesh(problem)):
            trial = off_saddle(problem, trial)
            if found is None or _better(trial, found):
                found = trial
            if found.stable and found.error < GARBAGE:
                break
    return None if found is None else refined(problem, found)


def _followed(problem, warm):
    """From an equilibrium to the one that it has become; None if that is not stable."""
    found = problem.solve(warm.on(mesh.asked(warm, problem.scene.options.elements)))
    if found is None:
        return None
    # What buckles on its way goes where it falls to, with the turns that it has.
    found = off_saddle(problem, found)
    return found if found.stable else None


def _first_mesh(problem, factor=1.0):
    """For a guess; ``factor`` times as fine where no number of elements is asked for."""
    rod = problem.scene.rod
    if problem.model.twist:
        softness = LIMP * rod.bending_stiffness.max() / rod.torsional_stiffness
        factor *= max(1.0, softness**0.5)
    if problem.narrow:
        factor *= 2
    elements = problem.scene.options.elements or mesh.size(factor * mesh.COARSE)
    if problem.narrow:
        return mesh.graded(elements, problem.narrow, problem.breaks)
    return mesh.uniform(elements, problem.breaks)


def _better(trial, other):
    """Resolved before unresolved, stable before unstable, then the lower energy."""
    rank = lambda t: (t.error > GARBAGE, not t.stable, t.energy)  # noqa: E731
    return rank(trial) < rank(other)


def _attempts(problem: Problem, arc_length) -> Iterator[Trial]:
    """Converged trials, cheapest first, made as they are asked for."""
    taut = taut_chord(problem.scene) > 1 - SCARCE
    ways = [
        lambda: _direct(problem, arc_length),
        lambda: continued(problem, len(arc_length) - 1),
    ]
    if not hold(problem.layered) and (taut or problem.scaling.weight_ratio > HEAVY):
        ways.reverse()
    if problem.scene.supports and problem.scene.spans:
        ways.insert(1, lambda: _led(problem))
    if problem.scene.options.elements is None:
        # A soft or sharply bent cable may need more elements before its program has the right minimum at all.
        ways.append(lambda: _direct(problem, _first_mesh(problem, 3)))
    for way in ways:
        yield from way()
    if problem.scaling.weight_ratio < LEADEN:
        yield from _elsewhere(problem, arc_length)


def _direct(problem, arc_length):
    """From the guess, and from its rivals where more than one is natural."""
    scene, scaling = problem.scene, problem.scaling
    if (without_torsion := _without_torsion(problem, arc_length)) is not None:
        trial = problem.solve(without_torsion)
        if trial is not None:
            yield trial
    starts = [guess(scene, scaling, arc_length, layered=problem.layered)]
    loose = scene.spans and 0 < scene.chord < LOOSE * scaling.length
    if loose and scaling.weight_ratio < HEAVY:
        starts.append(guess(scene, scaling, arc_length, chain=not hangs(scaling)))
    starts += [
        turned(scene, scaling, starts[0], turns) for turns in _turns(problem, starts[0], loose)
    ]
    trials = [problem.solve(each) for each in starts]
    yield from sorted((t for t in trials if t is not None), key=lambda trial: trial.energy)


def _turns(problem, start, loose):
    """With how many turns more it may cost less."""
    if not (problem.model.twist and holds_turns(problem.scene)):
        return ()
    if loose and not hangs(problem.scaling):
        return -1, 1  # instead of a loop without twist a bow with a turn
    roll = roll_mismatch(problem.scene, start)
    return () if abs(roll) <= DOUBTFUL_ROLL else (-1,) if roll > 0 else (1,)


def _led(problem):
    """To the supports from where it hangs without them."""
    free = _of_another(problem, replace(problem.scene, supports=()))
    if free is not None and free.stable and free.error < GARBAGE:
        yield from led(problem, free)


def _without_torsion(problem, arc_length):
    """A start for a cable that hardly resists twist: its shape with an end free to twist, rolled to fit. From the
    plain guess the soft twist runs away to other numbers of turns."""
    scene, rod = problem.scene, problem.scene.rod
    soft = rod.torsional_stiffness < SOFT * rod.bending_stiffness[0]
    if scene.supports or not (problem.model.twist and rod.isotropic and soft):
        return None
    loose = replace(scene, end=Swivel(scene.end.position, orientation(scene.end)))
    trial = _of_another(problem, loose)
    if trial is None:
        return None
    shape = trial.shape.on(arc_length)
    return rolled(scene, problem.scaling, arc_length, shape.position, shape.quaternion)


def _of_another(problem, scene):
    """The free shape of another scene, in the units and in the time of this one."""
    return _free(replace(problem, scene=scene, model=reduce(scene)), None)


def _elsewhere(problem, arc_length):
    """Starts whose slack goes another way than gravity's; the same ones in every run."""
    directions = np.random.default_rng(20).normal(size=(6, 3))
    for direction in directions:
        sag = 60 * direction / np.linalg.norm(direction)
        trial = problem.solve(guess(problem.scene, problem.scaling, arc_length, sag=sag))
        if trial is not None:
            yield trial


def off_saddle(problem, trial):
    """A minimum below a saddle, if one is found; what no mesh resolves is left as it is."""
    return descended(trial, problem.solve, 0.1, lambda t: t.stable or t.error > GARBAGE)
