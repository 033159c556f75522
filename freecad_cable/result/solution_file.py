# SPDX-License-Identifier: LGPL-2.1-or-later
"""The solution file: a solution as plain JSON data, in SI units. What is infinite or unknown is null."""

import math
from dataclasses import asdict

import numpy as np

from .solution import Load, Solution


def solution_data(solution: Solution) -> dict:
    """Plain data of a solution, fields as in the scene file's documentation."""
    radius = solution.min_bend_radius
    data = {
        "schema": 1,
        "status": solution.status.name.lower(),
        "message": solution.message,
        "length": solution.scene.rod.length,
        "nodes": None,
        "curvature": _plain(solution.curvature),
        "energy": None,
        "start_reaction": _load(solution.start_reaction),
        "end_reaction": _load(solution.end_reaction),
        "support_reactions": [_load(load) for load in solution.support_reactions],
        "min_bend_radius": radius
        and {
            "value": _plain(radius[0]),
            "arc_length": radius[1],
            "margin": _plain(solution.bend_radius_margin),
        },
        "twist": solution.twist,
        "formed": [asdict(piece) for piece in solution.formed],
        "contacts": [
            {
                "arc_length": c.arc_length,
                "obstacle": c.obstacle,
                "other_arc_length": c.other_arc_length,
                "force": _plain(c.force),
            }
            for c in solution.contacts
        ],
        "min_clearance": _plain(solution.min_clearance),
        "feasible_lengths": solution.feasible_lengths
        and {
            name: asdict(bound)
            for name, bound in zip(("shortest", "longest"), solution.feasible_lengths, strict=True)
        },
        "stable": solution.stable,
        "error_estimate": {"position": _plain(solution.position_error)},
        "balance": solution.balance and asdict(solution.balance),
        "model": {"left_out": list(solution.left_out), "kept": list(solution.kept)},
        "solver": solution.solver,
    }
    if solution.position is not None:
        data["nodes"] = {
            name: _plain(getattr(solution, name))
            for name in ("arc_length", "position", "quaternion", "force", "moment")
        }
        data["energy"] = asdict(solution.energy) | {"total": solution.energy.total}
    return data


def _load(load: Load | None):
    return load and {"force": _plain(load.force), "moment": _plain(load.moment)}


def _plain(value):
    """Lists for arrays, null for what JSON cannot say."""
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value
