# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the nonlinear program of a structure, in the stage order that fatrop wants.

Variables x₀ u₀ x₁ u₁ … x_N, rows gap₀ rows₀ gap₁ … rows_N, with gap_k = x_{k+1} − F(x_k, u_k):

    state x    position (3), quaternion (4); with a scheme whose strain is continuous the strain (m);
               where the cable slides, length and first arc length of the stretch (2)
    control u  the strain of the element (m), or the strain at its far node (m);
               beyond a support also the strain at its first node (m), for it may jump there;
               beyond a support where the cable slides, the length of the next stretch (1)

The gap keeps the sign that makes its multipliers the internal force and (through the quaternion) moment.
"""

import casadi as ca
import numpy as np

from . import contact, ends, helix, magnus, supports
from .element import step
from .hessian import element_block

SCHEMES = {"helix": helix, "magnus": magnus}

PARAMETERS = {
    "stiffness": 6,
    "natural": 3,
    "weight": 3,
    "start_position": 3,
    "start_quaternion": 4,
    "end_position": 3,
    "end_quaternion": 4,
    "curvature_limit": 1,
}
"""Sizes of the parameters beside those of the supports and the element lengths, all without units (see ``scaling``)."""

SHORTEST = 1e-3
"""Length of a stretch, relative to the cable, below which no support slides."""


class Writer:
    """Collects variables, rows and the blocks of their derivatives, stage by stage."""

    def __init__(self, structure):
        self.structure = structure
        self.scheme = SCHEMES[structure.scheme]
        self.size = len(structure.strains)
        self.held = {node: j for j, node in enumerate(structure.joints)}
        self.named = {name: ca.SX.sym(name, size) for name, size in PARAMETERS.items()}
        self.supports = [
            {name: ca.SX.sym(f"{name}{j}", size) for name, size in supports.PARAMETERS.items()}
            for j in range(len(structure.supports))
        ]
        self.steps = ca.SX.sym("h", structure.elements)
        features = structure.contacts * (structure.elements + 1)
        self.features = ca.SX.sym("feature", contact.PARAMETERS, features)
        self.factor = ca.SX.sym("lam_f")
        self.block = element_block(self.scheme, structure, self.full)
        own = self.size if self.scheme.STRAIN_IS_STATE else 0
        self.state_size = 7 + own + (2 if structure.slides else 0)
        self.control_sizes = [
            self.size + (own + structure.slides if k in self.held else 0)
            for k in range(structure.elements)
        ]
        self.width = structure.elements * self.state_size + sum(self.control_sizes)
        self.width += self.state_size
        self.x, self.g, self.multipliers, self.equality = [], [], [], []
        self.hessian, self.jacobian, self.sizes, self.gaps = [], [], [], []
        self.held_rows, self.contact_rows, self.means = [], [], []
        self.energies = ca.SX.zeros(4)
        self.begin = 0

    @property
    def parameters(self):
        held = [symbol for each in self.supports for symbol in each.values()]
        return ca.vertcat(*self.named.values(), *held, self.steps, self.features[:])

    def full(self, strain, unloaded):
        """(κ, v) from the strains that the model keeps."""
        e = ca.SX(ca.vertcat(unloaded, 0, 0, 0))
        for i, index in enumerate(self.structure.strains):
            e[index] = strain[i]
        return e[:3], ca.vertcat(e[3], e[4], 1 + e[5])

    def next_multipliers(self, count):
        self.multipliers.append(ca.SX.sym(f"lam{len(self.multipliers)}", count))
        return self.multipliers[-1]

    def add(self, rows, jacobian, equality=True):
        """Rows of this stage with their Jacobian over its variables and the next state."""
        self.g.append(rows)
        self.equality += [equality] * rows.numel()
        after = self.width - self.begin - jacobian.columns()
        before = ca.SX(jacobian.rows(), self.begin)
        self.jacobian.append(ca.horzcat(before, jacobian, ca.SX(jacobian.rows(), after)))

    def element(self, k, state, following):
        """Control, energy and gap of element k: (control, Hessian over state and control)."""
        structure, scheme, named = self.structure, self.scheme, self.named
        size, nx = self.size, self.state_size
        control = ca.SX.sym(f"u{k}", self.control_sizes[k])
        own = ca.vertcat(state, control)
        beyond, index = k in self.held, np.arange(own.numel())
        first = last = index[nx : nx + size]
        if scheme.STRAIN_IS_STATE:
            first = first if beyond else index[7 : 7 + size]
            last = index[nx + size : nx + 2 * size] if beyond else last
        changing = [3, 4, 5, 6, *first, *(last if scheme.STRAIN_IS_STATE else ())]
        share, h = self.steps[k], self.steps[k]
        if structure.slides:
            stretch = index[-1] if beyond else nx - 2
            changing.append(stretch)
            h = share * own[int(stretch)]
        changing = [int(i) for i in changing]

        r, q, natural, weight = state[:3], state[3:7], named["natural"], named["weight"]
        a, b = own[first.tolist()], own[last.tolist()]
        kept = list(structure.strains)
        screw = scheme.screw(h, self.full(a, natural), self.full(b, natural))
        displacement, q_next, mean = step(q, *screw)
        if beyond or k == 0:
            self.means.append(mean)
        rest = ca.vertcat(natural, 0, 0, 0)[kept]
        parts = scheme.elastic_energy(h, named["stiffness"][kept], a - rest, b - rest)
        for i, strain in enumerate(kept):
            self.energies[0 if strain < 2 else 1 if strain == 2 else 2] += parts[i]
        self.energies[3] -= h * ca.dot(weight, r - named["start_position"] + mean)

        reached = [r + displacement, q_next]
        if scheme.STRAIN_IS_STATE:
            reached.append(b)
        if structure.slides:
            reached += [own[changing[-1]], state[nx - 1] + (state[nx - 2] if beyond else 0)]
        self.gaps.append(len(self.equality))
        loads = [named["stiffness"], natural, weight, self.factor, self.next_multipliers(nx)[:7]]
        block, reach = self.block(own[changing], share, *loads)
        lead = ca.SX(nx, own.numel())
        lead[:3, :3] = ca.SX.eye(3)
        lead[:7, changing] = reach
        if scheme.STRAIN_IS_STATE:
            lead[7 : 7 + size, last.tolist()] = ca.SX.eye(size)
        if structure.slides:
            lead[nx - 2, changing[-1]] = 1
            lead[nx - 1, nx - 1] = 1
            if beyond:
                lead[nx - 1, nx - 2] = 1
        jacobian = ca.horzcat(-lead, ca.SX.eye(nx))
        self.add(following - ca.vertcat(*reached), jacobian)
        hessian = ca.SX(own.numel(), own.numel())
        hessian[changing, changing] = block
        if structure.slides:
            lift = -self.factor * share * weight
            hessian[:3, changing[-1]] = lift
            hessian[changing[-1], :3] = lift.T
        return control, hessian

    def rows(self, k, state, own):
        """Rows of stage k beside its gap; the Hessian of their part over its variables."""
        structure, nx = self.structure, self.state_size
        r, q = state[:3], state[3:7]
        equations, bounds = [], []
        if k == 0:
            equations.append(ends.start_rows(structure, r, q, self.named))
        if k == structure.elements:
            equations.append(ends.end_rows(structure, r, q, self.named))
        if structure.slides and k in (0, structure.elements):
            whole = state[nx - 1] + state[nx - 2] - 1
            equations.append(state[nx - 1] if k == 0 else whole)
            bounds += [state[nx - 2] - SHORTEST] if k == 0 else []
        if k in self.held:
            j = self.held[k]
            kind, values = structure.supports[j], self.supports[j]
            equations.append(supports.equations(kind, r, q, values))
            bounds.append(supports.play_left(kind, r, values))
            if structure.slides:
                if not structure.sliding[j]:
                    equations.append(state[nx - 1] + state[nx - 2] - values["arc_length"])
                bounds.append(own[-1] - SHORTEST)
        begin = len(self.equality)
        gaps = self.gaps_to_obstacles(k, r)
        ahead = ca.vertcat(*equations, *bounds).numel()
        self.contact_rows.append(begin + ahead + np.arange(len(gaps)) if gaps else None)
        bounds += gaps
        if structure.bend_limit:
            bounds += self.bends_left(k, own)
        hessian = ca.SX(own.numel(), own.numel())
        for rows, equality in ((ca.vertcat(*equations), True), (ca.vertcat(*bounds), False)):
            if rows.numel():
                self.add(rows, ca.jacobian(rows, own), equality)
                pull = ca.dot(self.next_multipliers(rows.numel()), rows)
                hessian += ca.hessian(pull, own)[0]
        if k in self.held:
            self.held_rows.append(range(begin, len(self.equality)))
        return len(self.equality) - begin, hessian

    def gaps_to_obstacles(self, k, r):
        """Of a node that nothing holds: those that are held are where their holder says."""
        structure, count = self.structure, self.structure.contacts
        free = {0: structure.start == "free", structure.elements: structure.end == "free"}
        if k in self.held or not free.get(k, True):
            return []
        return [contact.gap(r, self.features[:, k * count + i]) for i in range(count)]

    def bends_left(self, k, own):
        """About the curvature that is left to the limit, at every strain of a stage."""
        nx, limit = self.state_size, self.named["curvature_limit"]
        if self.scheme.STRAIN_IS_STATE:
            places = [7, nx] if k in self.held else [7]
        else:
            places = [nx] if k < self.structure.elements else []
        return [(limit - ca.sumsqr(own[i : i + 2]) / limit) / 2 for i in places]

    def write(self):
        state = ca.SX.sym("x0", self.state_size)
        for k in range(self.structure.elements):
            following = ca.SX.sym(f"x{k + 1}", self.state_size)
            control, hessian = self.element(k, state, following)
            own = ca.vertcat(state, control)
            rows, bent = self.rows(k, state, own)
            self.x.append(own)
            self.hessian.append(hessian + bent)
            self.sizes.append((self.state_size, control.numel(), rows))
            self.begin += own.numel()
            state = following
        rows, bent = self.rows(self.structure.elements, state, state)
        self.x.append(state)
        self.hessian.append(bent)
        self.sizes.append((self.state_size, 0, rows))

    def strain_of(self):
        """(len x,) which of the kept strains each variable is."""
        own = self.size if self.scheme.STRAIN_IS_STATE else 0
        count = np.arange(self.size)
        found = []
        for nx, nu, _ in self.sizes:
            stage = np.full(nx + nu, -1)
            stage[7 : 7 + own] = count[:own]
            strains = nu - nu % self.size
            stage[nx : nx + strains] = np.tile(count, strains // self.size)
            found.append(stage)
        return np.concatenate(found)
