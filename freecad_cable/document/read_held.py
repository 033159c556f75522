# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the properties of a cable and of what holds it to the scene that states its problem, without obstacles."""

from dataclasses import replace

from ..equilibrium.length_samples import longest
from ..errors import DocumentError, ProblemError
from ..geometry import rotation
from ..options import EFFECTS, SolveOptions
from ..problem import Clamped, Free, Pinned, Scene, Swivel
from ..problem.reach import chord_through
from ..shape.units import from_si, placement_to_si, to_si
from .cable_type import CableType
from .complaint import in_properties
from .property_table import Checked, wrong
from .proxy import proxy_of
from .read_supports import read_supports
from .reference import container
from .terminal import Terminal

PATIENCE = 20.0
"""Seconds after which a solve gives up: the window stands still meanwhile."""


def read_held(cable, asks_length=False) -> Scene:
    """The scene of a cable without obstacles, in the coordinates of its container. ``asks_length``: as if its
    ``LengthMode`` were Shortest. Errors: ``DocumentError``."""
    terminals = _terminals(cable)
    mode = "Shortest" if asks_length else cable.LengthMode
    checked = Checked(cable, cable.Proxy.TABLE)
    try:
        start, end = (_end(*item) for item in zip(("start", "end"), terminals, strict=True))
        supports = read_supports(cable, start, end)
        return Scene(
            rod=_rod(cable, checked, mode, start, supports, end),
            start=start,
            end=end,
            supports=supports,
            gravity=list(cable.Gravity),
            clearance=to_si("length", checked.number("Clearance", at_least=0)),
            enforce_bend_radius=cable.BendRadiusMode == "Enforce",
            asks_length=mode == "Shortest",
            options=SolveOptions(
                tolerance=checked.number("Tolerance"),
                keep=tuple(each for each in EFFECTS if getattr(cable, f"Keep{each.capitalize()}")),
                time_limit=PATIENCE,
            ),
        )
    except ProblemError as error:
        raise in_properties(cable, error) from None


def _terminals(cable):
    found = []
    for name in ("Start", "End"):
        terminal = getattr(cable, name)
        if terminal is None:
            raise wrong(
                cable, name, "is empty; choose a terminal. One that is Free lets the end hang."
            )
        if proxy_of(terminal, Terminal) is None:
            raise wrong(
                cable, name, f"is {terminal.Label}, which is no cable terminal; choose a terminal."
            )
        if terminal.Status:
            raise DocumentError(terminal.Status)
        if container(terminal) is not container(cable):
            raise wrong(
                cable,
                name,
                f"is {terminal.Label}, which is in another part or assembly than the cable; put both into the same.",
            )
        found.append(terminal)
    if found[0] is found[1]:
        raise wrong(
            cable, "End", f"is {found[0].Label} and so is Start; choose two different terminals."
        )
    return found


def _end(place, terminal):
    """The end condition, with d3 from start to end."""
    if terminal.Condition == "Free":
        return Free(place=place)
    position, quaternion = placement_to_si(terminal.Frame)
    if place == "end":
        # A terminal looks out of its part, and the cable runs into it.
        quaternion = rotation.backwards(quaternion)
    if terminal.Condition == "Pinned":
        return Pinned(position, place=place)
    if terminal.Condition == "Swivel":
        return Swivel(position, rotation.tangent(quaternion), place=place)
    return Clamped(position, quaternion, place=place)


def _rod(cable, checked, mode, start, supports, end):
    kind = cable.CableType
    proxy = proxy_of(kind, CableType)
    if proxy is None:
        said = "is empty" if kind is None else f"is {kind.Label}, which is no cable type"
        raise wrong(cable, "CableType", f"{said}; choose a cable type.")
    straight = None
    if isinstance(start, Pinned) and isinstance(end, Pinned):
        straight = chord_through([held.position for held in (start, *supports, end)])
    rod = proxy.rod(kind, _length(cable, checked, mode, straight))
    if mode == "Shortest":
        # No obstacle in the reach of the longest that is tried may be left out.
        rod = replace(rod, length=longest(straight, rod))
    if cable.BendRadiusMode == "Enforce" and rod.min_bend_radius is None:
        raise wrong(
            cable,
            "BendRadiusMode",
            f"is Enforce, but {kind.Label} has no limit; set its MinBendRadius, or use Check.",
        )
    if straight is not None and not supports and not rod.axial_stiffness and rod.length < straight:
        raise wrong(
            cable,
            "Length",
            f"is {_mm(rod.length)}, but the terminals are {_mm(straight)} apart; the shortest possible length is "
            f"{_mm(straight)}. Make the cable longer or bring the terminals closer.",
        )
    return rod


def _length(cable, checked, mode, straight):
    """[m] Where it is asked for, the shortest that is possible."""
    if mode == "Fixed":
        return to_si("length", checked.number("Length", above=0))
    slack = checked.number("Slack", at_least=0) if mode == "Slack" else 0.0
    if not straight:
        reason = "the terminals are at the same point" if straight == 0 else "an end is free"
        raise wrong(
            cable,
            "LengthMode",
            f"is {mode}, but {reason}, so there is no straight distance; use Fixed.",
        )
    return straight * (1 + slack)


def _mm(length):
    return f"{from_si('length', length):.6g} mm"
