# SPDX-License-Identifier: LGPL-2.1-or-later
"""A study in the tree: one number of the document over a range, or a tolerance, and what the cable does.

It is made by ``studying.run``, not by a recompute: a recompute may change no other object, and a study does for a
while."""

import math
from dataclasses import replace

from ..errors import DocumentError
from ..problem import Scene
from ..shape.units import to_si
from ..study import length_tolerance
from .child import CABLE, Child
from .obstacles import read_boxes, read_obstacles
from .property_table import Checked, Prop, wrong
from .proxy import in_use, proxy_of
from .read_held import read_held
from .read_scene import read_scene
from .stored_solution import PLACE_DECIMALS, fingerprint
from .study_sheet import COLUMNS

NOT_RUN = "No results yet; Run Study makes them."
OLD = "Out of date; Run Study brings it up to date."
WITHOUT_SHEET = "Its spreadsheet is not there; Run Study writes it anew."

SETTINGS = (
    Prop(
        "Kind",
        "Enumeration",
        "Study",
        "Values: one number of the document over a range. Random: cases within the tolerances. Corners: all "
        "combinations of their bounds",
        "Values",
        choices=("Values", "Random", "Corners"),
    ),
    Prop(
        "VariedObject",
        "LinkGlobal",
        "Values",
        "The object that has the number, a joint or a sheet as well; empty: the cable",
    ),
    Prop(
        "VariedProperty",
        "String",
        "Values",
        "The number: Length, Placement.Base.x, Constraints.width, or a cell of a spreadsheet; of the cable also "
        "StiffnessScale, a factor of its stiffness, and GravityTurn.x, y or z, degrees",
        "Length",
    ),
    Prop("From", "Float", "Values", "First value, as FreeCAD computes: mm, degrees", 0.0),
    Prop("To", "Float", "Values", "Last value", 0.0),
    Prop("Count", "Integer", "Values", "Number of values from first to last", 9),
    Prop(
        "Values", "FloatList", "Values", "Values in their order, instead of first, last and number"
    ),
    Prop(
        "FindNeededLength",
        "Bool",
        "Values",
        "Search for the length that the worst value needs; takes longer",
        False,
    ),
    Prop(
        "Draw",
        "Enumeration",
        "Study",
        "Solids, centrelines, or the envelope: solids so close to each other that the gaps are less than the cable",
        "Centrelines",
        choices=("Solids", "Centrelines", "Envelope"),
    ),
    Prop(
        "Record",
        "StringList",
        "Study",
        "Columns of the spreadsheet, as Smallest bend radius, by their heads without units; empty: all",
    ),
    Prop(
        "LengthTolerance",
        "Bool",
        "Tolerance",
        "The cable may be as much too long as IPC/WHMA-A-620 allows: 50 mm up to 1.5 m",
        True,
    ),
    Prop(
        "PositionTolerance",
        "Distance",
        "Tolerance",
        "How far each terminal may be from its place, along each axis",
        unit="mm",
    ),
    Prop(
        "AngleTolerance",
        "Angle",
        "Tolerance",
        "How far each terminal may be turned, about each axis it holds",
        unit="deg",
    ),
    Prop(
        "StiffnessFactor",
        "Float",
        "Tolerance",
        "By what factor the cable may be stiffer or softer; 1: its stiffness is known",
        1.0,
    ),
    Prop("Cases", "Integer", "Tolerance", "Number of random cases", 200),
    Prop("Seed", "Integer", "Tolerance", "Number that the random cases follow from", 1),
)

RESULTS = tuple(
    Prop(name, kind, "Result", text, result=True)
    for name, kind, text in (
        ("SmallestBendRadius", "Distance", "Smallest bend radius of all shapes"),
        ("SmallestBendRadiusValue", "Float", "Value at which it is"),
        ("LargestEndForce", "Float", "Largest force of a connector on the cable, in N"),
        ("LargestEndForceValue", "Float", "Value at which it is"),
        ("SmallestClearance", "Distance", "Smallest clearance of all shapes; infinite without any"),
        ("SmallestClearanceValue", "Float", "Value at which it is"),
        ("NeededLength", "Length", "Length that the worst value needs"),
        ("NeededLengthValue", "Float", "Value at which it is needed"),
        ("AllowedLength", "Length", "Length that all values allow"),
        ("JumpValues", "FloatList", "Values at which the cable jumps to another shape, or buckles"),
        ("Notes", "StringList", "What happened, value by value"),
        ("Share", "Float", "Share of the cases that hold"),
        ("ShareBetween", "FloatList", "Between what that is for all cables, with 95 % confidence"),
        ("WorstCase", "Integer", "Row of the worst case; its shape is drawn with the nominal one"),
        ("DrawnValues", "FloatList", "Value of each shape that is drawn"),
    )
) + (
    Prop(
        "OutOfDate",
        "Bool",
        "Result",
        "Whether something has changed since the study was run",
        True,
        result=True,
    ),
    Prop("Status", "String", "Result", "What is wrong, or to be done", NOT_RUN, result=True),
)


class Study(Child):
    """What a cable does over a range or within tolerances."""

    TABLE = (
        CABLE,
        *SETTINGS,
        *RESULTS,
        Prop("Sheet", "LinkHidden", "Result", "Spreadsheet with a row for each value", result=True),
        Prop(
            "SheetSize",
            "IntegerList",
            "Result",
            "Columns and rows of the spreadsheet that are of the study; the other cells are the user's",
            result=True,
            hidden=True,
        ),
        Prop(
            "Plot", "FileIncluded", "Result", "The rows as a drawing, SVG", result=True, hidden=True
        ),
        Prop(
            "StudiedInputs",
            "String",
            "Result",
            "Fingerprint of what was studied",
            result=True,
            hidden=True,
        ),
    )

    def onDocumentRestored(self, obj):
        super().onDocumentRestored(obj)
        others = (each for each in obj.Document.Objects if each is not obj)
        if obj.Sheet and any(proxy_of(each, Study) and each.Sheet is obj.Sheet for each in others):
            obj.Sheet = None  # of the study this one is a copy of

    def set_editor_modes(self, obj):
        obj.setEditorMode("Placement", 2)

    def mustExecute(self, obj):
        """Also untouched, as it is when its spreadsheet is deleted."""
        return in_use(obj) and obj.Sheet is None and not obj.OutOfDate

    def run(self, obj):
        """A recompute looks whether the study is up to date; ``studying.run`` brings it there."""
        cable = self.linked_cable(obj)
        if not obj.StudiedInputs:
            obj.OutOfDate, obj.Status = True, NOT_RUN
            return
        changed = obj.StudiedInputs != inputs(obj, cable, read_studied(obj, cable))
        obj.OutOfDate = changed or obj.Sheet is None
        obj.Status = OLD if changed else "" if obj.Sheet else WITHOUT_SHEET

    def lose(self, obj, gone):
        """``gone`` is being deleted. Without an object it is a property of the cable that is varied, so the path, too,
        says that it was of another one."""
        if obj.VariedObject is gone:
            obj.VariedProperty = f"{gone.Label}.{obj.VariedProperty}"

    def clear(self, obj, sentence):
        """What it has found stays and says that it is old: the cable may be well again, and a run takes long."""
        obj.OutOfDate, obj.Status = True, sentence

    def forget(self, obj, sentence):
        """No shapes, no numbers, and the reason why."""
        super().clear(obj, sentence)
        obj.StudiedInputs = ""


def read_studied(study, cable) -> Scene:
    """The scene of the cable of a study, with all obstacles that a case within the tolerances may reach. Errors:
    ``DocumentError``."""
    if study.Kind == "Values":
        return read_scene(cable)  # each value reads its own
    scene = read_held(cable)
    if scene.asks_length and cable.SolvedLength.Value:
        # It is made as long as was found, and not anew for each case.
        rod = replace(scene.rod, length=to_si("length", cable.SolvedLength))
        scene = replace(scene, rod=rod, asks_length=False)
    distance, _ = held_tolerances(study)
    # What an end moves is as if the cable were longer by as much.
    more = 2 * math.sqrt(3) * distance
    if study.LengthTolerance:
        more += length_tolerance(scene.rod.length)
    longest = replace(scene, rod=replace(scene.rod, length=scene.rod.length + more))
    return replace(scene, obstacles=read_obstacles(cable, longest))


def held_tolerances(study) -> tuple[float, float]:
    """Of each terminal: [m] along each axis, [rad] about each that it holds. Errors: ``DocumentError``."""
    found = to_si("length", study.PositionTolerance), math.radians(study.AngleTolerance.Value)
    for name, value in zip(("PositionTolerance", "AngleTolerance"), found, strict=True):
        if not 0 <= value < math.inf:
            raise wrong(
                study, name, f"is {getattr(study, name).UserString}; it must be at least 0."
            )
    return found


def inputs(study, cable, scene) -> str:
    """Fingerprint of what a study depends on. Errors: ``DocumentError``."""
    settings = [getattr(study, prop.name) for prop in SETTINGS if "Link" not in prop.kind]
    plain = [getattr(value, "Value", value) for value in settings]
    # Which obstacles other values reach, only they can tell, so here all that stand around count, if roughly.
    around = read_boxes(cable) if study.Kind == "Values" else []
    # How other numbers follow from the one that is varied changes all other rows.
    follows = []
    if study.Kind == "Values":
        ground = sorted([cable, *cable.OutListRecursive], key=lambda obj: obj.Name)
        follows = [(obj.Name, obj.ExpressionEngine) for obj in ground if obj.ExpressionEngine]
    varied = getattr(study.VariedObject, "Name", "")
    return fingerprint([scene, plain, varied, follows, fingerprint(around, PLACE_DECIMALS)])


def recorded(study) -> list[tuple]:
    """Those of the columns that a study is to record. Errors: ``DocumentError``."""
    known = {column[0].partition(" [")[0]: column for column in COLUMNS}
    for name in study.Record:
        if name not in known:
            raise wrong(
                study, "Record", f"has {name}, which is no column; known are {', '.join(known)}."
            )
    return [known[name] for name in study.Record] or list(COLUMNS)


def values(study) -> list[float]:
    """Of a study over a range. Errors: ``DocumentError``."""
    if study.Values:
        for value in study.Values:
            if not math.isfinite(value):
                raise wrong(study, "Values", f"has {value}; they must be finite numbers.")
        return list(study.Values)
    for name in ("From", "To"):
        Checked(study, SETTINGS).number(name)
    if study.Count < 2:
        raise wrong(study, "Count", f"is {study.Count}; it must be at least 2.")
    if study.From == study.To:
        raise wrong(study, "To", f"is {study.To:g} and so is From; give a range, or Values.")
    step = (study.To - study.From) / (study.Count - 1)
    return [study.From + k * step for k in range(study.Count)]


def solved_cable(study):
    """The cable, solved and up to date. Errors: ``DocumentError``."""
    cable = study.Proxy.linked_cable(study)
    if not cable.SolvedInputs or cable.OutOfDate:
        raise DocumentError(cable.Status or f"{cable.Label} is not solved; recompute it.")
    return cable
