# SPDX-License-Identifier: LGPL-2.1-or-later
"""A scene ready to be solved, and one solve of it on one mesh."""

import time
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from ..errors import SolverMissingError
from ..problem import Clamp, Ring, Scene
from ..problem.reduce import Model
from ..transcription import arms, layout
from ..transcription.guess import gathered_at, hold, layers
from ..transcription.nlp import build, pack
from ..transcription.scaling import Scaling
from ..transcription.shape import Shape
from ..transcription.structure import Structure
from ..transcription.supports import TIGHT
from ..transcription.waypoints import breaks
from . import backend
from .own import Own
from .surroundings import Surroundings
from .trial import Trial

THIN = 0.003
"""Bending length √(EI/T), relative to the length, below which helix elements are used: over elements that are many of
them long, strains that alternate from node to node cost an element of order 4 next to nothing."""

FOLDED = 2 * np.pi
"""Turn of an element from which a start is none: shapes of one mesh may be that on another. From nodes that miss each
other by thousands of lengths fatrop does not come back (see ``yielding``)."""

LEADEN = 3e5
"""Weight ratio above which fatrop was seen to correct its matrix without end, unless it starts near the answer."""


class TimeUpError(Exception):
    """The time limit of a solve has passed; internal to this room."""


@dataclass
class Effort:
    """What it took so far, with all that is solved on the way: iterations, and the time in solvers and for making them
    [s]."""

    iterations: int = 0
    solve_time: float = 0.0
    build_time: float = 0.0


@dataclass
class Problem:
    """A scene ready to be solved: its model, its scaling, its clock and what it took."""

    scene: Scene
    model: Model
    scaling: Scaling
    layered: list
    """of each stretch, how it bends if it may do so in layers only (see ``transcription.guess.layers``)"""
    deadline: float
    effort: Effort = field(default_factory=Effort)
    watch: Callable[[str], None] | None = field(default=None)
    """called before each run of a solver; see ``find_equilibrium``"""
    apart: bool = field(default=False)
    """whether the cable is kept from running through itself; first it is solved as if it need not"""
    before: Scene | None = field(default=None)
    """that of an earlier solution, which is to be followed"""
    pushers: dict[int, np.ndarray] = field(default_factory=dict)
    """of the scene's obstacles that the cable touched before, how far each has moved since (3,) [m]"""
    hurried: bool = field(default=False)
    """whether what fails from a start that is nearly the solution is tried from nearer, and not by slower solvers"""
    anew: bool = field(default=False)
    """whether an earlier solution was to be followed, and could not be"""
    parts: bool = field(default=True)
    """whether a cable that runs through itself is brought apart from itself"""
    formed: bool = field(default=False)
    """whether the cable must be formed to keep its bend radius; first it is solved as if it need not"""

    @classmethod
    def of(cls, scene: Scene, model: Model, watch=None, pull=0.0) -> "Problem":
        """``pull``: force that is known to occur [N]."""
        deadline = time.perf_counter() + scene.options.time_limit
        scaling = Scaling.of(scene)
        layered = layers(scene, scaling)
        pulls = [np.linalg.norm(each.pull) for each in hold(layered)]
        scaling = scaling.pulled(max(pulls, default=0.0)).fit_for(pull)
        return cls(scene, model, scaling, layered, deadline, watch=watch)

    def eased(self, scene: Scene, pull=0.0) -> "Problem":
        """That of an easier scene with the same model, within the time of this one, and what it takes counted here."""
        other = Problem.of(scene, self.model, self.watch, pull)
        return replace(other, deadline=self.deadline, effort=self.effort, parts=self.parts)

    @cached_property
    def breaks(self) -> tuple[float, ...]:
        """Arc lengths of the supports, relative to the length; guessed where the cable slides."""
        return breaks(self.scene, self.scaling)

    @cached_property
    def narrow(self) -> list[tuple[float, float]]:
        """Places and widths of the bending layers that a mesh must gather nodes at."""
        return gathered_at(self.scene, self.scaling, self.layered)

    @cached_property
    def surroundings(self) -> Surroundings:
        return Surroundings(self.scene, self.scaling)

    @cached_property
    def on_the_way(self) -> Surroundings:
        """With what was in reach before."""
        if self.before is None:
            return self.surroundings
        return self.surroundings.in_reach_of(self.before)

    @cached_property
    def own(self) -> Own:
        return Own(self.scene, self.scaling)

    @property
    def scheme(self) -> str:
        wanted = self.scene.options.scheme
        if wanted != "auto":
            return wanted
        return "helix" if self.scaling.tightness > THIN**-2 else "magnus"

    @property
    def solvers(self) -> list[str]:
        wanted = self.scene.options.solver
        names = ["fatrop", "ipopt"] if wanted == "auto" else [wanted]
        present = [name for name in names if backend.available(name)]
        if not present:
            raise SolverMissingError(
                f"This CasADi has no plug-in {' or '.join(names)}; install the casadi wheel from PyPI"
            )
        return present

    def structure(self, stretches, contacts=0, links=()) -> Structure:
        scene = self.scene
        return Structure(
            self.scheme,
            stretches,
            scene.start.kind,
            scene.end.kind,
            self.model.strains,
            tuple(self._support_kind(support) for support in scene.supports),
            tuple(support.slides for support in scene.supports),
            contacts,
            self.formed,
            links,
        )

    def _support_kind(self, support):
        if isinstance(support, Ring):
            tight = self.scaling.play(support, self.scene.rod) < TIGHT
            return "eyelet" if tight else "ring"
        return "clamp" if isinstance(support, Clamp) else "sleeve"

    def solve(
        self,
        start: Shape,
        *,
        load=1.0,
        reach=1.0,
        fallback=True,
        hasty=False,
        places=None,
        links=None,
    ) -> Trial | None:
        """The equilibrium that the iteration finds from ``start``, with its mesh; None if it finds none.

        ``load`` scales gravity, and with it the units of force, and ``reach`` the distance of the ends: continuation
        goes through them, and rather takes a shorter step than fall back to the slower solver. ``hasty``: whether to
        give up where fatrop fails once, for there are other starts. ``places`` keep away from obstacles, and ``links``
        are what of the cable keeps away from itself.
        """
        if _folded(start):
            return None
        contacts = 0 if places is None else places.owners.shape[1]
        nlp = self._built(start, contacts, () if links is None else links.pairs)
        posed = self.surroundings.posed
        values = self.scaling.loaded(load).parameters(posed, start, load, reach)
        values["arms"] = None if places is None else arms.rows(nlp.structure, start, places)
        values["links"] = links
        parameters = pack(nlp.structure, values, start.steps)
        x0, lam0 = layout.variables(nlp, start), layout.multipliers(nlp, start, values["weight"])
        for name, near in self._attempts(nlp, start, fallback):
            if time.perf_counter() > self.deadline:
                raise TimeUpError
            if self.watch is not None:
                self.watch(f"{self.scene.rod.length:.4g} m in {len(start.steps)} elements")
            self.effort.build_time += backend.first_use(nlp.structure, name, near)
            raw = backend.minimise(nlp, name, near, x0, parameters, lam0, hasty)
            self.effort.iterations += raw.iterations
            self.effort.solve_time += raw.time
            if raw.success:
                return Trial(nlp, values, parameters, raw, start.steps, places=places)
        return None

    def _attempts(self, nlp, start, fallback):
        """(solver, whether it takes the start for nearly the solution), in order."""
        if nlp.structure.links:
            return [("ipopt", False)]
        names = self.solvers if fallback else self.solvers[:1]
        if start.force is None and self.scaling.weight_ratio > LEADEN:
            names = [name for name in self.solvers if name != "fatrop"] or names
        near = start.force is not None and not nlp.equality.all()
        first = [("fatrop", True)] if near and names[0] == "fatrop" else []
        if first and self.hurried:
            return first
        return [*first, *((name, False) for name in names)]

    def _built(self, start, contacts, links):
        begin = time.perf_counter()
        nlp = build(self.structure(start.stretches, contacts, links))
        self.effort.build_time += time.perf_counter() - begin
        return nlp


def _folded(shape) -> bool:
    """Whether an element of a shape bends by more than ``FOLDED``."""
    bend = np.linalg.norm(shape.strain[:, :3], axis=1)
    return bool((np.maximum(bend[:-1], bend[1:]) * shape.steps).max() > FOLDED)
