# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the nonlinear program of a structure and its derivatives.

Rows gap₀ rows₀ gap₁ … rows_N, with gap_k = x_{k+1} − F(x_k, u_k): the gap keeps the sign that makes its multipliers the
internal force and (through the quaternion) moment. Nothing couples two stages but the gaps, which are linear in the
next state, so the Hessian is block diagonal. Functions of one element, node or support are evaluated across all of
them (see ``across``) and their values sorted into place, so that writing costs next to nothing however fine the mesh.
"""

import casadi as ca
import numpy as np

from . import arms, contact, supports
from .across import across
from .element_functions import element
from .numbering import Numbering
from .rows import bend_left, bounds, holders

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
"""Sizes of the parameters beside those of the supports, the element lengths and the places that keep away from
obstacles, all without units (see ``scaling``)."""


def from_triplets(shape, rows, columns, values) -> ca.MX:
    """A sparse matrix from its nonzeros; no place twice."""
    order = np.lexsort((rows, columns))
    starts = np.concatenate([[0], np.cumsum(np.bincount(columns, minlength=shape[1]))])
    sparsity = ca.Sparsity(*shape, starts.tolist(), rows[order].tolist())
    return ca.MX(sparsity, values[order.tolist()])


class Writer:
    """Collects rows and derivatives. ``x``, ``g``, ``f``, ``p`` and the like are MX columns."""

    def __init__(self, structure):
        self.structure = structure
        self.numbers = Numbering(structure)
        self.x = ca.MX.sym("x", self.numbers.size)
        self.factor = ca.MX.sym("lam_f")
        self._read_parameters()
        start, end = (
            ca.vertcat(self.named[f"{place}_position"], self.named[f"{place}_quaternion"])
            for place in ("start", "end")
        )
        self.holders = holders(structure, self.numbers, start, end, self.supports)
        self._number_rows()
        self.multipliers = ca.MX.sym("lam_g", len(self.equality))
        self.row_terms, self.slope_terms, self.bent_terms = [], [], []
        self._elements()
        self._linear_gaps()
        self._held()
        if structure.contacts:
            self._contacts()
        if structure.links:
            self._links()
        if structure.bend_limit:
            self._bends()
        order = np.argsort(np.concatenate([rows for rows, _ in self.row_terms]))
        self.g = ca.vertcat(*(values for _, values in self.row_terms))[order.tolist()]
        rows, columns, values = zip(*self.slope_terms, strict=True)
        self.jacobian = from_triplets(
            (len(self.equality), self.numbers.size),
            np.concatenate(rows),
            np.concatenate(columns),
            ca.vertcat(*values),
        )
        self.hessian = self._summed_hessian()

    def _read_parameters(self):
        structure = self.structure
        places = arms.PARAMETERS * structure.contacts * structure.elements
        sizes = [*PARAMETERS.values()]
        sizes += [*supports.PARAMETERS.values()] * len(structure.supports)
        sizes += [structure.elements, places, contact.LINK_PARAMETERS * len(structure.links)]
        self.p = ca.MX.sym("p", sum(sizes))
        parts = iter(ca.vertsplit(self.p, np.concatenate([[0], np.cumsum(sizes)]).tolist()))
        self.named = {name: next(parts) for name in PARAMETERS}
        self.supports = [
            ca.vertcat(*(next(parts) for _ in supports.PARAMETERS)) for _ in structure.supports
        ]
        self.steps, self.places, self.links = (next(parts) for _ in range(3))

    def _number_rows(self):
        """Every stage has its gap, equations, bounds of what holds it, of obstacles, and of the curvature."""
        structure, numbers = self.structure, self.numbers
        n, nx = structure.elements, numbers.nx
        if numbers.continuous:
            self.bent_at = [[place] for place in numbers.states[:, 7]]
            for node in structure.joints:
                self.bent_at[node].append(numbers.first[node, 0])
        else:
            self.bent_at = [*([place] for place in numbers.first[:, 0]), []]
        equality, self.gaps, self.held_rows, self.contact_rows = [], [], {}, []
        self.bend_rows, sizes = [], []
        for k in range(n + 1):
            if k < n:
                self.gaps.append(len(equality))
                equality += [True] * nx
            begin = len(equality)
            if k in self.holders:
                equations, bounds = self.holders[k].equations, self.holders[k].bounds
                self.held_rows[k] = range(begin, begin + equations + bounds)
                equality += [True] * equations + [False] * bounds
            if k < n:
                self.contact_rows.append(range(len(equality), len(equality) + structure.contacts))
                equality += [False] * structure.contacts
            if structure.bend_limit:
                self.bend_rows += range(len(equality), len(equality) + len(self.bent_at[k]))
                equality += [False] * len(self.bent_at[k])
            sizes.append((nx, int(numbers.nu[k]), len(equality) - begin))
        self.link_rows = len(equality) + np.arange(len(structure.links))
        equality += [False] * len(structure.links)
        self.equality, self.gaps, self.stage_sizes = equality, np.array(self.gaps), sizes

    def _add_hessian(self, variables, triangles):
        """Symmetric blocks over ``variables`` (blocks, c), from their upper ``triangles`` (blocks, …) row by row."""
        blocks, count = variables.shape
        first, second = np.triu_indices(count)
        place = np.zeros((count, count), int)
        place[first, second] = place[second, first] = np.arange(len(first))
        i, j = np.divmod(np.arange(count * count), count)
        from_which = place[i, j] * blocks + np.arange(blocks)[:, None]
        self.bent_terms.append((variables[:, i], variables[:, j], from_which, ca.vec(triangles)))

    def _summed_hessian(self):
        """Blocks that share a place are summed; one product with a constant matrix does that and sorts."""
        size, begin = self.numbers.size, 0
        places, which = [], []
        for rows, columns, from_which, values in self.bent_terms:
            places.append((columns * size + rows).ravel())
            which.append((begin + from_which).ravel())
            begin += values.numel()
        there, where = np.unique(np.concatenate(places), return_inverse=True)
        which, values = np.concatenate(which), ca.vertcat(*(term[-1] for term in self.bent_terms))
        ones, shape = ca.DM.ones(len(which)), (len(there), begin)
        sums = ca.DM.triplet(where.tolist(), which.tolist(), ones, *shape)
        columns, rows = np.divmod(there, size)
        return from_triplets((size, size), rows, columns, sums @ values)

    def _take(self, places, among=None):
        """(blocks, c) values of the variables, or of ``among``, at the places (blocks, c)."""
        values = self.x if among is None else among
        return ca.reshape(values[places.T.ravel().tolist()], *places.shape)

    def _elements(self):
        structure, numbers, named = self.structure, self.numbers, self.named
        n = structure.elements
        functions = element(structure.scheme, structure.strains, structure.slides)
        law = ca.vertcat(named["stiffness"], named["natural"], named["weight"]).T
        own, shares = self._take(numbers.element), self.steps
        rows = self.gaps[:, None] + np.arange(7)
        lam = self._take(rows, self.multipliers)
        displacement, turned = across(functions.motion, own, shares, law)
        elastic, mean, lengths = across(functions.energy, own, shares, law)
        places = self._take(numbers.states[:-1, :3])
        following = self._take(numbers.states[1:, :7])
        reached = ca.horzcat(places + displacement, turned)
        self.row_terms.append((rows.T.ravel(), ca.vec(following - reached)))

        strained = self._take(numbers.first)
        share = shares if numbers.stretch is None else shares * own[:, -1]
        self.turns = ca.vec(strained * ca.repmat(share, 1, strained.shape[1]))

        kinds = [0 if strain < 2 else 1 if strain == 2 else 2 for strain in structure.strains]
        sums = ca.sum1(elastic)
        parts = [sum(sums[i] for i, k in enumerate(kinds) if k == kind) for kind in range(3)]
        offsets = places - ca.repmat(named["start_position"].T, n, 1)
        self.energies = ca.vertcat(*parts, -lengths.T @ (offsets + mean) @ named["weight"])
        self.means = mean[[0, *structure.joints], :].T
        (slopes,) = across(functions.slope, offsets, own, shares, law)
        changing = np.hstack([numbers.states[:-1, :3], numbers.element])
        self.gradient = self._column(changing.T.ravel(), ca.vec(slopes))

        (blocks,) = across(functions.block, own, shares, law, self.factor, lam)
        self._add_hessian(numbers.element, blocks)
        (reach,) = across(functions.reach, own, shares, law)
        if structure.slides:
            lift = ca.vec(-self.factor * shares @ named["weight"].T)
            r, length = numbers.states[:-1, :3].T, np.tile(numbers.stretch, (3, 1))
            which = np.arange(lift.numel()).reshape(r.shape)
            self.bent_terms += [(r, length, which, lift), (length, r, which, lift)]
        width = numbers.element.shape[1]
        self.slope_terms += [
            (
                np.tile(rows.T, (width, 1)).ravel(),
                np.repeat(numbers.element.T, 7, axis=0).ravel(),
                -ca.vec(reach),
            ),
            self._constant(rows, numbers.states[1:, :7], 1.0),
            self._constant(rows[:, :3], numbers.states[:-1, :3], -1.0),
        ]

    def _column(self, places, values):
        """A dense column over x from values at some places."""
        order = np.argsort(places)
        sparsity = ca.Sparsity(self.numbers.size, 1, [0, len(places)], places[order].tolist())
        return ca.densify(ca.MX(sparsity, values[order.tolist()]))

    @staticmethod
    def _constant(rows, columns, value):
        return rows.ravel(), columns.ravel(), ca.MX(ca.DM.ones(rows.size, 1) * value)

    def _linear_gaps(self):
        """Strain, length and first arc length of a stretch go from stage to stage unchanged, or from the control."""
        structure, numbers = self.structure, self.numbers
        nx, size, x = numbers.nx, len(structure.strains), self.x

        def carry(offset, sources):
            """Next state − the sum of the sources, each (n, c) or with −1 where there is none."""
            rows = self.gaps[:, None] + offset
            following = numbers.states[1:, offset]
            values = x[following.ravel().tolist()]
            self.slope_terms.append(self._constant(rows, following, 1.0))
            for source in sources:
                there = source >= 0
                picked = x[np.maximum(source, 0).ravel().tolist()]
                values = values - ca.DM(there.ravel().astype(float)) * picked
                self.slope_terms.append(self._constant(rows[there], source[there], -1.0))
            self.row_terms.append((rows.ravel(), values))

        if numbers.continuous:
            carry(7 + np.arange(size), [numbers.last])
        if structure.slides:
            before = np.full((structure.elements, 1), -1)
            joints = list(structure.joints)
            before[joints, 0] = numbers.states[joints, nx - 2]
            carry(np.array([nx - 2]), [numbers.stretch[:, None]])
            carry(np.array([nx - 1]), [numbers.states[:-1, nx - 1 :], before])

    def _held(self):
        for k, held in self.holders.items():
            rows, variables = np.array(self.held_rows[k]), held.variables
            values, slope, bent = held.functions
            given = self.x[variables.tolist()], held.parameters
            self.row_terms.append((rows, values(*given)))
            columns = np.tile(rows, len(variables)), np.repeat(variables, len(rows))
            self.slope_terms.append((*columns, slope(*given)))
            multipliers = self.multipliers[rows.tolist()]
            self._add_hessian(variables[None], bent(*given, multipliers))

    def _bounds(self, functions, variables, parameters, rows):
        """Bounds of ``functions`` (see ``rows.bounds``) over ``variables`` (bounds, c) and ``parameters`` (bounds or 1,
        …)."""
        value, slope, bent = functions
        given = self._take(variables), parameters
        self.row_terms.append((rows, ca.vec(*across(value, *given))))
        columns = np.tile(rows, variables.shape[1]), variables.T.ravel()
        self.slope_terms.append((*columns, ca.vec(*across(slope, *given))))
        (bent,) = across(bent, *given, self.multipliers[rows.tolist()])
        self._add_hessian(variables, bent)

    def _contacts(self):
        numbers, count = self.numbers, self.structure.contacts
        strains = [numbers.first, numbers.last] if numbers.continuous else [numbers.first]
        variables = np.hstack([numbers.states[:-1, :7], *(each[:, :2] for each in strains)])
        given = ca.reshape(self.places, arms.PARAMETERS, count * len(variables)).T
        rows = np.array(self.contact_rows).ravel()
        self._bounds(
            arms.functions(variables.shape[1]), np.repeat(variables, count, axis=0), given, rows
        )

    def _links(self):
        """Between nodes and elements of the rod itself, after the rows of all stages."""
        links = np.array(self.structure.links)
        places = self.numbers.states[:, :3]
        variables = np.hstack([places[links[:, 0]], places[links[:, 1]], places[links[:, 1] + 1]])
        given = ca.reshape(self.links, contact.LINK_PARAMETERS, len(links)).T
        functions = bounds(contact.link_gap, variables.shape[1], contact.LINK_PARAMETERS)
        self._bounds(functions, variables, given, self.link_rows)

    def _bends(self):
        places = np.concatenate([np.array(each, int) for each in self.bent_at])
        variables = places[:, None] + np.arange(2)
        limit = self.named["curvature_limit"]
        self._bounds(bounds(bend_left, 2, 1), variables, limit, np.array(self.bend_rows))
