# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs a study: the document is varied, read, and put back as it was; then the answer is written."""

import math
import tempfile
from contextlib import contextmanager
from functools import partial
from pathlib import Path

import FreeCAD
import Part

from ..equilibrium import find_equilibrium
from ..errors import CableError, DocumentError, ProblemError
from ..shape.centreline import centreline_wire
from ..shape.sweep import sweep_round
from ..shape.units import from_si
from ..study import (
    Parameter,
    Variation,
    corners,
    follow,
    motion,
    needed_length,
    random_cases,
)
from ..study import run as run_cases
from ..study.cases import Verdict, solution
from ..study.motion import apart, close_together
from ..study.variation import held_within, longer
from . import study_sheet
from .complaint import of_study
from .property_table import reset, wrong
from .stored_solution import fingerprint, kept
from .study import held_tolerances, inputs, read_studied, recorded, solved_cable, values
from .varied import Family, Kept, varied_by


def run(study, executor=None):
    """Run a study and write its shapes, its spreadsheet, its plot and its numbers.

    ``executor`` of ``concurrent.futures`` or the like solves random cases and corners; None: here. In a window
    Escape stops it. The document is left as it was, also after an error; then the study has no answer and says why.
    Errors: ``DocumentError``."""
    document = study.Document
    if document.Recomputing:
        raise DocumentError(f"{study.Label} cannot be run while the document is recomputed.")
    document.recompute([study])
    try:
        chosen = recorded(study)
        if study.Kind == "Values":
            _run_values(study, chosen)
        else:
            _run_tolerance(study, chosen, executor)
    except ProblemError as error:
        _fail(study, str(of_study(study, error)))
    except CableError as error:
        _fail(study, str(error))
    except ReferenceError:
        _fail(
            study, f"{study.Label}: what it needs was deleted while it ran; all else is as it was."
        )
    except FreeCAD.Base.FreeCADAbort:
        _fail(study, f"{study.Label} was stopped; the document is as it was.")
    except Exception as error:
        # Of an executor, say: it goes on to whoever brought that, and no earlier answer passes as one of this run.
        study.Proxy.forget(study, f"{study.Label}: {type(error).__name__}: {error}")
        raise
    finally:
        study.purgeTouched()


def _fail(study, sentence):
    study.Proxy.forget(study, sentence)
    raise DocumentError(sentence) from None


def _run_values(study, chosen):
    cable, wanted = solved_cable(study), values(study)
    scene = read_studied(study, cable)
    if study.FindNeededLength and not scene.spans:
        raise wrong(
            study,
            "FindNeededLength",
            "is on, but an end is free, so that any length would do; turn it off, or hold both ends.",
        )
    varied = varied_by(study)
    needed, notes = None, []
    # It is asked for Escape only while it goes on, so it has as many steps as it takes.
    count = len(wanted) * (2 if study.FindNeededLength else 1)
    with Kept(varied), _progress(study, count) as tick:
        family = Family(cable, varied)
        _check_effect(study, family, wanted)
        start = kept(cable, scene)
        steps = []
        for step in follow(
            family.scene, wanted, start=start if _is_at(scene, family, wanted) else None
        ):
            steps.append(step)
            tick()
        if not any(step.solved for step in steps):
            raise DocumentError(f"{study.Label}: {steps[0].row.error}")
        drawn = steps
        if study.Draw == "Envelope":
            drawn = close_together(family.scene, steps, scene.rod.radius, tick)
            notes += _open(drawn, 2 * scene.rod.radius)
        if study.FindNeededLength:
            scene_at = partial(family.scene, asks_length=True)
            try:
                needed = needed_length(scene_at, wanted, tick=tick)
            except CableError as error:
                sentence = of_study(study, error) if isinstance(error, ProblemError) else error
                notes.append(f"No length will do everywhere. {sentence}")
    found = motion(steps)
    reset(study, study.Proxy.TABLE)
    _draw(study, scene.rod.radius, [(step.value, step.solution) for step in drawn if step.solved])
    radius, force, clearance = (
        found.smallest_bend_radius,
        found.largest_end_force,
        found.smallest_clearance,
    )
    study.SmallestBendRadiusValue, study.SmallestBendRadius = (
        radius[0],
        from_si("length", radius[1]),
    )
    study.LargestEndForceValue, study.LargestEndForce = force
    if clearance is not None:
        study.SmallestClearanceValue = clearance[0]
    study.SmallestClearance = math.inf if clearance is None else from_si("length", clearance[1])
    if needed is not None:
        study.NeededLength, study.NeededLengthValue = from_si("length", needed.length), needed.value
        study.AllowedLength = from_si("length", needed.longest)
        if not needed.feasible:
            notes.append(
                f"No length will do everywhere: {needed.value:.6g} needs {study.NeededLength.UserString}, and "
                f"{needed.longest_value:.6g} allows {study.AllowedLength.UserString}."
            )
    study.JumpValues = [jump.value for jump in found.jumps]
    rows = [step.row for step in steps]
    said = [study_sheet.note(cable, row) for row in rows]
    study.Notes = notes + [
        f"{row.values[0]:.6g}: {text}" for row, text in zip(rows, said, strict=True) if text
    ]
    name = f"{varied.path} [{varied.unit_text}]" if varied.unit_text else varied.path
    if study.VariedObject not in (None, cable):
        name = f"{study.VariedObject.Label} {name}"
    study_sheet.write(study, [name], rows, chosen)
    _plot(study, study_sheet.plot(study, name, rows, found.jumps, scene.rod.min_bend_radius))
    _finish(study, cable, scene)


def _open(steps, diameter):
    """Notes on gaps of an envelope through which the cable could slip unseen."""
    for before, after, moved in apart(steps, diameter):
        yield (
            f"The envelope is open between {before:.6g} and {after:.6g}: there shapes next to each other are up to "
            f"{from_si('length', moved):.3g} mm apart."
        )


def _check_effect(study, family, wanted):
    """A number that the cable does not depend on would give a family of one shape."""
    lengths = (False, True) if study.FindNeededLength else (False,)
    prints = set()
    # The ends of a range and its middle mostly tell.
    for value in (wanted[0], wanted[-1], wanted[len(wanted) // 2], *wanted):
        try:
            prints.add(fingerprint([family.scene(value, asks) for asks in lengths]))
        except DocumentError:
            return  # the rows will say so
        if len(prints) > 1:
            return
    if len(set(wanted)) > 1:
        raise wrong(
            study,
            "VariedProperty",
            f"is {study.VariedProperty}, which does not change the cable; choose a number that it depends on.",
        )


def _is_at(scene, family, wanted):
    """Whether the first value is that of the document, whose shape is then the start."""
    try:
        return fingerprint(family.scene(wanted[0])) == fingerprint(scene)
    except DocumentError:
        return False


def _run_tolerance(study, chosen, executor):
    cable = solved_cable(study)
    scene = read_studied(study, cable)
    variations = _variations(study, scene)
    drawn = study.Kind == "Random"
    cases = random_cases(variations, study.Cases, study.Seed) if drawn else corners(variations)
    nominal = find_equilibrium(scene, start=kept(cable, scene))
    rows = []
    with _progress(study, cases.count) as tick:
        for row in run_cases(scene, cases, start=nominal, executor=executor):
            rows.append(row)
            tick()
    verdict = Verdict.of(rows)
    shapes = [(0.0, nominal)]
    try:
        worst = solution(scene, cases, verdict.worst, nominal)
    except ProblemError:
        worst = None  # its row says why
    if worst is not None and worst.position is not None:
        shapes.append((1.0, worst))
    reset(study, study.Proxy.TABLE)
    _draw(study, scene.rod.radius, shapes)
    study.Share, study.WorstCase = verdict.share, verdict.worst + 1
    if cases.seed is not None:
        study.ShareBetween = list(verdict.between)
    radii = [row.smallest_bend_radius for row in rows if row.smallest_bend_radius is not None]
    study.SmallestBendRadius = from_si("length", min(radii, default=0.0))
    study.LargestEndForce = max(
        (max(row.start_force, row.end_force) for row in rows if row.end_force is not None),
        default=0.0,
    )
    clearances = [row.smallest_clearance for row in rows if row.smallest_clearance is not None]
    study.SmallestClearance = from_si("length", min(clearances, default=math.inf))
    said = study_sheet.note(cable, rows[verdict.worst]) or "it holds with the least margin."
    study.Notes = [
        f"{verdict.holding} of {verdict.count} cases hold.",
        f"Row {verdict.worst + 1} is the worst: {said}",
    ]
    names = [_name(each.parameter) for each in variations]
    study_sheet.write(study, names, rows, chosen)
    _plot(study, study_sheet.histogram(study, rows, scene.rod.min_bend_radius))
    _finish(study, cable, scene)


def _variations(study, scene):
    found = [longer(scene)] if study.LengthTolerance else []
    distance, angle = held_tolerances(study)
    for place, end in (("start", scene.start), ("end", scene.end)):
        if hasattr(end, "position") and (distance or angle):
            found += held_within(scene, place, distance, angle)
    factor = study.StiffnessFactor
    if not 1 <= factor < math.inf:
        raise wrong(study, "StiffnessFactor", f"is {factor:g}; it must be at least 1.")
    if factor > 1:
        stiffness = Parameter(field="cable.stiffness", how="scale")
        found.append(Variation(stiffness, 1 / factor, factor, "log"))
    if not found:
        raise wrong(study, "LengthTolerance", "is off, and there is no other tolerance; give one.")
    return found


def _name(parameter):
    """Of a column; positions in m, angles in rad, as the core has them."""
    axis = (
        parameter.axis
        if isinstance(parameter.axis, str) or parameter.axis is None
        else "xyz"[int(abs(parameter.axis).argmax())]
    )
    unit = {"move": "m", "add": "m", "turn": "rad"}.get(parameter.how)
    words = [parameter.field, parameter.how, axis or "", f"[{unit}]" if unit else ""]
    return " ".join(filter(None, words))


@contextmanager
def _progress(study, count):
    """A function that counts; in a window it raises ``FreeCADAbort`` when Escape was pressed."""
    bar = FreeCAD.Base.ProgressIndicator()
    bar.start(f"{study.Label}…", count)
    try:
        yield lambda: bar.next(True)
    finally:
        bar.stop()


def _draw(study, radius, shapes):
    drawn = []
    for _, each in shapes:
        if study.Draw == "Centrelines":
            drawn.append(centreline_wire(each))
            continue
        try:
            drawn.append(sweep_round(each, radius))
        except DocumentError:
            drawn.append(centreline_wire(each))  # a true picture; a broken solid would be none
    study.Shape = Part.makeCompound(drawn)
    study.DrawnValues = [value for value, _ in shapes]


def _plot(study, text):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "study.svg"
        path.write_text(text, encoding="utf-8")
        study.Plot = str(path)


def _finish(study, cable, scene):
    study.StudiedInputs = inputs(study, cable, scene)
    study.OutOfDate, study.Status = False, ""
