# SPDX-License-Identifier: LGPL-2.1-or-later
"""Places between nodes that keep away from obstacles.

A place on an element is where an arm from its first node points, r + R(q)(arm + b₀ κ₀ × e₃ + b₁ κ₁ × e₃), with the
curvatures of both of its nodes: exact for the shape that it was made for, and to third order in the length of the arm
near it. Rows over the state and the control of one stage alone keep the structure of the program.

A cable slides freely along itself, so its distance from a feature is that of the nearest place, wherever that goes.
Along the tangent T of the place, g is smallest at g − ½ (∇g·T)²/g'', with g'' how it bends along the cable. Without
that a place would have to climb an edge that it slides across, as if there were friction.
"""

from dataclasses import dataclass
from functools import lru_cache

import casadi as ca
import numpy as np

from ..geometry import rotation
from . import contact
from .element import rotate, upper
from .element_functions import SCHEMES

PARAMETERS = contact.PARAMETERS + 9
"""feature (12), arm (3), tangent in the frame of the node (3), b₀, b₁, 1/g'' (0 where the place may not slide)"""
FEATURE, ARM, TANGENT, BENT, SLIDES = slice(12), slice(12, 15), slice(15, 18), slice(18, 20), 20


@lru_cache(maxsize=4)
def functions(variables: int):
    """Of a row p (21,), as ``rows.bounds`` has them: (v, p) → gap, (v, p) → its gradient, (v, p, λ) → upper triangle of
    λ times its Hessian. v: position and quaternion of the first node, and the first two of the strains that the element
    begins and, with 11 ``variables``, ends with.

    With J the Jacobian of the place and J' that of the tangent, H the Hessian of g, σ = 1/g'' and a = ∇g·T,

        ∇ = Jᵀ(∇g − σ a H T) − σ a J'ᵀ∇g
        ∇∇ = Jᵀ H J − σ a (Jᵀ H J' + J'ᵀ H J) − σ (∇a)(∇a)ᵀ + the bend of both in the quaternion

    The rotation of a vector is quadratic in the quaternion. Written so, it takes two thirds of the instructions of
    automatic differentiation.
    """
    v, row, lam = ca.SX.sym("v", variables), ca.SX.sym("p", PARAMETERS), ca.SX.sym("lam")
    q, share = v[3:7], ca.SX(2, variables - 7)
    for i in range(variables - 7):
        share[i % 2, i] = row[18 + i // 2]
    bend, unit = share @ v[7:], ca.SX.eye(3)
    arm, tangent, slides = row[ARM] + ca.vertcat(bend[1], -bend[0], 0), row[TANGENT], row[SLIDES]
    feature, sides = row[FEATURE], ca.horzcat(-unit[:, 1], unit[:, 0])
    place, ahead = v[:3] + rotate(q, arm), rotate(q, tangent)
    steepest = contact.steepest(place, feature)
    along = ca.dot(steepest, ahead)
    slid = slides * along
    pull = steepest - slid * _bent(feature, ahead)
    # Over position, quaternion and what the curvatures add to the arm.
    jacobian = ca.horzcat(unit, _turn(q, arm), *(rotate(q, side) for side in ca.horzsplit(sides)))
    ahead_jacobian = _turn(q, tangent)
    slope, steeper = jacobian.T @ pull, jacobian.T @ _bent(feature, ahead)
    slope[3:7] -= slid * ahead_jacobian.T @ steepest
    steeper[3:7] += ahead_jacobian.T @ steepest
    hessian = jacobian.T @ _bent(feature, jacobian) - slides * steeper @ steeper.T
    mixed = slid * jacobian.T @ _bent(feature, ahead_jacobian)
    hessian[:, 3:7] -= mixed
    hessian[3:7, :] -= mixed.T
    hessian[3:7, 3:7] += _quadratic(pull, arm) - slid * _quadratic(steepest, tangent)
    sideways = ca.horzcat(*(_quadratic(pull, side) @ q for side in ca.horzsplit(sides)))
    hessian[3:7, 7:] += sideways
    hessian[7:, 3:7] += sideways.T
    strained = ca.diagcat(ca.SX.eye(7), share)
    outputs = [
        contact.gap(place, feature) - slid * along / 2,
        ca.densify(strained.T @ slope),
        lam * upper(strained.T @ hessian @ strained),
    ]
    names, inputs = ("rows", "slope", "bent"), ([v, row], [v, row], [v, row, lam])
    return tuple(
        ca.Function(name, given, ca.cse([output]))
        for name, given, output in zip(names, inputs, outputs, strict=True)
    )


def _bent(feature, columns):
    """The Hessian of g times columns."""
    axis = feature[6:9]
    return feature[9] * columns - feature[10] * axis @ (axis.T @ columns)


def _quadratic(w, u):
    """Hessian of w·(R(q) u) over q."""
    across, mixed = ca.cross(u, w), w @ u.T
    vectors = 2 * (mixed + mixed.T) - 4 * ca.dot(w, u) * ca.SX.eye(3)
    return ca.blockcat([[ca.SX(1, 1), 2 * across.T], [2 * across, vectors]])


def _turn(q, u):
    """(3, 4) Jacobian of R(q) u over q."""
    unit = ca.SX.eye(3)
    return ca.vertcat(*((_quadratic(unit[:, i], u) @ q).T for i in range(3)))


@dataclass(frozen=True, eq=False)
class Places:
    """Places (n, c, 3) on the n elements of a shape, c on each, that keep away from ``features`` (n, c, 12) of
    obstacles: ``beyond`` (n, c) the first node of the element by an arc length, with ``tangent`` (n, c, 3); ``slides``
    (n, c) is 1/g'' or 0; ``owners`` (n, c) says which of the scene's obstacles it is, −1 for none."""

    features: np.ndarray
    position: np.ndarray
    tangent: np.ndarray
    beyond: np.ndarray
    slides: np.ndarray
    owners: np.ndarray


@dataclass(frozen=True, eq=False)
class Pushed:
    """Of m places that obstacles push: ``elements`` (m,), ``arc_length`` (m,), ``position`` (m, 3), ``gap`` (m,);
    ``features`` (m, 12), ``slides`` (m,) and ``owners`` (m,) as in ``Places``."""

    elements: np.ndarray
    arc_length: np.ndarray
    position: np.ndarray
    gap: np.ndarray
    features: np.ndarray
    slides: np.ndarray
    owners: np.ndarray


def rows(structure, shape, places) -> np.ndarray:
    """(n, c, 21) parameters of the ``places`` of a shape."""
    h = shape.steps[:, None]
    share = places.beyond**3 / (6 * h)
    bent = np.stack([places.beyond**2 / 2 - share, share], axis=-1)
    if SCHEMES[structure.scheme].STRAIN_IS_STATE:
        strains = shape.strains_at_ends()
    else:
        strains = [shape.strains_between()]
        bent = np.stack([bent.sum(axis=-1), np.zeros_like(share)], axis=-1)
    frames = rotation.matrix(shape.quaternion[:-1])
    seen = np.einsum("kji,kcj->kci", frames, places.position - shape.position[:-1, None])
    bend = sum(bent[..., i : i + 1] * each[:, None, :2] for i, each in enumerate(strains))
    arm = seen - np.stack([bend[..., 1], -bend[..., 0], np.zeros_like(share)], axis=-1)
    tangent = np.einsum("kji,kcj->kci", frames, places.tangent)
    parts = [places.features, arm, tangent, bent, places.slides[..., None]]
    return np.concatenate(parts, axis=-1)


@dataclass(frozen=True, eq=False)
class Touched:
    """Where the rows (n, c, 21) of a decision vector are: ``gap`` (n, c); how far, ``slid`` (n, c), and where to,
    ``position`` (n, c, 3), their places have slid; and the ``slope`` (n, c, 3) of the gap over that position, with its
    ``turn`` (n, c, 3) about the first node of the element."""

    gap: np.ndarray
    slid: np.ndarray
    position: np.ndarray
    slope: np.ndarray
    turn: np.ndarray


def read(nlp, x, given, elements=None) -> Touched:
    """Of the rows ``given`` (n, c, 21) to a program, at its decision vector; of some ``elements`` (n,), or all."""
    n, count, _ = given.shape
    each = given.reshape(-1, PARAMETERS)
    element = np.repeat(np.arange(n) if elements is None else elements, count)
    states = x[nlp.states[element]]
    frames = rotation.matrix(states[:, 3:7])
    strains = (x[strain[element][:, :2]] for strain in (nlp.numbers.first, nlp.numbers.last))
    bend = sum(each[:, i : i + 1] * strain for i, strain in zip((18, 19), strains, strict=True))
    arm = each[:, ARM] + np.column_stack([bend[:, 1], -bend[:, 0], np.zeros(len(bend))])
    lever = np.einsum("kij,kj->ki", frames, arm)
    tangent = np.einsum("kij,kj->ki", frames, each[:, TANGENT])
    place, features = states[:, :3] + lever, each[:, FEATURE]
    steepest = contact.slope(place, features)
    along = np.einsum("ki,ki->k", steepest, tangent)
    slid = -each[:, SLIDES] * along
    slope = steepest + slid[:, None] * contact.bent(tangent, features)
    turn = rotation.cross(lever, slope) + slid[:, None] * rotation.cross(tangent, steepest)
    found = (
        contact.value(place, features) + slid * along / 2,
        slid,
        place + slid[:, None] * tangent,
        slope,
        turn,
    )
    return Touched(*(part.reshape(n, count, *part.shape[1:]) for part in found))
