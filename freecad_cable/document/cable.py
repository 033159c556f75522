# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cable: reads its scene, has it solved, keeps the answer, sweeps the solid."""

from pathlib import Path

import FreeCAD
import Part
from FreeCAD import Placement, Vector

from ..errors import CableError, DocumentError, ProblemError, SolverMissingError
from ..options import EFFECTS
from ..shape.centreline import centreline_wire
from ..shape.profile import profile
from ..shape.sweep import sweep_profile, sweep_round
from ..status import Status
from . import cut, results, solving, stored_solution
from .complaint import in_properties, in_words
from .doubts import doubts
from .property_table import Prop, wrong
from .proxy import IncompleteError, OutdatedError, Proxy, in_use
from .read_scene import read_scene
from .reference import rebase
from .stored_solution import fingerprint, keep, nodes

PROFILE_DECIMALS = 7
"""Of the coordinates of a profile in mm: OCCT's smallest distance."""


class Cable(Proxy):
    """A flexible cable between two terminals."""

    TABLE = (
        Prop("CableType", "LinkGlobal", "Cable", "What the cable is made of"),
        Prop("Start", "Link", "Cable", "Terminal where the cable starts"),
        Prop("End", "Link", "Cable", "Terminal where the cable ends"),
        Prop("Supports", "LinkList", "Cable", "What holds the cable on its way, in order along it"),
        Prop(
            "Obstacles",
            "XLinkSubList",
            "Cable",
            "Parts, assemblies, links to them and other cables that the cable must not enter",
        ),
        Prop(
            "Clearance",
            "Distance",
            "Cable",
            "Least distance between the surface of the cable and the obstacles",
            unit="mm",
        ),
        Prop(
            "LengthMode",
            "Enumeration",
            "Cable",
            "Fixed: the length is given. Slack: it follows from the distance of the terminals, measured over the "
            "supports. Shortest: the least that keeps bend radius and clearance",
            "Fixed",
            choices=("Fixed", "Slack", "Shortest"),
        ),
        Prop("Length", "Distance", "Cable", "Length of the unloaded cable", "500 mm", unit="mm"),
        Prop(
            "Slack",
            "Float",
            "Cable",
            "(length - distance) / distance, with the straight way from terminal to terminal over the supports; "
            "0.1 is 10 %",
            0.1,
        ),
        Prop(
            "BendRadiusMode",
            "Enumeration",
            "Cable",
            "Check: warn where the cable bends more sharply than its type allows. Enforce: form it so that it does not",
            "Check",
            choices=("Check", "Enforce"),
        ),
        Prop(
            "Gravity",
            "Vector",
            "Cable",
            "Acceleration of gravity in m/s^2, in the coordinates of the container of the cable",
            Vector(0, 0, -9.81),
        ),
        Prop(
            "Tolerance",
            "Float",
            "Cable",
            "Error of position asked for, relative to the length",
            1e-4,
        ),
        Prop(
            "Update",
            "Enumeration",
            "Cable",
            "When it is solved. Manual: when asked to. On recompute: with the document. Live: also by itself, when "
            "what holds it moves in the window",
            "On recompute",
            choices=solving.UPDATES,
        ),
        *(
            Prop(
                f"Keep{effect.capitalize()}",
                "Bool",
                "Model",
                f"Compute {effect} also where the cable does not seem to need it",
                False,
            )
            for effect in EFFECTS
        ),
        Prop(
            "Profile",
            "LinkGlobal",
            "Cable",
            "Closed sketch swept instead of a circle: its x and y turn with the axes of the section",
        ),
        Prop(
            "Centreline",
            "LinkHidden",
            "Cable",
            "Its centreline, drawn as a wire of its own",
            result=True,
        ),
        *cut.TABLE,
        *results.TABLE,
        *stored_solution.TABLE,
    )

    follows_placements = True

    solution = None
    """the last, as long as the document is open: a file has only its nodes"""

    def onDocumentRestored(self, obj):
        super().onDocumentRestored(obj)
        if obj.Centreline and obj.Centreline.Cable is not obj:
            obj.Centreline = None  # of the cable this one is a copy of

    def set_editor_modes(self, obj):
        # The terminals decide.
        obj.setEditorMode("Placement", 2)
        obj.setEditorMode("Length", 0 if obj.LengthMode == "Fixed" else 2)
        obj.setEditorMode("Slack", 0 if obj.LengthMode == "Slack" else 2)
        for name in ("ShortestLength", "LongestLength", "LengthLimits"):
            obj.setEditorMode(name, 1 if obj.LengthMode == "Shortest" else 2)
        obj.setEditorMode("FormedPlaces", 1 if obj.BendRadiusMode == "Enforce" else 2)

    def onChanged(self, obj, name):
        if name in ("LengthMode", "BendRadiusMode") and in_use(obj):
            self.set_editor_modes(obj)
        elif name == "Obstacles":
            self.rebase_references(obj)

    def rebase_references(self, obj):
        rebase(obj, "Obstacles")

    def mustExecute(self, obj):
        """Also untouched: its solve was stopped, or had not ended when the file was written."""
        return in_use(obj) and obj.OutOfDate and obj.Update != "Manual"

    def run(self, obj):
        self.set_editor_modes(obj)
        if not obj.Placement.isIdentity():
            obj.Placement = Placement()
        scene = read_scene(obj)
        inputs = fingerprint(scene)
        if obj.SolvedInputs == inputs:
            solving.drop(obj)
        else:
            solution = _solved(obj, scene, inputs)
            if solution is None:
                self._wait(obj)
                return
            if not solution.status.success:
                raise _unsolved(obj, solution)
            keep(obj, solution)
            results.write(obj, solution)
            obj.SolvedInputs = inputs
        obj.OutOfDate = False
        results.write_status(obj, scene)
        cut.write(obj)
        self._sweep(obj, scene, inputs)

    def clear(self, obj, sentence):
        # First, so that whoever hears of the rest knows that it is no answer.
        obj.SolvedInputs = obj.SweptInputs = ""
        super().clear(obj, sentence)
        solving.drop(obj)

    def _wait(self, obj):
        """The last good answer stays, and says that it is an old one."""
        obj.OutOfDate = True
        obj.Status = solving.why_waiting(obj)

    def _sweep(self, obj, scene, inputs):
        try:
            inputs = f"{inputs} {_section(obj)}"
            if obj.SweptInputs == inputs and not obj.Shape.isNull():
                return
            shape = _solid(obj, scene.rod.radius)
        except DocumentError as error:
            # The numbers hold, and a line is a true picture of them; a broken solid would not be.
            obj.SweptInputs = ""
            obj.Shape = centreline_wire(nodes(obj))
            raise IncompleteError(str(error)) from None
        obj.Shape, obj.SweptInputs = shape, inputs


def _solved(obj, scene, inputs):
    try:
        return solving.solution(obj, scene, inputs)
    except ProblemError as error:
        raise in_properties(obj, error) from None
    except SolverMissingError as error:
        # It ends with the command that installs it; this is where FreeCAD looks for what it does not bring.
        folder = Path(FreeCAD.getUserAppDataDir()) / "AdditionalPythonPackages"
        kind = OutdatedError if obj.SolvedInputs else DocumentError
        raise kind(f'{obj.Label}: {error} --target "{folder}"') from None
    except CableError as error:
        raise DocumentError(f"{obj.Label}: {error}") from None
    except (ArithmeticError, ValueError) as error:
        broken = f"{obj.Label}: the solver broke off: {error}."
        advice = "Check lengths, stiffness and mass for a wrong unit."
        raise DocumentError(" ".join([broken, advice, *doubts(obj.CableType)])) from error


def _unsolved(obj, solution):
    """The core names fields of its scene, a user knows properties; a wrong unit may be why."""
    field, _, complaint = solution.message.partition(": ")
    if field == "cable.length":
        return in_properties(obj, ProblemError(field, complaint))
    message = in_words(obj, solution.message)
    if solution.status is Status.INFEASIBLE and obj.LengthMode == "Shortest":
        return wrong(obj, "LengthMode", f"is Shortest. {message}")
    return DocumentError(" ".join([f"{obj.Label}: {message}", *doubts(obj.CableType)]))


def _section(obj):
    """Fingerprint of the section that is swept."""
    if obj.Profile is None:
        return "round"
    try:
        return fingerprint(
            profile(getattr(obj.Profile, "Shape", Part.Shape())).outlines, PROFILE_DECIMALS
        )
    except DocumentError as error:
        raise wrong(obj, "Profile", f"{obj.Profile.Label}: {error}") from None


def _solid(obj, radius):
    try:
        if obj.Profile:
            return sweep_profile(nodes(obj), obj.Profile.Shape)
        return sweep_round(nodes(obj), radius)
    except DocumentError as error:
        raise DocumentError(f"{obj.Label}: {error}") from None
