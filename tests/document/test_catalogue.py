# SPDX-License-Identifier: LGPL-2.1-or-later
"""The library of cable types: what is built in, and the user's own."""

import csv
import runpy
import shutil
import tempfile
from math import sqrt
from pathlib import Path
from unittest import mock

from scenes import DocumentTest

from freecad_cable.document import catalogue, make
from freecad_cable.errors import DocumentError

HEADER = ",".join(catalogue.COLUMNS)


class BuiltInTest(DocumentTest):
    def test_every_number_has_a_source_and_no_wrong_unit(self):
        self.assertGreaterEqual(len(catalogue.catalogue()), 15)
        for name, known in catalogue.catalogue().items():
            kind = make.cable_type(self.doc, name)
            self.compute()
            self.assertEqual(kind.Label, name)
            sources = dict(said.split(": ", 1) for said in kind.Provenance)
            given = {key for key, value in known.items() if str(value).split()[0] not in "0.0 []"}
            self.assertEqual(set(sources) | {"Provenance", "BendRadiusConvention"}, given)
            for source in sources.values():
                self.assertIn(source.split(",")[0], catalogue.KINDS)
                self.assertGreater(len(source), 20)
            warned = "placeholder" in " ".join(sources.values())
            self.assertEqual("Warning" in kind.Status, warned, kind.Status)
            self.assertNotIn("check its unit", kind.Status)

    def test_what_is_derived_from_the_construction_is(self):
        path = catalogue.BUILT_IN.with_name("derive_cable_types.py")
        derive = runpy.run_path(str(path))
        known = catalogue.catalogue()

        def near(name, prop, expected):
            # The table has two digits.
            value = float(known[name][prop].split()[0])
            self.assertAlmostEqual(value / expected, 1, delta=0.05, msg=f"{name}, {prop}")

        for name, wire in derive["WIRES"].items():
            low, high = wire.bounds()
            near(name, "OuterDiameter", wire.diameter)
            near(name, "MassPerLength", wire.mass_per_length())
            near(name, "SlipBendingStiffness", low)
            near(name, "StickBendingStiffness", high)
            near(name, "BendingStiffness", sqrt(low * high))
        easy, slipping, sticking, torsion = derive["flat_pair"]()
        near("Twin wire AWG 22 solid, PVC, flat", "BendingStiffness", easy)
        second = sqrt(slipping * sticking)
        near("Twin wire AWG 22 solid, PVC, flat", "SecondBendingStiffness", second)
        near("Twin wire AWG 22 solid, PVC, flat", "TorsionalStiffness", torsion)
        mass, bending, torsion = derive["fibre"]()
        near("Optical fibre 125/250 µm", "MassPerLength", mass)
        near("Optical fibre 125/250 µm", "BendingStiffness", bending)
        near("Optical fibre 125/250 µm", "TorsionalStiffness", torsion)


class OwnTest(DocumentTest):
    def setUp(self):
        super().setUp()
        self.folder = Path(tempfile.mkdtemp()) / "types"
        self.addCleanup(shutil.rmtree, self.folder.parent)
        patched = mock.patch.object(catalogue, "user_folder", lambda: self.folder)
        patched.start()
        self.addCleanup(patched.stop)

    def own(self, *rows, header=HEADER, name="mine.csv", encoding="utf-8"):
        """A file of the user with these rows: dictionaries, or lines as they are."""
        self.folder.mkdir(exist_ok=True)
        path = self.folder / name
        lines = [
            row if isinstance(row, str) else ",".join(row.get(c, "") for c in catalogue.COLUMNS)
            for row in rows
        ]
        path.write_text("\n".join([header, *lines, ""]), encoding=encoding)
        return path

    GOOD = {
        "name": "Mine",
        "outer_diameter_mm": "5",
        "mass_per_length_g_m": "30",
        "bending_stiffness_N_m2": "2e-3",
        "torsional_stiffness_N_m2": "1.5e-3",
        "torsional_stiffness_from": "measured; own rig",
        "min_bend_radius_mm": "40",
        "bend_radius_convention": "centreline",
    }

    def test_a_type_of_ones_own(self):
        row = self.GOOD | {"torsional_stiffness_from": '"measured, own rig"'}
        self.own(row, encoding="utf-8-sig")
        kind = make.cable_type(self.doc, "Mine")
        self.compute()
        self.assertEqual(kind.Status, "Diameter 5 mm, 30 g/m, EI 0.002 N m², GJ 0.0015 N m².")
        self.assertEqual((kind.MinBendRadius.Value, kind.BendRadiusConvention), (40, "Centreline"))
        self.assertIn("MassPerLength: user, mine.csv", kind.Provenance)
        self.assertIn("TorsionalStiffness: measured, own rig", kind.Provenance)

    def test_it_counts_before_a_built_in_one(self):
        self.own(self.GOOD | {"name": "White wire", "torsional_stiffness_from": ""})
        self.assertEqual(catalogue.entry("White wire")["OuterDiameter"], "5.0 mm")
        self.assertEqual(catalogue.complaints(), [])

    def test_what_is_wrong_is_named_by_file_line_column_value_and_bound(self):
        good = self.GOOD | {"torsional_stiffness_from": ""}
        for change, words in (
            ({"outer_diameter_mm": "five"}, ["outer_diameter_mm", "'five'", "greater than 0"]),
            ({"mass_per_length_g_m": "-3"}, ["mass_per_length_g_m", "'-3'", "greater than 0"]),
            ({"bending_stiffness_N_m2": ""}, ["bending_stiffness_N_m2", "''", "greater than 0"]),
            ({"bending_stiffness_N_m2": "nan"}, ["bending_stiffness_N_m2", "'nan'", "1e+06"]),
            ({"min_bend_radius_mm": "inf"}, ["min_bend_radius_mm", "'inf'", "or empty"]),
            ({"slip_bending_stiffness_N_m2": "1"}, ["bending_stiffness_N_m2", "0.002", "1 ("]),
            ({"stick_bending_stiffness_N_m2": "1e-9"}, ["between the bounds", "1e-09"]),
            (
                {"mass_per_length_from": "I think"},
                ["mass_per_length_from", "'I think'", "measured"],
            ),
            ({"bend_radius_convention": "outside"}, ["bend_radius_convention", "'outside'"]),
        ):
            path = self.own(
                self.GOOD | {"name": "Other", "torsional_stiffness_from": ""}, good | change
            )
            (sentence,) = catalogue.complaints()
            for word in (str(path), "line 3", *words):
                self.assertIn(word, sentence)
            with self.assertRaisesRegex(DocumentError, "line 3"):
                make.cable_type(self.doc, "Mine")
            self.assertEqual(self.doc.Objects, [])
            self.assertIn("Other", catalogue.catalogue())
            self.assertIn("White wire", catalogue.catalogue())

    def test_a_file_that_is_no_such_table(self):
        for rows, header, words in (
            ([], "type,diameter", ["line 1", "no column name", "outer_diameter_mm"]),
            ([], HEADER + ",colour", ["line 1", "column 'colour'"]),
            (["Mine,5"], HEADER, ["line 2", "more or fewer values"]),
            ([self.GOOD | {"name": ""}], HEADER, ["line 2", "name", "is empty"]),
            (['"Mine,5'], HEADER, ["cannot be read as a table"]),
        ):
            path = self.own(*rows, header=header)
            (sentence,) = catalogue.complaints()
            for word in (str(path), *words):
                self.assertIn(word, sentence)
            self.assertIn("White wire", catalogue.catalogue())
        path.write_bytes(b"\xff\xfe\x00")
        self.assertIn("UTF-8", *catalogue.complaints())

    def test_a_type_of_the_document_is_saved_and_made_again(self):
        kind = make.cable_type(self.doc, "Hook-up wire AWG 22, ETFE")
        kind.Label = 'Wire "22", AWG'
        kind.MassPerLength = "4.5 g/m"
        kind.BendRadiusConvention = "Centreline"
        path = catalogue.save(kind)
        self.assertEqual(path, self.folder / "own.csv")
        catalogue.save(kind)
        with path.open(encoding="utf-8", newline="") as file:
            self.assertEqual([line["name"] for line in csv.DictReader(file)], [kind.Label])
        again = make.cable_type(self.doc, kind.Label)
        self.compute()
        self.assertEqual(catalogue.complaints(), [])
        for _, (prop, _, unit) in catalogue.NUMBERS.items():
            values = [getattr(each, prop).getValueAs(unit).Value for each in (kind, again)]
            self.assertAlmostEqual(values[0], values[1], delta=1e-12 * values[0])
        self.assertEqual(sorted(again.Provenance), sorted(kind.Provenance))
        self.assertEqual(again.BendRadiusConvention, "Centreline")

    def test_a_document_needs_no_library(self):
        self.own(self.GOOD | {"torsional_stiffness_from": ""})
        kind = make.cable_type(self.doc, "Mine")
        path = self.folder / "cable.FCStd"
        self.doc.saveAs(str(path))
        (self.folder / "mine.csv").unlink()
        kind.touch()
        self.compute()
        self.assertEqual(kind.OuterDiameter.Value, 5)
