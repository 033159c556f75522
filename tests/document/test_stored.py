# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents that users have: a file of every schema so far opens, computes, and is edited.

FreeCAD 1.x touches every object of an older file that has a shape, its own boxes too: its shapes have no
names of elements.
"""

import shutil
import sys
import tempfile
from pathlib import Path
from unittest import mock

import FreeCAD
from fresh import in_a_fresh_process
from reader import seen
from scenes import DocumentTest

from freecad_cable.document.property_table import SCHEMA_VERSION
from freecad_cable.document.proxy import Proxy

DATA = Path(__file__).parents[1] / "data"

KINDS = ["Cable", "CableType", "Centreline", "Clamp", "Clip", "Ring", "Route", "Sleeve", "Terminal"]

SAME = 1e-4
"""Relative: the error that is asked for, of positions."""
FORCES = 1e-3
"""Relative: a contact is as well placed as the nodes beside it lie close, 2e-4 of the length at this tolerance, and the
force at an end changes by about twice as much (seen: 4.6e-4; at a tolerance of 3e-6 5e-5)."""


class StoredTest(DocumentTest):
    def setUp(self):
        super().setUp()
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def open(self, version):
        self.close()
        path = self.folder / f"schema-{version}.FCStd"
        shutil.copy(DATA / path.name, path)
        self.doc = FreeCAD.openDocument(str(path))
        return self.doc.Cable

    def test_there_is_one_of_every_schema(self):
        stored = sorted(path.name for path in DATA.glob("*.FCStd"))
        self.assertEqual(stored, [f"schema-{v}.FCStd" for v in range(1, SCHEMA_VERSION + 1)])

    def test_it_opens_with_every_object_and_its_version(self):
        for version in range(1, SCHEMA_VERSION + 1):
            cable = self.open(version)
            ours = [o for o in self.doc.Objects if isinstance(getattr(o, "Proxy", None), Proxy)]
            self.assertEqual({type(o.Proxy).__name__ for o in ours}, set(KINDS))
            for obj in ours:
                by_freecad = self.doc.Roof.State if hasattr(obj, "Shape") else ["Up-to-date"]
                self.assertEqual(obj.State, by_freecad, obj.Name)
                self.assertEqual(obj.SchemaVersion, SCHEMA_VERSION)
                missing = {prop.name for prop in obj.Proxy.TABLE} - set(obj.PropertiesList)
                self.assertEqual(missing, set())
            # What the program that wrote it said.
            self.assertAlmostEqual(cable.SmallestBendRadius.Value, 33.471567, delta=1e-5)
            self.assertEqual(cable.SolvedLength.Value, 340)
            self.assertEqual(cable.CutLength.Value, 350)
            self.assertEqual((len(cable.ContactForces), len(cable.SupportForces)), (1, 1))
            self.assertTrue(cable.Shape.isClosed())
            self.compute()

    def test_it_computes_to_the_same_and_is_edited(self):
        for version in range(1, SCHEMA_VERSION + 1):
            cable = self.open(version)
            radius, force = cable.SmallestBendRadius.Value, cable.EndForce
            cable.SolvedInputs = ""  # solve, whatever it says
            for obj in self.doc.Objects:
                obj.touch()
            self.compute()
            self.assertAlmostEqual(cable.SmallestBendRadius.Value / radius, 1, delta=SAME)
            self.assertNear(cable.EndForce, force, FORCES * force.Length)
            cable.Length = "350 mm"
            self.compute()
            self.assertEqual((cable.SolvedLength.Value, cable.CutLength.Value), (350, 360))
            self.assertGreater(abs(cable.SmallestBendRadius.Value - radius), 0.1)

    def test_it_opens_and_computes_without_casadi(self):
        for version in range(1, SCHEMA_VERSION + 1):
            here = seen(self.open(version))
            observed = in_a_fresh_process(DATA / f"schema-{version}.FCStd", self.folder)
            self.assertEqual(observed["modules"], [])
            self.assertEqual(observed["opened"], here)
            self.assertEqual(observed["recomputed"], here | {"State": ["Up-to-date"]})
            self.assertIn("CasADi is not installed", observed["message"])
            command = observed["message"].partition("Install it with: ")[2]
            wanted = "python{}.{} -m pip install --no-deps casadi --target ".format(
                *sys.version_info
            )
            self.assertTrue(command.startswith(wanted), command)
            folder = Path(FreeCAD.getUserAppDataDir()) / "AdditionalPythonPackages"
            self.assertEqual(command.removeprefix(wanted), f'"{folder}"')

    def test_a_file_of_a_later_version_is_not_called_an_older_one(self):
        cable = self.open(SCHEMA_VERSION)
        cable.SchemaVersion = SCHEMA_VERSION + 1
        path = self.folder / "later.FCStd"
        self.doc.saveAs(str(path))
        self.close()
        with mock.patch.object(FreeCAD.Console, "PrintWarning") as warned:
            self.doc = FreeCAD.openDocument(str(path))
        self.assertEqual(self.doc.Cable.SchemaVersion, SCHEMA_VERSION + 1)
        (sentence,) = warned.call_args.args
        self.assertIn("Cable was stored by a later version", sentence)
