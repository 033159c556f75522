# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a cable shows of its solution. Lengths in FreeCAD's mm; where FreeCAD 0.20 has no type, plain SI numbers
with the unit in the text."""

import math

import numpy as np
from FreeCAD import Vector

from ..geometry import rotation
from ..result import Solution
from ..shape.units import from_si, vector_from_si
from ..status import Status
from .complaint import OBSTACLE, in_words
from .doubts import doubts, unknowns
from .obstacles import crowded
from .property_table import Prop
from .reference import pairs

ROUGHLY = 0.02
"""Of the radius of a cable, by which a clearance may fall short: solvers leave 1 % between nodes."""
MUCH_TWIST = 45.0
"""[deg] Twist from which it is said where it comes from, if nobody has asked for it."""

TABLE = tuple(
    Prop(name, kind, "Result", text, result=True)
    for name, kind, text in (
        ("SolvedLength", "Length", "Length of the unloaded cable"),
        ("ShortestLength", "Length", "Shortest length that keeps bend radius and clearance"),
        ("LongestLength", "Length", "Longest length that keeps bend radius and clearance"),
        ("LengthLimits", "StringList", "What forbids shorter and longer lengths, and where"),
        ("SmallestBendRadius", "Distance", "Smallest bend radius of the centreline"),
        (
            "SmallestBendRadiusAt",
            "Distance",
            "Distance of the tightest place from the start, along the cable",
        ),
        (
            "BendRadiusMargin",
            "Distance",
            "Smallest bend radius less the smallest one that the cable type allows; negative if it is violated",
        ),
        (
            "FormedPlaces",
            "StringList",
            "Where the cable must be formed to keep the enforced bend radius, and with what moment",
        ),
        ("StartForce", "Vector", "Force of the connector at the start on the cable, in N"),
        ("StartMoment", "Vector", "Moment of the connector at the start on the cable, in N m"),
        ("EndForce", "Vector", "Force of the connector at the end on the cable, in N"),
        ("EndMoment", "Vector", "Moment of the connector at the end on the cable, in N m"),
        (
            "SupportForces",
            "VectorList",
            "Forces of the supports on the cable, in their order, in N",
        ),
        (
            "SupportMoments",
            "VectorList",
            "Moments of the supports on the cable, in their order, in N m",
        ),
        ("ContactForces", "VectorList", "Forces of the obstacles on the cable, in N"),
        (
            "ContactPlaces",
            "FloatList",
            "Where they act: distances from the start, along the cable, in mm",
        ),
        ("ContactObstacles", "StringList", "What exerts them"),
        (
            "SmallestClearance",
            "Distance",
            "Least distance between the surface of the cable and an obstacle, where no terminal or support holds it; "
            "infinite if none is in reach",
        ),
        (
            "Twist",
            "Angle",
            "Angle by which the cable is twisted from its start to its end; between clamped ends their rolls make it",
        ),
        ("ElasticEnergy", "Float", "Energy of bending, torsion and stretch, in J"),
        (
            "GravityEnergy",
            "Float",
            "Energy of the weight, measured from the start against gravity, in J",
        ),
        ("Mass", "Float", "Mass of the cable, in kg"),
        ("CentreOfMass", "VectorDistance", "Centre of mass, in the coordinates of the container"),
        ("ErrorEstimate", "Length", "Estimate of the largest error of position"),
        (
            "BalanceResidual",
            "Float",
            "Largest residual of force and moment balance, recomputed from the nodes, relative to the loads",
        ),
        ("SolveTime", "Float", "Time of the last solve, in s"),
        ("ModelUsed", "StringList", "What the model has and what was left out of it, and why"),
        ("Stable", "Bool", "Whether the cable stays in this shape"),
        (
            "OutOfDate",
            "Bool",
            "Whether shape and numbers are those from before the last change, because it is not solved yet",
        ),
        ("Status", "String", "How the solve ended, and what to look at"),
    )
)

ITSELF = "the cable itself"
"""Among the obstacles that it touches."""

ANEW = "Found anew: no equilibrium was found that the last shape becomes"
"""Among what the model used."""


def write(cable, solution: Solution):
    """Write all results but the status."""
    rod = solution.scene.rod
    radius, place = solution.min_bend_radius
    energy, balance, solver = solution.energy, solution.balance, solution.solver
    cable.Twist = math.degrees(solution.twist)
    cable.SolvedLength = from_si("length", rod.length)
    cable.SmallestBendRadius = from_si("length", radius)
    cable.SmallestBendRadiusAt = from_si("length", place)
    cable.BendRadiusMargin = from_si("length", radius - (rod.min_bend_radius or 0.0))
    cable.FormedPlaces = [_formed(piece) for piece in solution.formed]
    _write_lengths(cable, solution.feasible_lengths)
    for name, load in (("Start", solution.start_reaction), ("End", solution.end_reaction)):
        setattr(cable, f"{name}Force", Vector(*load.force.tolist()))
        setattr(cable, f"{name}Moment", Vector(*load.moment.tolist()))
    reactions = solution.support_reactions
    cable.SupportForces = [Vector(*load.force.tolist()) for load in reactions]
    cable.SupportMoments = [Vector(*load.moment.tolist()) for load in reactions]
    _write_contacts(cable, solution)
    clearance = solution.min_clearance
    cable.SmallestClearance = math.inf if clearance is None else from_si("length", clearance)
    cable.ElasticEnergy = energy.bending + energy.torsion + energy.stretch
    cable.GravityEnergy = energy.gravity
    cable.Mass = rod.mass_per_length * rod.length
    cable.CentreOfMass = vector_from_si(_centre(solution))
    cable.ErrorEstimate = from_si("length", solution.position_error)
    cable.BalanceResidual = max(balance.force, balance.moment) if balance else 0.0
    cable.SolveTime = solver["solve_time"]
    cable.ModelUsed = [
        *(f"Kept: {sentence}" for sentence in solution.kept),
        *(f"Left out: {sentence}" for sentence in solution.left_out),
        f"Solved by {solver['name']}, scheme {solver['scheme']}, {solver['elements']} elements",
        *([ANEW] if solution.anew else []),
    ]
    cable.Stable = bool(solution.stable)


def write_status(cable, scene):
    """That it is solved, and warnings that do not make the shape wrong."""
    sentences = [Status.CONVERGED.value, *cable.LengthLimits, *cable.FormedPlaces]
    sentences += [*doubts(cable.CableType), *unknowns(cable.CableType), *crowded(scene)]
    if ANEW in cable.ModelUsed:
        sentences.append(
            "Warning: it does not lie as before: no equilibrium was found that its last shape becomes, and it may be "
            "too short to stay where it was. This one may be on another side of an obstacle, or have a turn more; look "
            "at it, or undo the change."
        )
    if any("rims of rings" in sentence for sentence in cable.ModelUsed):
        sentences.append(
            f"Warning: it passes a ring at an angle and is {-cable.SmallestClearance.Value:.2g} mm inside the rim of "
            "the hole; no shape was found that keeps clear of it, so widen the hole, or change the length or the ring."
        )
    elif _falls_short(cable, scene.rod.radius):
        sentences.append(
            f"Warning: its smallest clearance is {cable.SmallestClearance.Value:.3g} mm where "
            f"{cable.Clearance.Value:.4g} mm is asked for: what holds the cable there leaves it no more room."
        )
    sentences += _pushed_clear(cable)
    if abs(cable.Twist.Value) > MUCH_TWIST and not any(map(_is_turned, (cable.Start, cable.End))):
        sentences.append(_twisted(cable))
    # Enforced, it may lack what the mesh leaves between nodes.
    if cable.BendRadiusMode == "Check" and cable.BendRadiusMargin.Value < 0:
        sentences.append(_too_tight(cable))
    cable.Status = " ".join(sentences)


def _falls_short(cable, radius):
    short = cable.Clearance.Value - cable.SmallestClearance.Value
    return cable.Clearance.Value > 0 and short > ROUGHLY * from_si("length", radius)


def _pushed_clear(cable):
    if not cable.Clearance.Value:
        return
    for force, place, obstacle in zip(
        cable.ContactForces, cable.ContactPlaces, cable.ContactObstacles, strict=True
    ):
        if obstacle != ITSELF:
            yield (
                f"Warning: it keeps clear of {obstacle} at {place:.4g} mm from the start only because it is pushed "
                f"away with {force.Length:.3g} N, and nothing there does that: it would come nearer. Hold it there, or "
                "change its length."
            )
            return


def _is_turned(terminal):
    """Whether somebody says how a terminal is turned about its axis, or nothing does."""
    on_geometry = any(
        path.rpartition(".")[2].startswith(("Edge", "Face"))
        for _, path in pairs(terminal.Reference)
    )
    return terminal.Condition != "Clamped" or terminal.Roll.Value != 0 or not on_geometry


def _twisted(cable):
    return (
        f"Warning: it is twisted by {cable.Twist.Value:.0f}° because {cable.Start.Label} and {cable.End.Label} are "
        "Clamped, turned as the geometry of their parts happens to be; choose Swivel if the cable may turn while it is "
        "mounted, or set Roll."
    )


def _too_tight(cable):
    kind, radius = cable.CableType, cable.SmallestBendRadius.Value
    inside = kind.BendRadiusConvention == "Inside"
    if inside:
        radius -= kind.OuterDiameter.Value / 2
    limit = radius - cable.BendRadiusMargin.Value
    return (
        f"Warning: the tightest bend, {radius:.4g} mm at {cable.SmallestBendRadiusAt.Value:.4g} mm from the start, is "
        f"tighter than the {limit:.4g} mm that {kind.Label} allows "
        f"({'at the inside of the bend' if inside else 'at the centreline'})."
    )


def _write_lengths(cable, bounds):
    """What the length may be, if it was asked for."""
    shortest, longest = (from_si("length", bound.length) for bound in bounds) if bounds else (0, 0)
    cable.ShortestLength, cable.LongestLength = shortest, longest
    cable.LengthLimits = [in_words(cable, bound.sentence) for bound in bounds or ()]


def _write_contacts(cable, solution):
    contacts, obstacles = solution.contacts, solution.scene.obstacles
    cable.ContactForces = [Vector(*contact.force.tolist()) for contact in contacts]
    cable.ContactPlaces = [from_si("length", contact.arc_length) for contact in contacts]
    cable.ContactObstacles = [
        ITSELF
        if contact.obstacle is None
        else obstacles[contact.obstacle].place.removeprefix(OBSTACLE)
        for contact in contacts
    ]


def _formed(piece):
    start, end = (from_si("length", s) for s in (piece.start, piece.end))
    return (
        f"From {start:.4g} mm to {end:.4g} mm it keeps its bend radius only if it is formed there, with a moment of "
        f"{piece.moment:.3g} N m."
    )


def _centre(solution):
    """Centre of mass (3,) [m]: the integral of the Hermite curve through the nodes, order 4."""
    s, r = solution.arc_length, solution.position
    t = rotation.tangent(solution.quaternion)
    h = np.diff(s)[:, None]
    pieces = h / 2 * (r[:-1] + r[1:]) + h**2 / 12 * (t[:-1] - t[1:])
    return pieces.sum(axis=0) / (s[-1] - s[0])
