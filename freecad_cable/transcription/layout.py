# SPDX-License-Identifier: LGPL-2.1-or-later
"""Between the nodes of a rod and the vectors of its program."""

import numpy as np

from ..geometry import rotation
from . import arms
from .nlp import SCHEMES, Nlp
from .shape import Joint, Shape


def variables(nlp: Nlp, shape: Shape) -> np.ndarray:
    """Decision vector of a shape whose nodes are the program's."""
    structure, numbers = nlp.structure, nlp.numbers
    kept, joints = list(structure.strains), list(structure.joints)
    nodes, x = [shape.position, shape.quaternion], np.empty(numbers.size)
    if numbers.continuous:
        strain = shape.strain[:, kept]
        nodes.append(strain)
        x[numbers.last] = strain[1:]
        for joint in shape.joints:
            x[numbers.first[joint.node]] = joint.strain[kept]
    else:
        x[numbers.first] = shape.strains_between()[:, kept]
    if structure.slides:
        places = shape.arc_length[structure.ends]
        lengths = np.diff(places)
        stretch = np.searchsorted(joints, np.arange(structure.elements + 1), "left")
        nodes += [lengths[stretch][:, None], places[stretch][:, None]]
        x[numbers.stretch[joints]] = lengths[1:]
    x[numbers.states] = np.hstack(nodes)
    return x


def multipliers(nlp: Nlp, shape: Shape, weight) -> np.ndarray:
    """Multipliers of a shape with known forces and moments (zero for a guess); ``weight`` (3,) as in the parameters.

    Along a quaternion itself, where no moment says anything, they follow from stationarity in its norm: what it rotates
    an element by (see ``element.rotate``) is quadratic in it.
    """
    lam = np.zeros(len(nlp.equality))
    if shape.force is None:
        return lam
    along = shape.position[1:] - shape.position[:-1]
    along = along - np.einsum("kji,kj->ki", rotation.matrix(shape.quaternion[:-1]), along)
    pulling = 2 * shape.force[1:] + shape.steps[:, None] * weight
    norm = np.append(np.cumsum(np.einsum("ki,ki->k", along, pulling)[::-1])[-2::-1], 0.0)[:, None]
    quaternion = shape.quaternion[1:]
    turning = rotation.multiply(_pure(2 * shape.moment[1:]), quaternion) + norm * quaternion
    lam[nlp.carried] = np.hstack([shape.force[1:], turning])
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


def shape_of(nlp: Nlp, values: dict, parameters, steps, x, lam) -> Shape:
    """Nodes, internal forces and moments of a solved program; ``parameters`` are ``values`` packed.

    With the gap r_{k+1} − F, its multipliers are the internal force n at node k+1, and, as a turn δφ changes a
    quaternion by ½ δφ ∘ q, the moment is m·e = ½ λ·(e ∘ q) = ½ (λ ∘ q⁻¹)·e. At the first node of a stretch both follow
    from the balance of its first element. Curvature at the nodes is that of the moment there (Rᵀm = K(κ − κ⁰)).
    """
    structure = nlp.structure
    arc_length, position, quaternion = places(nlp, steps, x)
    weight = values["weight"]
    gap = lam[nlp.carried]
    force, moment = np.zeros((2, len(position), 3))
    force[1:] = gap[:, :3]
    moment[1:] = rotation.multiply(gap[:, 3:], rotation.conjugate(quaternion[1:]))[:, 1:] / 2
    firsts = np.array([0, *structure.joints])
    beyond = firsts + 1
    lengths = (arc_length[beyond] - arc_length[firsts])[:, None]
    means = nlp.mean_function(x, parameters)[0].reshape(3, -1).T
    pushed, turned = _pushes(nlp, values, x, lam, firsts)
    leaving = force[beyond] + lengths * weight + pushed
    turning = (
        moment[beyond]
        + rotation.cross(position[beyond] - position[firsts], force[beyond])
        + rotation.cross(means, weight) * lengths
        + turned
    )
    force[0], moment[0] = leaving[0], turning[0]
    after = None
    if structure.bend_limit:
        # Where the limit acts, the moment no longer tells the curvature.
        strain, after = _read_strains(nlp, values, x)
    else:
        strain = strains(structure, values, quaternion, force, moment)
        if structure.joints:
            after = strains(structure, values, quaternion[firsts], leaving, turning)
    joints = tuple(
        Joint(node, after[j], force[node] - leaving[j], moment[node] - turning[j])
        for j, node in enumerate(structure.joints, start=1)
    )
    return Shape(arc_length, position, quaternion, strain, force, moment, joints)


def _pushes(nlp, values, x, lam, elements):
    """Force and moment about the first node (k, 3) that obstacles exert on some elements."""
    if not nlp.structure.contacts:
        return 0.0, 0.0
    push = -lam[nlp.contact_rows[elements]][..., None]
    touched = arms.read(nlp, x, values["arms"][elements], elements)
    return tuple((push * part).sum(axis=1) for part in (touched.slope, touched.turn))


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
    loads = np.stack([moment, force], axis=1) @ rotation.matrix(quaternion)
    loads, kept = loads.reshape(-1, 6), list(structure.strains)
    result = np.zeros_like(loads)
    result[:, :3] = values["natural"]
    result[:, kept] += loads[:, kept] / values["stiffness"][kept]
    return result


def _pure(vectors):
    """(n, 4) quaternions without a real part."""
    found = np.zeros((len(vectors), 4))
    found[:, 1:] = vectors
    return found
