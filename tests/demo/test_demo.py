# SPDX-License-Identifier: LGPL-2.1-or-later
"""The demo, run once into a folder: its files against its documents."""

import contextlib
import csv
import tempfile
import unittest
import zipfile
from pathlib import Path
from xml.etree import ElementTree

import FreeCAD
import numpy as np
import Part
from FreeCAD import Vector

from freecad_cable.demo import equipment, harness, satellite, table, table_1
from freecad_cable.demo.comparison import SAMPLES, compare
from freecad_cable.demo.program import main
from freecad_cable.document.cable import Cable
from freecad_cable.document.proxy import proxy_of
from freecad_cable.document.route import Route
from freecad_cable.document.study import Study
from freecad_cable.equilibrium import find_equilibrium
from freecad_cable.problem import Clamped, Rod, Scene

CONTENTS = {"table-1": (table_1, 4), "equipment": (equipment, 10), "satellite": (satellite, 9)}
"""Name of the files: module that builds the document, number of cables."""


def setUpModule():
    global folder, status
    temporary = tempfile.TemporaryDirectory()
    unittest.addModuleCleanup(temporary.cleanup)
    folder = Path(temporary.name) / "a new" / "folder"
    status = main([str(folder)])


@contextlib.contextmanager
def opened(name):
    """A document of the demo, opened from its file, with its pairs (cable, route)."""
    document = FreeCAD.openDocument(str(folder / f"{name}.FCStd"))
    try:
        cables = [obj for obj in document.Objects if proxy_of(obj, Cable)]
        yield document, [(cable, _route(cable)) for cable in cables]
    finally:
        FreeCAD.closeDocument(document.Name)


def _route(cable):
    (route,) = {obj for obj in cable.InList if proxy_of(obj, Route)}
    return route


def equipment_solids(name, document):
    parts = CONTENTS[name][0].parts(document)
    return [solid for part in parts for solid in Part.getShape(part).Solids]


class DemoTest(unittest.TestCase):
    def test_says_that_it_went_well_and_leaves_all_files(self):
        self.assertEqual(status, 0)
        ends = (".FCStd", ".step", ".csv", "-shapes.png", "-curvature.png")
        expected = {name + end for name in CONTENTS for end in ends}
        expected |= {"table-1-family.csv", "table-1-family.png"}
        self.assertEqual({path.name for path in folder.iterdir()}, expected)
        for path in folder.glob("*.png"):
            self.assertEqual(path.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")

    def test_every_cable_is_a_sound_solid_that_bends_as_it_may(self):
        for name, (_, count) in CONTENTS.items():
            with opened(name) as (_, pairs):
                self.assertEqual(len(pairs), count)
                for cable, route in pairs:
                    with self.subTest(cable=cable.Label):
                        self.assertTrue(cable.isValid() and route.isValid(), cable.Status)
                        self.assertEqual(cable.Shape.ShapeType, "Solid")
                        self.assertTrue(cable.Shape.isValid() and cable.Shape.isClosed())
                        self.assertGreater(cable.Shape.Volume, 0)
                        self.assertGreaterEqual(cable.BendRadiusMargin.Value, 0)
                        self.assertTrue(cable.Stable)

    def test_every_cable_leaves_its_connectors_the_way_they_look(self):
        connectors = harness.CONNECTORS
        with opened("equipment") as (_, pairs):
            for cable, _ in pairs:
                run = harness.RUNS[cable.Label]
                faces = [f for f in cable.Shape.Faces if isinstance(f.Surface, Part.Plane)]
                for end in (connectors[run.start], connectors[run.end]):
                    with self.subTest(cable=cable.Label, end=end):
                        (face,) = [
                            f
                            for f in faces
                            if f.CenterOfMass.distanceToPoint(Vector(*end.centre)) < 1e-3
                        ]
                        # The end face looks back into the connector.
                        normal = np.array(face.normalAt(0, 0))
                        self.assertLess(np.linalg.norm(normal + end.direction), 1e-6)

    def test_no_cable_hits_the_equipment_or_another(self):
        with opened("equipment") as (document, pairs):
            solids = equipment_solids("equipment", document)
            self.assertGreater(len(solids), 2 * len(harness.CONNECTORS))
            lines = [compare(*pair).cable.points for pair in pairs]
            radii = [cable.CableType.OuterDiameter.Value / 2 for cable, _ in pairs]
            for k, (cable, _) in enumerate(pairs):
                # Without a twentieth at each end, where it touches its own plugs.
                free = lines[k][SAMPLES // 20 : -SAMPLES // 20]
                wire = Part.makePolygon([Vector(*point) for point in free])
                reach = wire.BoundBox
                reach.enlarge(radii[k])
                for solid in solids:
                    if solid.BoundBox.intersect(reach):
                        self.assertGreater(solid.distToShape(wire)[0], radii[k], cable.Label)
                for j in range(k):
                    apart = np.linalg.norm(lines[k][:, None] - lines[j], axis=2).min()
                    self.assertGreater(apart, radii[k] + radii[j], (cable.Label, pairs[j][0].Label))

    def test_step_file_holds_the_same_solids(self):
        for name in CONTENTS:
            with self.subTest(name), opened(name) as (document, pairs):
                solids = equipment_solids(name, document) + [cable.Shape for cable, _ in pairs]
                read = Part.read(str(folder / f"{name}.step"))
                self.assertEqual(len(read.Solids), len(solids))
                self.assertTrue(all(solid.isValid() for solid in read.Solids))
                written, found = (sorted(s, key=lambda s: s.Volume) for s in (solids, read.Solids))
                for one, other in zip(written, found, strict=True):
                    # OCCT takes what is within 1e-7 mm for the same, so all of a surface may be elsewhere by as much.
                    self.assertAlmostEqual(one.Volume, other.Volume, delta=1e-7 * one.Area)

    def test_csv_rows_are_the_values_of_the_document(self):
        for name in CONTENTS:
            with self.subTest(name), opened(name) as (_, pairs):
                with open(folder / f"{name}.csv", newline="", encoding="utf-8") as file:
                    head, *rows = csv.reader(file)
                self.assertEqual(len(head), len(set(head)))
                self.assertEqual(len(rows), len(pairs))
                for row, (cable, route) in zip(rows, pairs, strict=True):
                    got = dict(zip(head, row, strict=True))
                    self.assertEqual(got["cable"], cable.Label)
                    self.assertEqual(got["type"], cable.CableType.Label)
                    for column, value in {
                        "length [mm]": cable.SolvedLength.Value,
                        "spline length [mm]": route.Length.Value,
                        "difference [mm]": route.Length.Value - cable.SolvedLength.Value,
                        "difference [% of spline]": 100
                        * (1 - cable.SolvedLength.Value / route.Length.Value),
                        "bend radius [mm]": cable.SmallestBendRadius.Value,
                        "margin [mm]": cable.BendRadiusMargin.Value,
                        "spline bend radius [mm]": route.SmallestBendRadius.Value,
                        "solve time [s]": cable.SolveTime,
                    }.items():
                        self.assertAlmostEqual(float(got[column]), value, 9, column)

    def test_documents_open_with_everything_to_see(self):
        for name in CONTENTS:
            with self.subTest(name), opened(name) as (document, pairs):
                with zipfile.ZipFile(folder / f"{name}.FCStd") as file:
                    views = ElementTree.fromstring(file.read("GuiDocument.xml")).find(
                        "ViewProviderData"
                    )
                self.assertEqual(int(views.get("Count")), len(views))
                seen = {view.get("name") for view in views}
                solids = {obj.Name for obj in document.Objects if obj.TypeId == "Part::Feature"}
                studies = {obj.Name for obj in document.Objects if proxy_of(obj, Study)}
                self.assertEqual(len(studies), name == "table-1")
                self.assertLessEqual(
                    solids | studies | {obj.Name for pair in pairs for obj in pair}, seen
                )

    def test_table_1_is_the_problem_of_the_paper(self):
        """The same answer as from a scene written by hand in SI units."""
        with opened("table-1") as (_, pairs):
            for (cable, _), length in zip(pairs, (0.55, 0.64, 0.73, 0.82), strict=True):
                rod = Rod(
                    length=length,
                    radius=0.0035,
                    mass_per_length=1160 * np.pi * 0.0035**2,
                    bending_stiffness=10e6 * np.pi * 0.0035**4 / 4,
                    torsional_stiffness=20e6 * np.pi * 0.0035**4 / 2,
                )
                start = Clamped((0, 0, 0), (0.7071, 0.7071, 0, 0), place="start")
                end = Clamped((0.16, -0.235, 0.33), (0.5, 0.5, 0.5, 0.5))
                solution = find_equilibrium(Scene(rod=rod, start=start, end=end))
                # Two solves, each stopped at its tolerance of 1e-9 and stored with 16 digits.
                off = np.abs(np.array(cable.NodePosition) - solution.position).max()
                self.assertLess(off, 1e-6 * length)


class RefusalTest(unittest.TestCase):
    def test_a_folder_that_cannot_be_made_is_one_sentence_and_a_status(self):
        with tempfile.NamedTemporaryFile() as file:
            self.assertEqual(main([file.name]), 1)

    def test_text_columns_line_up(self):
        with opened("equipment") as (_, pairs):
            lines = list(table.in_words([compare(*pair) for pair in pairs]))
        self.assertEqual(len(lines), 2 + len(harness.RUNS))
        self.assertEqual(len({len(line) for line in lines[2:]}), 1)
