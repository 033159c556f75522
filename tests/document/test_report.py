# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report: its order, its numbers, its page and its spreadsheet."""

import shutil
import tempfile
from html.parser import HTMLParser
from pathlib import Path

from FreeCAD import Placement, Rotation, Vector
from scenes import DocumentTest

from freecad_cable.document import make, report
from freecad_cable.document.report.tables import tolerance
from freecad_cable.errors import DocumentError

Verdict = report.Verdict

VOID = {"meta", "br", "img"}


class Page(HTMLParser):
    """Tags, the text, and whether every tag is closed where it should be."""

    def __init__(self, text):
        super().__init__(convert_charrefs=True)
        self.open, self.tags, self.references, self.words = [], [], [], []
        self.feed(text)
        self.close()
        self.text = " ".join(" ".join(self.words).split())

    def handle_starttag(self, tag, attributes):
        self.tags.append(tag)
        self.references += [v for k, v in attributes if k in ("href", "src") and v]
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        self.tags.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, tag

    def handle_data(self, data):
        if "style" not in self.open:
            self.words.append(data)


class ReportTest(DocumentTest):
    """An arch in the plane y = 0."""

    def setUp(self):
        super().setUp()
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        self.cable_between_pins()
        self.end.Roll = "180 deg"
        self.type.MinBendRadius = "20 mm"
        self.cable.Label = "Arch"
        self.compute()

    def entry(self, label="Arch"):
        self.doc.recompute()
        return next(e for e in report.collect(self.doc) if e.label == label)

    def page(self, **options):
        self.path = report.write(self.doc, self.folder, **options)
        page = Page(self.path.read_text(encoding="utf-8"))
        self.assertEqual(page.open, [])
        return page

    def other(self, label, **arguments):
        cable = make.cable(self.doc, start=self.start, end=self.end, **arguments)
        cable.Label, cable.Visibility = label, False
        return cable

    def test_the_worst_comes_first(self):
        loose = make.cable_type(self.doc, "Multi-core cable 7 mm")
        strict = make.cable_type(self.doc, "Multi-core cable 7 mm", min_bend_radius="21 mm")
        tight = make.cable_type(self.doc, "Multi-core cable 7 mm", min_bend_radius="60 mm")
        self.other("Short", cable_type=self.type, length="50 mm")
        self.other("No limit", cable_type=loose, length="300 mm")
        self.other("Tight", cable_type=tight, length="300 mm")
        self.other("Less margin", cable_type=strict, length="300 mm")
        self.doc.recompute()
        found = [(e.label, e.verdict) for e in report.collect(self.doc)]
        self.assertEqual(
            found,
            [
                ("Short", Verdict.NOT_SOLVED),
                ("Tight", Verdict.FAILS),
                ("No limit", Verdict.UNKNOWN),
                ("Less margin", Verdict.HOLDS),
                ("Arch", Verdict.HOLDS),
            ],
        )
        page = self.page()
        places = [page.text.rindex(label) for label, _ in found[:3]]
        self.assertEqual(places, sorted(places))
        self.assertIn("120 mm apart", page.text)
        self.assertIn("is allowed.", page.text)
        self.assertIn("has no smallest bend radius", page.text)

    def test_numbers_are_those_of_the_cable(self):
        self.cable.StartAllowance, self.cable.RoundUpTo = "7 mm", "10 mm"
        entry = self.entry()
        cable = self.cable
        self.assertAlmostEqual(entry.allowed, 23.5, delta=1e-9)
        margin = (cable.SmallestBendRadius.Value - 23.5) / 23.5
        self.assertAlmostEqual(entry.relative_margin, margin, delta=1e-12)
        self.assertAlmostEqual(entry.straight, 120, delta=1e-9)
        self.assertEqual([load.place for load in entry.loads], ["Terminal", "Terminal001"])
        self.assertNear(entry.loads[-1].force, cable.EndForce)
        weight = 9.81 * cable.Mass
        upwards = sum(load.force.z for load in entry.loads)
        # Forces balance as well as the solve leaves them.
        self.assertAlmostEqual(upwards / weight, 1, delta=1e-3)
        text = self.page().text
        for said in (
            f"{cable.SmallestBendRadius.Value:.1f} mm at {cable.SmallestBendRadiusAt.Value:.1f} mm",
            "180.0 mm, 150.0 %",  # slack
            "Rounded up by 3.0 mm",
            "Cut length 310.0 mm +50/−0",
            f"{1e3 * cable.Mass:.2f} g",
        ):
            self.assertIn(said, text)

    def test_the_lines_are_the_cable_and_its_spline(self):
        entry = self.entry()
        for line, length, radius, delta in (
            # The solved length is that of the polyline; the tightest place lies between two samples.
            (entry.line, 300, self.cable.SmallestBendRadius.Value, 1e-3),
            (entry.spline, entry.spline_length, entry.spline_radius, 1e-2),
        ):
            chords = sum(
                a.distanceToPoint(b) for a, b in zip(line.points, line.points[1:], strict=False)
            )
            self.assertAlmostEqual(chords / length, 1, delta=delta)
            self.assertAlmostEqual(max(line.curvature) * radius, 1, delta=delta)
        route = make.route(self.doc, self.cable)
        self.compute()
        self.assertAlmostEqual(entry.spline_length, route.Length.Value, delta=1e-9)
        self.assertAlmostEqual(entry.spline_radius, route.SmallestBendRadius.Value, delta=1e-9)

    def test_stretches_and_supports(self):
        plate, edge = self.plate("Plate", (60, 0, 100), (1, 0, 0))
        ring = make.ring(self.doc, (plate, edge), offset=Placement())
        ring.Label = "Hole & <b>edge</b>"
        self.cable.Supports = ring
        self.compute()
        entry = self.entry()
        self.assertEqual([place for place, _ in entry.stretches], [ring.Label, "Terminal001"])
        self.assertAlmostEqual(sum(length for _, length in entry.stretches), 300, delta=1e-9)
        self.assertGreater(entry.straight, 120)
        self.assertEqual(len(entry.loads), 3)
        page = self.page()
        self.assertIn(f"… to {ring.Label}", page.text)

    def test_nothing_from_outside_and_labels_stay_text(self):
        self.cable.Label = "<script>alert(1)</script>\"'&"
        self.type.Label = "<img src=x>"
        self.pin("<b>", (60, 0, 40))
        page = self.page()
        self.assertNotIn("script", page.tags)
        self.assertNotIn("b", set(page.tags) - {"b"})
        self.assertIn(self.cable.Label, page.text)
        self.assertIn(self.type.Label, page.text)
        self.assertEqual({r[0] for r in page.references}, {"#"})
        text = self.path.read_text(encoding="utf-8")
        for outside in ("http", "url(", "@import", "<link"):
            self.assertNotIn(outside, text)

    def test_a_picture_of_the_window_is_inside(self):
        picture = self.folder / "picture.png"
        picture.write_bytes(b"\x89PNG")
        page = self.page(picture=picture)
        (source,) = (r for r in page.references if not r.startswith("#"))
        self.assertEqual(source, "data:image/png;base64,iVBORw==")

    def test_everything_moves_with_its_assembly(self):
        before = self.entry()
        assembly = self.doc.addObject("App::Part", "Assembly")
        outer = self.doc.addObject("App::Part", "Outer")
        assembly.addObjects([self.left, self.right, self.start, self.end])
        assembly.addObject(self.cable)
        outer.addObject(assembly)
        assembly.Placement = Placement(Vector(3, -4, 5), Rotation(Vector(1, 2, -3), 20))
        outer.Placement = Placement(Vector(7, 0, 0), Rotation(Vector(0, 1, 0), 50))
        after = self.entry()
        where = outer.Placement * assembly.Placement
        self.assertNear(after.centre, where.multVec(before.centre), 1e-3)
        force = where.Rotation.multVec(before.loads[0].force)
        self.assertNear(after.loads[0].force, force, 1e-6 * force.Length)
        self.assertNear(after.line.points[50], where.multVec(before.line.points[50]), 1e-3)
        self.assertNear(after.supports[1][1], where.multVec(Vector(120, 0, 0)), 1e-9)

    def test_interference_and_clearance(self):
        top = max(point.z for point in self.entry().line.points)
        box = self.doc.addObject("Part::Box", "Roof")
        box.Placement.Base = Vector(55, -5, top + 3.5 + 4)
        entry = self.entry()
        self.assertEqual((entry.verdict, entry.nearest), (Verdict.HOLDS, "Roof"))
        self.assertAlmostEqual(entry.clearance, 4, delta=0.1)
        self.cable.Clearance = "6 mm"
        entry = self.entry()
        self.assertEqual(entry.verdict, Verdict.FAILS)
        self.assertIn("from Roof; its clearance is 6 mm", *entry.failures)
        self.cable.Clearance = 0
        box.Placement.Base.z -= 6
        entry = self.entry()
        self.assertIn("It enters Roof by ", *entry.failures)

    def test_the_spreadsheet(self):
        self.other("=Broken", cable_type=self.type, length="50 mm")
        self.page()
        sheet = self.doc.CableReport
        self.assertEqual(sheet.TypeId, "Spreadsheet::Sheet")
        columns = {sheet.get(f"{c}1"): c for c in "ABCDEFGHIJKLMNOPQRSTUVWXY"}
        self.assertEqual([sheet.get(f"A{i}") for i in (2, 3)], ["=Broken", "Arch"])
        self.assertIn("120 mm apart", sheet.get(f"{columns['What it says']}2"))
        with self.assertRaises(ValueError):
            sheet.get(f"{columns['Length [mm]']}2")
        for title, value in (
            ("Length [mm]", 300),
            ("Smallest bend radius [mm]", self.cable.SmallestBendRadius.Value),
            ("Force at end [N]", self.cable.EndForce.Length),
            ("Mass [g]", 1e3 * self.cable.Mass),
        ):
            self.assertAlmostEqual(sheet.get(f"{columns[title]}3") / value, 1, delta=1e-5)
        self.doc.removeObject(report.collect(self.doc)[0].cable.Name)
        self.page()
        self.assertIs(self.doc.CableReport, sheet)
        self.assertEqual(sheet.get("A2"), "Arch")
        with self.assertRaises(ValueError):
            sheet.get("A3")

    def test_a_cable_that_is_not_computed_shows_no_numbers(self):
        self.cable.Length = "310 mm"
        (entry,) = report.collect(self.doc)
        self.assertEqual(entry.verdict, Verdict.NOT_SOLVED)
        self.assertIn("out of date", entry.sentence)
        self.assertIn("310.0", self.page().text)

    def test_a_cable_that_is_solved_only_when_asked_shows_no_old_numbers(self):
        self.cable.Update = "Manual"
        self.cable.Length = "310 mm"
        text = self.page().text
        self.assertIn("Not solved: 1", text)
        self.assertIn("Out of date: Update is Manual", text)
        self.assertNotIn("300.0", text)

    def test_a_document_without_cables(self):
        for obj in (self.cable.Centreline, self.cable):
            self.doc.removeObject(obj.Name)
        self.assertIn("The document has no cables.", self.page().text)

    def test_a_folder_that_is_none(self):
        place = self.folder / "file"
        place.write_text("")
        with self.assertRaisesRegex(DocumentError, "cannot be written.*file.*another folder"):
            report.write(self.doc, place)
        with self.assertRaisesRegex(DocumentError, "none.png"):
            report.write(self.doc, self.folder, picture=self.folder / "none.png")

    def test_tolerances_of_the_cut_length(self):
        for length, more in ((300, 25), (301, 50), (1500, 50), (3000, 100), (7500, 150)):
            self.assertEqual(tolerance(length), more)
        self.assertAlmostEqual(tolerance(10000), 500, delta=1e-9)
