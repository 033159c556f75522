# SPDX-License-Identifier: LGPL-2.1-or-later
"""Between the nodes of a rod and the vectors of its program."""

import numpy as np

from ..geometry import rotation
from .nlp import SCHEMES, Nlp, pack
from .shape import Joint, Shape


def variables(nlp: Nlp, shape: Shape) -> np.ndarray:
    """Decision vector of a shape whose nodes are the program's."""
    structure = nlp.structure
    kept = list(structure.strains)
    strain = shape.strain[:, kept]
    nodes = [shape.position, shape.quaternion]
    continuous = SCHEMES[structure.scheme].STRAIN_IS_STATE
    if continuous:
        nodes.append(strain)
        controls = list(strain[1:])
    else:
        controls = list(_element_strains(shape)[:, kept])
    places = shape.arc_length[structure.ends]
    if structure.slides:
        stretch = np.searchsorted(structure.joints, np.arange(structure.elements + 1), "left")
        nodes += [np.diff(places)[stretch][:, None], places[stretch][:, None]]
    for j, joint in enumerate(shape.joints):
        first = joint.strain[kept]
        if not continuous:
            first = first[:0]
        length = np.diff(places)[j + 1 : j + 2] if structure.slides else first[:0]
        controls[joint.node] = np.concatenate([first, controls[joint.node], length])
    nodes = np.hstack(nodes)
    stages = [part for pair in zip(nodes, controls, strict=False) for part in pair]
    return np.concatenate([*stages, nodes[-1]])


def _element_strains(shape):
    """(n, 6) constant over each element: curvature and twist that turn one node's frame into the next."""
    strain = np.vstack([(part.strain[1:] + part.strain[:-1]) / 2 for part in shape.parts()])
    turns = rotation.multiply(rotation.conjugate(shape.quaternion[:-1]), shape.quaternion[1:])
    strain[:, :3] = rotation.logarithm(turns) / shape.steps[:, None]
    return strain


def multipliers(nlp: Nlp, shape: Shape, weight) -> np.ndarray:
    """Multipliers of a shape with known forces and moments (zero for a guess); ``weight`` (3,) as in the parameters.

    Along a quaternion itself, where no moment says anything, they follow from stationarity in its norm: what it rotates
    an element by (see ``element.rotate``) is quadratic in it.
    """
    lam = np.zeros(len(nlp.equality))
    if shape.force is None:
        return lam
    spins = _spins(shape.quaternion)
    along = np.diff(shape.position, axis=0)
    frames = rotation.matrix(shape.quaternion[:-1])
    along = along - np.einsum("kji,kj->ki", frames, along)
    pulled = 2 * (along * shape.force[1:]).sum(axis=1) + shape.steps * (along @ weight)
    norm = np.append(np.cumsum(pulled[::-1])[::-1], 0.0)
    turning = 2 * np.einsum("ki,kij->kj", shape.moment, spins) + norm[:, None] * shape.quaternion
    lam[nlp.gaps[:, None] + np.arange(7)] = np.hstack([shape.force, turning])[1:]
    return lam


def places(nlp: Nlp, steps, x):
    """Arc length (n+1,), position (n+1, 3) and unit quaternion (n+1, 4) of the nodes of a decision vector, from the
    element lengths that its program was given."""
    structure, states = nlp.structure, x[nlp.states]
    quaternion = states[:, 3:7] / np.linalg.norm(states[:, 3:7], axis=1)[:, None]
    if structure.slides:
        ends = structure.ends
        steps = np.concatenate(
            [
                steps[a:b] / steps[a:b].sum() * states[b, -2]
                for a, b in zip(ends, ends[1:], strict=False)
            ]
        )
    arc_length = np.concatenate([[0.0], np.cumsum(steps)])
    arc_length[-1] = 1.0
    return arc_length, states[:, :3], quaternion


def shape_of(nlp: Nlp, values: dict, steps, x, lam) -> Shape:
    """Nodes, internal forces and moments of a solved program.

    With the gap r_{k+1} − F, its multipliers are the internal force n at node k+1, and, as a turn δφ changes a
    quaternion by ½ δφ ∘ q, the moment is m·e = ½ λ·(e ∘ q). At the first node of a stretch both follow from the
    balance of its first element. Curvature at the nodes is that of the moment there (Rᵀm = K(κ − κ⁰)).
    """
    structure = nlp.structure
    parameters = pack(structure, values, steps)
    arc_length, position, quaternion = places(nlp, steps, x)
    weight = values["weight"]
    gap = lam[np.array(nlp.gaps)[:, None] + np.arange(7)]
    force = np.vstack([np.zeros(3), gap[:, :3]])
    moment = np.einsum("kij,kj->ki", _spins(quaternion[1:]), gap[:, 3:]) / 2
    moment = np.vstack([np.zeros(3), moment])
    firsts = [0, *structure.joints]
    lengths = np.diff(arc_length)[firsts][:, None]
    means = nlp.mean_function(x, parameters)[0].reshape(3, -1).T
    beyond = [node + 1 for node in firsts]
    leaving = force[beyond] + lengths * weight
    turning = (
        moment[beyond]
        + rotation.cross(position[beyond] - position[firsts], force[beyond])
        + rotation.cross(means, weight) * lengths
    )
    force[0], moment[0] = leaving[0], turning[0]
    strain = strains(structure, values, quaternion, force, moment)
    after = strains(structure, values, quaternion[firsts], leaving, turning)
    if structure.bend_limit:
        # Where the limit acts, the moment no longer tells the curvature.
        strain, after = _read_strains(nlp, values, x)
    joints = tuple(
        Joint(node, after[j], force[node] - leaving[j], moment[node] - turning[j])
        for j, node in enumerate(structure.joints, start=1)
    )
    return Shape(arc_length, position, quaternion, strain, force, moment, joints)


def _read_strains(nlp, values, x):
    """Strains (n+1, 6) of the nodes, and (stretches, 6) of the first nodes of stretches, from a decision vector."""
    structure, kept = nlp.structure, list(nlp.structure.strains)
    firsts, size = [0, *structure.joints], len(nlp.structure.strains)
    nx = nlp.states.shape[1]
    controls = nlp.states[:-1, :1] + nx + np.arange(size)
    natural = np.append(values["natural"], np.zeros(3))
    nodes, beyond = (np.tile(natural, (count, 1)) for count in (len(nlp.states), len(firsts)))
    if SCHEMES[structure.scheme].STRAIN_IS_STATE:
        nodes[:, kept] = x[nlp.states[:, 7 : 7 + size]]
        beyond[:, kept] = x[controls[firsts]]
    else:
        nodes[1:, kept] = x[controls]
        nodes[0], beyond[:, kept] = nodes[1], x[controls[firsts]]
    return nodes, beyond


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
