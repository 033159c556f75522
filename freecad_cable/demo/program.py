# SPDX-License-Identifier: LGPL-2.1-or-later
"""The demo from beginning to end."""

import contextlib
import os
import sys
import textwrap
import time
from pathlib import Path

import FreeCAD
import Import
import Part

from ..document import studying
from ..errors import CableError, DocumentError
from . import equipment, satellite, table, table_1
from .appearance import add_appearance
from .comparison import compare
from .family import Family
from .pictures import picture_curvature, picture_family, picture_shapes

SCENES = {"table-1": table_1, "equipment": equipment, "satellite": satellite}
"""Name of the files: module that builds the document."""

FAMILIES = {"table-1": [table_1.family]}
"""Name of the files: functions that make studies of the cables."""


def main(arguments):
    """Build and solve the demo, write it into the folder ``arguments[0]``, return the exit status.

    0, or 1 and a sentence on stderr if a cable has no sound solid or a file cannot be written.
    """
    folder = Path(arguments[0])
    begin = time.monotonic()
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with _only_ours() as say:
            files = [file for name in SCENES for file in _run(name, folder, say)]
            say(f"\nDone in {time.monotonic() - begin:.0f} s. The files in {folder}:")
            for file in files:
                say(f"  {file.name:<24}{file.stat().st_size / 1000:8.0f} kB")
    except (CableError, OSError) as error:
        print(f"The demo stopped: {error}", file=sys.stderr)
        return 1
    return 0


@contextlib.contextmanager
def _only_ours():
    """A function that prints, while what FreeCAD and OCCT print is dropped.

    They write percentages and statistics past Python, which would bury the progress.
    """
    sys.stdout.flush()
    with os.fdopen(os.dup(1), "w", encoding="utf-8") as ours, open(os.devnull, "w") as nothing:
        os.dup2(nothing.fileno(), 1)
        try:
            yield lambda line: print(line, file=ours, flush=True)
        finally:
            os.dup2(ours.fileno(), 1)


def _run(name, folder, say):
    """Build one document and write its files; returns their paths."""
    scene = SCENES[name]
    say(f"\n{scene.TITLE}\n")
    document = FreeCAD.newDocument()
    try:
        comparisons, cables = [], []
        begin = time.monotonic()
        for cable, route in scene.build(document):
            document.recompute()
            _check(cable, route)
            comparisons.append(compare(cable, route))
            cables.append(cable)
            say(f"  {cable.Label}: {time.monotonic() - begin:.2f} s. {cable.Status}")
            begin = time.monotonic()
        say("")
        for line in table.in_words(comparisons):
            say(f"  {line}")
        if scene.SHORTEST:
            say("")
            for line in textwrap.wrap(table.claim(comparisons), 100):
                say(f"  {line}")
        families = [_family(make, document, cables, say) for make in FAMILIES.get(name, ())]
        say("\n  writing the files")
        files = _write(folder / name, scene, document, cables, comparisons)
        for family in families:
            files += _write_family(folder / name, scene, document, family)
        return files
    finally:
        FreeCAD.closeDocument(document.Name)


def _family(make, document, cables, say):
    """A study, run. Errors: ``DocumentError``."""
    begin = time.monotonic()
    study = make(document, cables)
    studying.run(study)
    family = Family.of(study)
    say(f"\n  {study.Label}: {len(family.values)} values, {time.monotonic() - begin:.2f} s")
    return family


def _check(cable, route):
    """Errors: ``DocumentError`` if either failed or the cable has no sound solid."""
    for obj in (cable, route):
        if not obj.isValid():
            raise DocumentError(obj.Status)
    if not (cable.Shape.isValid() and cable.Shape.isClosed()):
        raise DocumentError(f"{cable.Label} has no valid closed solid.")


def _write(stem, scene, document, cables, comparisons):
    """The files, named ``stem`` and more."""
    ends = (".FCStd", ".step", ".csv", "-shapes.png", "-curvature.png")
    store, step, rows, shapes, curvature = files = [stem.with_name(stem.name + end) for end in ends]
    store.unlink(missing_ok=True)  # or FreeCAD keeps a copy beside it
    document.saveAs(str(store))
    add_appearance(store, document)
    Import.export([*scene.parts(document), *cables], str(step))
    table.write_csv(rows, comparisons)
    picture_shapes(shapes, scene.TITLE, comparisons, _solids(scene, document), scene.VIEW)
    picture_curvature(
        curvature, "Curvature of the same cables and routes", comparisons, scene.COLUMNS
    )
    return files


def _write_family(stem, scene, document, family):
    """The files of a study."""
    rows, picture = (stem.with_name(f"{stem.name}-family{end}") for end in (".csv", ".png"))
    family.write_csv(rows)
    picture_family(picture, family, _solids(scene, document), scene.VIEW)
    return [rows, picture]


def _solids(scene, document):
    return [solid for part in scene.parts(document) for solid in Part.getShape(part).Solids]
