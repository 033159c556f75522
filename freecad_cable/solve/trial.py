# SPDX-License-Identifier: LGPL-2.1-or-later
"""One solve of one scene on one mesh, and what is known about its answer."""

import time
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from ..errors import SolverMissingError
from ..geometry import rotation
from ..problem import Clamp, Ring, Scene
from ..problem.reduce import Model
from ..transcription import contact, layout
from ..transcription.guess import gathered_at, hold, layers
from ..transcription.nlp import Nlp, build, pack
from ..transcription.rows import SHORTEST
from ..transcription.scaling import Scaling
from ..transcription.shape import Shape
from ..transcription.structure import Structure
from ..transcription.supports import TIGHT
from ..transcription.waypoints import breaks
from . import backend, stability, strong_form
from .own import Own, Touches
from .surroundings import Surroundings

THIN = 0.003
"""Bending length √(EI/T), relative to the length, below which helix elements are used: over elements that are many of
them long, strains that alternate from node to node cost an element of order 4 next to nothing."""

LEADEN = 3e5
"""Weight ratio above which fatrop was seen to correct its matrix without end, unless it starts near the answer."""

ACTING = 1e-6
"""Push of a bound, in units of force, below which it is none: the solvers leave their tolerance of 1e-9 over the
distance to a bound that does not act."""
MARGIN = 1.1
"""On the error estimate, which else is as often below the true error as above it, by up to a tenth (160 rows of
`./run bench`)."""


class TimeUpError(Exception):
    """The time limit of a solve has passed; internal to this room."""


@dataclass(frozen=True, eq=False)
class Trial:
    """A converged program and its reading."""

    nlp: Nlp
    values: dict
    parameters: np.ndarray
    raw: backend.RawSolution
    shape: Shape
    measured: float | None = None
    """error found by comparing meshes, where bounds act and the strong form does not hold as it is"""
    owners: np.ndarray | None = None
    """(n+1, contacts) which of the scene's obstacles each contact row keeps away from; −1 for none"""

    def measured_as(self, error: float | None) -> "Trial":
        """The same with its error measured; all else that has been read of it stays read."""
        other = replace(self, measured=error)
        read = vars(self).keys() - vars(other).keys() - {"error"}
        vars(other).update((name, vars(self)[name]) for name in read)
        return other

    @cached_property
    def energies(self) -> np.ndarray:
        """(4,) bending, torsion, stretch, gravity without units"""
        return self.nlp.energy_function(self.raw.x, self.parameters)[0]

    @property
    def energy(self) -> float:
        return float(self.energies.sum())

    @cached_property
    def error(self) -> float:
        """Estimate of the largest position error of a node, relative to the length."""
        if self.slipped:
            return np.inf
        if self.measured is not None:
            return self.measured
        structure = self.nlp.structure
        correction = strong_form.correction(self.shape, self.values, structure)
        return MARGIN * float(np.linalg.norm(correction[:, :3], axis=1).max())

    @cached_property
    def acting(self) -> np.ndarray:
        """(rows,) whether a row holds: an equation, or a bound that pushes harder than it is far."""
        if self.nlp.equality.all():
            return self.nlp.equality
        (left,) = self.nlp.rows_function(self.raw.x, self.parameters)
        push = -self.raw.multipliers
        return self.nlp.equality | ((push > ACTING) & (push > left))

    @cached_property
    def frames(self) -> np.ndarray:
        """(n+1, 3, 3) material frames, d1 d2 d3 as columns"""
        return rotation.matrix(self.shape.quaternion)

    @property
    def touches(self) -> bool:
        by_others = self.owners is not None and self.contact_forces.any()
        return bool(by_others or len(self.with_itself.nodes))

    @cached_property
    def with_itself(self) -> Touches:
        """Where the rod touches itself."""
        rows = self.nlp.link_rows
        push = np.where(self.acting[rows], -self.raw.multipliers[rows], 0.0)
        return Touches.of(self.shape, self.values["links"], push)

    @cached_property
    def pushes(self) -> np.ndarray:
        """(n+1, 3) all that obstacles and the rod itself exert on each node, without units."""
        return self.contact_forces.sum(axis=1) + self.with_itself.on_nodes(len(self.shape.position))

    @cached_property
    def contact_forces(self) -> np.ndarray:
        """(n+1, contacts, 3) what the feature of each contact row exerts on each node, without units."""
        rows, features = self.nlp.contact_rows, self.values["features"]
        nodes = self.shape.position
        if not rows.shape[1]:
            return np.zeros((len(nodes), 0, 3))
        push = np.where((rows >= 0) & self.acting[rows], -self.raw.multipliers[rows], 0.0)
        slopes = [contact.slope(nodes, features[:, i]) for i in range(rows.shape[1])]
        return push[..., None] * np.stack(slopes, axis=1)

    @cached_property
    def slipped(self) -> tuple[int, ...]:
        """Supports that have slid as near to what is beside them as the program allows: no equilibrium."""
        structure = self.nlp.structure
        if not structure.slides:
            return ()
        ends = self.shape.arc_length[structure.ends]
        short = np.diff(ends) < (1 + 1e-3) * SHORTEST
        return tuple(int(j) for j in np.flatnonzero(structure.sliding) if short[j : j + 2].any())

    @property
    def _program(self):
        return self.nlp, self.raw.x, self.parameters, self.raw.multipliers, self.acting

    @cached_property
    def lowest_mode(self):
        """(relative eigenvalue, variation of the decision vector)"""
        return stability.SecondVariation(*self._program).lowest_mode()

    def swayed(self, size) -> Shape:
        """Its nodes moved along the least stable variation, the one that moves most by ``size`` (negative for the
        other way): a guess that has no symmetry to be caught in."""
        mode = self.lowest_mode[1]
        change = size * mode / max(np.abs(mode[self.nlp.states[:, :3]]).max(), 1e-9)
        while True:
            nodes = layout.places(self.nlp, self.shape.steps, self.raw.x + change)
            if (np.diff(nodes[0]) > 0).all():
                return Shape.from_frames(*nodes, self.nlp.structure.joints)
            change /= 2  # a support would slide past another, or past an end

    @cached_property
    def stable(self) -> bool:
        return stability.proven(*self._program) or self.lowest_mode[0] > -stability.ZERO


@dataclass
class Problem:
    """A scene ready to be solved: its model, its scaling, its clock and its count of iterations."""

    scene: Scene
    model: Model
    scaling: Scaling
    layered: list
    """of each stretch, how it bends if it may do so in layers only (see ``transcription.guess.layers``)"""
    deadline: float
    iterations: int = field(default=0)
    solve_time: float = field(default=0.0)
    build_time: float = field(default=0.0)
    watch: Callable[[str], None] | None = field(default=None)
    """called before each run of a solver; see ``find_equilibrium``"""
    apart: bool = field(default=False)
    """whether the cable is kept from running through itself; first it is solved as if it need not"""
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
        self, start: Shape, *, load=1.0, reach=1.0, fallback=True, features=None, links=None
    ) -> Trial | None:
        """The equilibrium that the iteration finds from ``start``, with its mesh; None if it finds none.

        ``load`` scales gravity, and with it the units of force, and ``reach`` the distance of the ends: continuation
        goes through them, and rather takes a shorter step than fall back to the slower solver. ``features`` (n+1,
        contacts, 12) are what the nodes keep away from (see ``transcription.contact``), ``links`` what of the cable
        keeps away from itself.
        """
        contacts = 0 if features is None else features.shape[1]
        nlp = self._built(start, contacts, () if links is None else links.pairs)
        posed = self.surroundings.posed
        values = self.scaling.loaded(load).parameters(posed, start, load, reach)
        values["features"], values["links"] = features, links
        parameters = pack(nlp.structure, values, start.steps)
        x0, lam0 = layout.variables(nlp, start), layout.multipliers(nlp, start, values["weight"])
        for name, near in self._attempts(nlp, start, fallback):
            if time.perf_counter() > self.deadline:
                raise TimeUpError
            if self.watch is not None:
                self.watch(f"{self.scene.rod.length:.4g} m in {len(start.steps)} elements")
            self.build_time += backend.first_use(nlp.structure, name, near)
            raw = backend.minimise(nlp, name, near, x0, parameters, lam0)
            self.iterations += raw.iterations
            self.solve_time += raw.time
            if raw.success:
                found = raw.x, raw.multipliers
                shape = layout.shape_of(nlp, values, parameters, start.steps, *found)
                return Trial(nlp, values, parameters, raw, shape)
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
        return [*first, *((name, False) for name in names)]

    def _built(self, start, contacts, links):
        begin = time.perf_counter()
        nlp = build(self.structure(start.stretches, contacts, links))
        self.build_time += time.perf_counter() - begin
        return nlp
