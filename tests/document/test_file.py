# SPDX-License-Identifier: LGPL-2.1-or-later
"""A saved document opens with the same numbers, without solving and without CasADi."""

import shutil
import tempfile
from pathlib import Path
from unittest import mock

import FreeCAD
import numpy as np
from FreeCAD import Placement, Rotation, Vector
from fresh import in_a_fresh_process
from reader import seen
from scenes import DocumentTest

from freecad_cable.document import make, solving
from freecad_cable.document.stored_solution import NODES

ASIDE = Placement(Vector(0, 0, 30), Rotation())


class FileTest(DocumentTest):
    def setUp(self):
        super().setUp()
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        self.cable_between_pins()
        make.route(self.doc, self.cable)
        self.type.AxialStiffness = "400 N"
        # Numbers that files round.
        self.right.Placement = Placement(Vector(119.3, 1 / 3, -0.7), Rotation(Vector(1, 2, 3), 7.7))
        self.compute()
        self.before = seen(self.cable)
        self.path = str(self.folder / "cable.FCStd")
        self.doc.saveAs(self.path)

    def reopen(self):
        FreeCAD.closeDocument(self.doc.Name)
        self.doc = FreeCAD.openDocument(self.path)
        return self.doc.Cable

    def assertSame(self, now):
        """Nodes bit by bit; of a single number FreeCAD writes 16 digits."""
        self.assertEqual(now.keys(), self.before.keys())
        for name, before in self.before.items():
            if (
                isinstance(before, (list, float))
                and before
                and now[name] != before  # nor is the difference of two infinite numbers one
                and name not in (*NODES, "State", "ModelUsed")
            ):
                self.assertLess(
                    np.max(np.abs(np.subtract(now[name], before))),
                    max(1e-15 * np.max(np.abs(before)), 1e-16),
                    name,
                )
            else:
                self.assertEqual(now[name], before, name)

    def test_it_reopens_and_recomputes_without_solving(self):
        with mock.patch.object(solving, "find_equilibrium", side_effect=AssertionError):
            cable = self.reopen()
            self.assertSame(seen(cable))
            for obj in self.doc.Objects:
                self.assertEqual(obj.State, ["Up-to-date"], obj.Label)
            for obj in self.doc.Objects:
                obj.touch()
            self.doc.recompute()
            self.assertSame(seen(cable))

    def test_with_supports_and_obstacles(self):
        """Everything a cable can have, and in a process without CasADi."""
        plate, edge = self.plate("Plate", (60, 20, 60), (1, 0, 0))
        self.cable.Supports = [
            make.ring(self.doc, (plate, edge)),
            make.clip(self.doc, (plate, edge), position="190 mm", offset=ASIDE),
        ]
        self.compute()
        roof = self.doc.addObject("Part::Box", "Roof")
        roof.Length = roof.Width = 300
        # 2 mm lower than the cable reaches.
        top = 1e3 * max(point.z for point in self.cable.NodePosition) + 3.5
        roof.Placement.Base = Vector(-90, -150, top - 2)
        self.cable.Obstacles = roof
        self.type.MinBendRadius = "10 mm"
        self.compute()
        self.assertTrue(self.cable.ContactForces)
        self.assertEqual(len(self.cable.SupportForces), 2)
        self.before = seen(self.cable)
        self.doc.save()
        observed = in_a_fresh_process(self.path, self.folder)
        self.assertEqual(observed["modules"], [])
        self.assertSame(observed["opened"])
        self.assertSame(observed["recomputed"])

    def test_quantities_have_their_units_again(self):
        self.reopen()
        kind = self.doc.CableType
        self.assertAlmostEqual(
            kind.MassPerLength.getValueAs("g/m").Value, 44.642031607511, delta=1e-9
        )
        self.assertAlmostEqual(
            kind.BendingStiffness.getValueAs("N*m^2").Value, 1.1785881e-3, delta=1e-9
        )
        kind.BendingStiffness = "2e-3 N*m^2"
        with self.assertRaises(ArithmeticError):
            kind.BendingStiffness = "2 mm"

    def test_it_solves_on_from_where_it_was(self):
        cable = self.reopen()
        find, starts = solving.find_equilibrium, []

        def spy(scene, *, start=None):
            starts.append(start)
            return find(scene, start=start)

        with mock.patch.object(solving, "find_equilibrium", spy):
            cable.Length = "310 mm"
            self.compute()
        (start,) = starts
        self.assertEqual(start.position.tolist(), self.before["NodePosition"])
        self.assertEqual(cable.SolvedLength.Value, 310)

    def test_an_old_file_gets_the_properties_it_lacks(self):
        self.cable.removeProperty("Tolerance")
        self.cable.removeProperty("BalanceResidual")
        self.doc.save()
        cable = self.reopen()
        self.assertEqual(cable.Tolerance, 1e-4)
        self.assertEqual(cable.BalanceResidual, 0)

    def test_a_fresh_process_without_casadi(self):
        observed = in_a_fresh_process(self.path, self.folder)
        self.assertEqual(observed["modules"], [])
        self.assertSame(observed["opened"])
        self.assertSame(observed["recomputed"])
        edited = observed["edited"]
        self.assertEqual(edited["State"], ["Touched", "Invalid"])
        # What was solved before can still be seen, and says that it is from before.
        for name in ("Volume", "SolvedLength", "EndForce", *NODES):
            self.assertEqual(edited[name], observed["opened"][name])
        self.assertTrue(edited["OutOfDate"])
        self.assertIn("CasADi is not installed", observed["message"])
        self.assertEqual(edited["Status"], observed["message"])
        length, drawn, said = observed["route"]
        self.assertGreater(length, 120)
        self.assertAlmostEqual(drawn / length, 1, delta=1e-4)
        self.assertIn("CasADi is not installed", said)
