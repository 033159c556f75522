# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program as fatrop likes it: what holds the cable beyond its start yields a little.

fatrop satisfies an equation of a stage by the controls of the stages before it. A strain moves the end of its element
by h² and turns it by h, so for an equation of an end or a support huge strains follow; on fine meshes rounding then
makes matrices indefinite that are not, and fatrop corrects them without a limit, where no time limit reaches it. So
each of these equations g = 0 becomes g = e with a control e of its own that costs λ₀ e + ½ ρ e². Then e is
(λ − λ₀)/ρ, and nothing is left of it with the right λ₀: the augmented Lagrangian (Hestenes 1969; Powell 1969),
with a penalty on controls, where it bends no valley for the iteration to follow.

And fatrop corrects an indefinite matrix by a multiple of the identity, so variables must be of one kind: strains are
taken times √stiffness. Then all elastic energy is ½ |strain|², and what little a soft or taut cable has counts as much
as its positions.
"""

import casadi as ca
import numpy as np

from ..transcription.nlp import Nlp
from ..transcription.numeric import Numeric
from ..transcription.writer import from_triplets

RIGID = (1e10, 1e6, 1e5)
"""ρ, and others that are tried where it fails. Forces are of order one (see ``scaling``), and so are multipliers: one
solve leaves 1e-10 of the length. But 1e10 drowns in its rounding what little holds a cable that may nearly roll: fatrop
takes a minimum for none and creeps (15 of the 1000 random scenes of `benchmarks/extreme.py`; none with all three)."""
MORE_RIGID = 1e3
"""Factor for a cable that is so stiff itself that a yield is still more than ``SHARE`` of the one before."""
SHARE = 0.1
RUNAWAY = 1e6
"""Positions in lengths, strains in units of their own, that no cable has."""
WRUNG = 30.0
"""Strain over one element, in radians for its turn, that no cable has. Where one of the two is passed energy and rows
are infinite, so that no step leads there: powers of it overflow, and fatrop does not come back from that."""
RESTORING = 100.0
"""Multiple of the identity in the Hessian while fatrop restores feasibility, for which it asks for it without the
energy (λ_f = 0). Nothing else holds back strains and yields then: it went to places 150 lengths away, whose matrix no
correction made positive definite to rounding, and it corrects without a limit."""


class YieldingProgram:
    """``program``, ``derivatives`` and ``stage_sizes`` (nx, nu, ng) are what ``nlpsol`` takes for an ``Nlp``.

    ``own`` and ``yields`` index the decision vector: variables of the ``Nlp``, in units of their own, and yields.
    """

    def __init__(self, nlp: Nlp):
        self.rows, stages = _yielding(nlp)
        nx, nu, ng = (np.array(column) for column in zip(*nlp.stage_sizes, strict=True))
        more = np.bincount(stages, minlength=len(nx))
        self.stage_sizes = [column.tolist() for column in (nx, nu + more, ng)]
        self.own = np.arange((nx + nu).sum()) + np.repeat(np.cumsum(more) - more, nx + nu)
        self.size = int((nx + nu + more).sum())
        self.yields = np.setdiff1d(np.arange(self.size), self.own)
        self._kept = list(nlp.structure.strains)
        self._strain = nlp.numbers.strain_of + 1
        """(own,) which of 1 and the strains' units is that of a variable"""
        self._carried = nlp.strains_carried
        """(rows,) the same of a gap: fatrop wants next states in it as they are"""
        self._write(nlp)
        self._unpriced = self._write_unpriced(nlp)

    def _write(self, nlp):
        count, rows = nlp.p.numel(), self.rows
        x, p = ca.MX.sym("x", self.size), ca.MX.sym("p", count + len(rows) + len(self._kept) + 1)
        factor, lam = ca.MX.sym("lam_f"), ca.MX.sym("lam_g", len(nlp.equality))
        e, price = x[self.yields.tolist()], p[count : count + len(rows)]
        units, rigidity = ca.vertcat(1, p[count + len(rows) : -1]), p[-1]
        unit, per = units[self._strain.tolist()], 1 / units[self._carried.tolist()]
        at = x[self.own.tolist()] * unit, p[:count]

        def own(outputs, *given):
            inputs = [nlp.x, nlp.p, *nlp.multipliers][: len(given)]
            return ca.Function("own", inputs, outputs).call(given, False, True)

        (energy,), (gradient,) = own([nlp.f], *at), own([nlp.gradient], *at)
        # A function each: fatrop asks for the rows more often than for their Jacobian.
        (g,), (jacobian,) = own([nlp.g], *at), own([nlp.jacobian.nz[:]], *at)
        (turns,) = own([nlp.turns], *at)
        sane = ca.logic_and(_largest(x) < RUNAWAY, _largest(turns) < WRUNG)
        (hessian,) = own([nlp.hessian.nz[:]], *at, factor, per * lam)
        slope = ca.vertcat(gradient * unit, price + rigidity * e)
        slope = slope[np.argsort(np.append(self.own, self.yields)).tolist()]
        aside = ca.Sparsity.triplet(len(nlp.equality), len(rows), rows.tolist(), range(len(rows)))
        g = per * g - ca.MX(ca.DM(aside, 1)) @ e + ca.if_else(sane, 0, ca.inf)
        (bent_rows, bent_columns), (steep_rows, steep_columns) = nlp.places
        ones = ca.MX(ca.DM.ones(len(rows), 1))
        jacobian = from_triplets(
            (len(nlp.equality), self.size),
            np.append(steep_rows, rows),
            np.append(self.own[steep_columns], self.yields),
            ca.vertcat(per[steep_rows.tolist()] * jacobian * unit[steep_columns.tolist()], -ones),
        )
        hessian = from_triplets(
            (self.size, self.size),
            np.append(self.own[bent_rows], self.yields),
            np.append(self.own[bent_columns], self.yields),
            ca.vertcat(
                unit[bent_rows.tolist()] * hessian * unit[bent_columns.tolist()],
                factor * rigidity * ones,
            ),
        )
        hessian += ca.if_else(factor == 0, RESTORING, 0) * ca.MX.eye(self.size)
        yielded = ca.dot(price, e) + rigidity / 2 * ca.sumsqr(e)
        f = ca.if_else(sane, energy + yielded, ca.inf)
        self.program = {"x": x, "p": p, "f": f, "g": g}
        # The plug-in's form of the Hessian has a gradient, which it never reads.
        self.derivatives = derivatives(
            [x, p, factor, lam],
            slope={"grad_f_x": slope},
            rows={"g": g, "jac_g_x": jacobian},
            bent={"grad_gamma_x": ca.MX(self.size, 1), "hess_gamma_x_x": hessian},
        )

    def start(self, x, multipliers, units):
        """(decision vector without yields, multipliers) from those of the ``Nlp``."""
        found = np.zeros(self.size)
        found[self.own] = x / units[self._strain]
        return found, multipliers * units[self._carried]

    def read(self, found, multipliers, units):
        """(decision vector, multipliers) of the ``Nlp``."""
        return found[self.own] * units[self._strain], multipliers / units[self._carried]

    def parameters(self, given, multipliers, units, rigidity) -> np.ndarray:
        """Parameters of this program from those of the ``Nlp``, multipliers whose yields are to vanish, and ρ."""
        return np.concatenate([given, multipliers[self.rows], units[1:], [rigidity]])

    def units(self, parameters) -> np.ndarray:
        """Of positions and of strains: 1/√stiffness up to a power of two, with which nothing is rounded."""
        return np.append(1.0, np.exp2(np.rint(-np.log2(parameters[self._kept]) / 2)))

    def prices(self, x, parameters, multipliers) -> np.ndarray:
        """λ₀ that belong to a start with known multipliers of the gaps: those that leave least of the Lagrangian's
        gradient over the variables of their equations."""
        slopes, left = self._unpriced(x, parameters, multipliers)
        slopes = slopes.reshape(len(self.rows), len(left))
        return np.linalg.lstsq(slopes.T, -left, rcond=None)[0]

    def _write_unpriced(self, nlp):
        """(x, p, multipliers) → Jacobian of the equations that yield over their variables, and the Lagrangian's
        gradient over these without the multipliers of those equations."""
        own, lam = nlp.jacobian[self.rows.tolist(), :], nlp.multipliers[1]
        columns = np.unique(own.sparsity().get_triplet()[1]).tolist()
        known = ca.DM.ones(lam.shape)
        known[self.rows.tolist()] = 0
        left = (nlp.gradient + nlp.jacobian.T @ (known * lam))[columns]
        slopes = ca.densify(own[:, columns])
        return Numeric(ca.Function("unpriced", [nlp.x, nlp.p, lam], [slopes, left]))


def _largest(values):
    return ca.mmax(ca.fabs(values))


def derivatives(inputs, slope, rows, bent) -> dict:
    """Our derivatives in place of those that CasADi would make, under the names and in the form that the plug-ins ask
    for; ``inputs`` x, p, λ_f, λ."""
    names = ["x", "p", "lam_f", "lam_g"]

    def function(title, count, outputs):
        return ca.Function(
            title, inputs[:count], list(outputs.values()), names[:count], list(outputs)
        )

    return {
        "nlp_grad_f": function("nlp_grad_f", 2, slope),
        "nlp_jac_g": function("nlp_jac_g", 2, rows),
        "nlp_hess_l": function("nlp_hess_l", 4, bent),
    }


def _yielding(nlp):
    """Indices of the equations beyond the start that are no gaps, and the stages that they are of."""
    rows, stages = [], []
    for k, (_, _, ng) in enumerate(nlp.stage_sizes[1:], 1):
        end = nlp.row_starts[k + 1]
        own = [row for row in range(end - ng, end) if nlp.equality[row]]
        rows += own
        stages += [k] * len(own)
    return np.array(rows, int), np.array(stages, int)
