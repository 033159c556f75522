# SPDX-License-Identifier: LGPL-2.1-or-later
"""Between the nodes of a rod and the vectors of its program."""

import numpy as np

from ..geometry import rotation
from .nlp import SCHEMES, Nlp, pack
from .shape import Shape


def variables(nlp: Nlp, shape: Shape) -> np.ndarray:
    """Decision vector of a shape whose nodes are the program's."""
    kept = list(nlp.structure.strains)
    strain = shape.strain[:, kept]
    nodes = np.hstack([shape.position, shape.quaternion])
    if SCHEMES[nlp.structure.scheme].STRAIN_IS_STATE:
        nodes, controls = np.hstack([nodes, strain]), strain[1:]
    else:
        controls = (strain[1:] + strain[:-1]) / 2
    return np.concatenate([np.hstack([nodes[:-1], controls]).ravel(), nodes[-1]])


def multipliers(nlp: Nlp, shape: Shape) -> np.ndarray:
    """Multipliers of a shape with known forces and moments (zero for a guess)."""
    lam = np.zeros(len(nlp.equality))
    if shape.force is None:
        return lam
    spins = _spins(shape.quaternion)
    for k, row in enumerate(nlp.gaps):
        lam[row : row + 3] = shape.force[k + 1]
        lam[row + 3 : row + 7] = 2 * shape.moment[k + 1] @ spins[k + 1]
    return lam


def shape_of(nlp: Nlp, values: dict, steps, x, lam) -> Shape:
    """Nodes, internal forces and moments of a solved program.

    With the gap r_{k+1} − F, its multipliers are the internal force n at node k+1, and, as a turn δφ changes a
    quaternion by ½ δφ ∘ q, the moment is m·e = ½ λ·(e ∘ q). At the first node both follow from the balance of the
    first element. Curvature at the nodes is that of the moment there (Rᵀm = K(κ − κ⁰)).
    """
    states, _ = nlp.split(x)
    nodes = np.array([state[:7] for state in states])
    position, quaternion = nodes[:, :3], nodes[:, 3:]
    quaternion = quaternion / np.linalg.norm(quaternion, axis=1)[:, None]
    weight = values["weight"]
    rows = np.array(nlp.gaps)[:, None] + np.arange(7)
    gap = lam[rows]
    force = np.vstack([gap[0, :3] + steps[0] * weight, gap[:, :3]])
    moment = np.einsum("kij,kj->ki", _spins(quaternion[1:]), gap[:, 3:]) / 2
    mean = nlp.first_mean(x, pack(values, steps)).full().ravel()
    first = (
        moment[0]
        + rotation.cross(position[1] - position[0], force[1])
        + rotation.cross(mean, weight) * steps[0]
    )
    moment = np.vstack([first, moment])
    arc_length = np.concatenate([[0.0], np.cumsum(steps)])
    arc_length[-1] = 1.0
    strain = strains(nlp.structure, values, quaternion, force, moment)
    return Shape(arc_length, position, quaternion, strain, force, moment)


def strains(structure, values, quaternion, force, moment) -> np.ndarray:
    """(n+1, 6) strains that belong to internal forces and moments; natural where the model keeps none."""
    frames = rotation.matrix(quaternion)
    loads = np.hstack(
        [np.einsum("kij,ki->kj", frames, moment), np.einsum("kij,ki->kj", frames, force)]
    )
    result = np.tile(np.append(values["natural"], np.zeros(3)), (len(loads), 1))
    kept = list(structure.strains)
    result[:, kept] += loads[:, kept] / values["stiffness"][kept]
    return result


def _spins(quaternion):
    """(n, 3, 4) rows e_i ∘ q."""
    w, x, y, z = quaternion.T
    return np.stack(
        [
            np.stack([-x, w, -z, y], axis=-1),
            np.stack([-y, z, w, -x], axis=-1),
            np.stack([-z, -y, x, w], axis=-1),
        ],
        axis=1,
    )
