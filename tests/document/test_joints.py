# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cable from the base of a mechanism to its arm: it follows what the assembly's solver does."""

import shutil
import tempfile

import FreeCAD
from FreeCAD import Placement, Rotation, Vector
from mechanisms import TIP, Mechanism
from scenes import TOP, DocumentTest

from freecad_cable.document import make
from freecad_cable.document.reference import container

BESIDE = Placement(Vector(120, 0, 0), Rotation())
LOWER = Placement(Vector(90, 30, -20), Rotation(Vector(0, 1, 0), 35))
SOLVED = 1e-5
"""[mm]: an assembly solver stops at 1e-6."""


class MechanismTest(DocumentTest):
    def build(self, base, arm):
        self.mechanism = Mechanism(self.doc, base, arm)
        self.mechanism.place(BESIDE)
        self.doc.recompute()
        return self.mechanism

    def add_cable(self, inside):
        """From base to arm, in the assembly or beside it."""
        ends = [
            make.terminal(self.doc, (part, TOP), inside=inside)
            for part in (self.mechanism.base, self.mechanism.arm)
        ]
        self.cable = make.cable(self.doc, start=ends[0], end=ends[1], length="300 mm")
        route = make.route(self.doc, self.cable)
        if inside:
            self.mechanism.comes_after(self.cable, *ends, self.cable.Centreline, route)
        self.compute()
        return self.cable

    def assertConnected(self, arm=None):
        """Nothing is out of date, the cable ends where the parts are, and the arm is where it belongs."""
        self.compute()
        outside = Placement()
        if container(self.cable) is None:
            outside = self.mechanism.assembly.Placement
        base = outside * self.mechanism.base.Placement * TIP
        tip = outside * self.mechanism.arm.Placement * TIP
        wire = self.cable.Centreline.Shape.Edges[0]
        self.assertNear(wire.valueAt(wire.FirstParameter), base.Base, 1e-6)
        self.assertNear(wire.valueAt(wire.LastParameter), tip.Base, 1e-6)
        if arm is not None:
            self.assertNear(tip.Base, (base * arm).Base, SOLVED)


class JointTest(MechanismTest):
    def setUp(self):
        super().setUp()
        self.build(self.pin("Base", (0, 0, 0)), self.pin("Arm", (120, 0, 0)))

    def test_it_follows_a_joint_that_changes(self):
        """The solver moves the arm after the cable is computed, as the assembly contains both."""
        for inside in (self.mechanism.assembly, None):
            self.add_cable(inside)
            self.assertConnected()
            for place in (LOWER, BESIDE):
                self.mechanism.place(place)
                self.assertConnected(place)

    def test_it_follows_a_solve_without_a_recompute(self):
        """Which leaves no trace on the parts: a drag, for instance."""
        self.mechanism.assembly.Placement = Placement(Vector(0, 0, 500), Rotation())
        for inside in (self.mechanism.assembly, None):
            cable = self.add_cable(inside)
            for place in (LOWER, BESIDE):
                self.mechanism.place(place)
                self.mechanism.solve()
                self.assertIn("Touched", cable.State)
                self.assertConnected(place)

    def test_a_cable_in_error_is_right_again_after_a_solve(self):
        """FreeCAD does not recompute an assembly in which something is in error, but it can be solved."""
        cable = self.add_cable(self.mechanism.assembly)
        self.mechanism.place(Placement(Vector(400, 0, 0), Rotation()))
        self.mechanism.solve()
        self.assertFailed(cable, "Length", "300 mm", "400")
        self.assertNothingShown(cable)
        self.mechanism.place(LOWER)
        self.mechanism.solve()
        self.assertConnected(LOWER)

    def test_what_a_solver_leaves_where_it_is_solves_nothing(self):
        cable = self.add_cable(self.mechanism.assembly)
        before = cable.SolvedInputs, cable.NodePosition
        self.mechanism.assembly.touch()
        self.mechanism.solve()
        self.mechanism.arm.Placement.Base += Vector(1e-9, 0, -1e-9)
        self.mechanism.arm.purgeTouched()
        self.assertEqual(cable.State, ["Up-to-date"])
        self.compute()
        self.assertEqual((cable.SolvedInputs, cable.NodePosition), before)


class OtherDocumentTest(MechanismTest):
    """The parts of the assembly are links to those of another document."""

    def setUp(self):
        super().setUp()
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.library = FreeCAD.newDocument("Library")
        self.addCleanup(lambda: FreeCAD.closeDocument(self.library.Name))
        self.original = self.library.addObject("Part::Cylinder", "Pin")
        self.original.Radius, self.original.Height = 4, 10
        self.library.recompute()
        self.library.saveAs(f"{self.folder}/library.FCStd")
        self.doc.saveAs(f"{self.folder}/user.FCStd")
        self.build(self.loan("Base"), self.loan("Arm"))

    def loan(self, name):
        link = self.doc.addObject("App::Link", name)
        link.LinkedObject = self.original
        return link

    def test_it_follows_joint_and_part(self):
        for inside in (self.mechanism.assembly, None):
            self.add_cable(inside)
            self.assertConnected(BESIDE)
            self.mechanism.place(LOWER)
            self.assertConnected(LOWER)
            self.mechanism.place(BESIDE)
            self.assertConnected(BESIDE)

    def test_it_follows_the_original(self):
        cable = self.add_cable(self.mechanism.assembly)
        self.original.Height = 30
        self.library.recompute()
        self.doc.recompute()
        wire = cable.Centreline.Shape.Edges[0]
        self.assertNear(wire.valueAt(0), (0, 0, 30), 1e-6)

    def test_saved_and_opened_again(self):
        cable = self.add_cable(self.mechanism.assembly)
        before = cable.NodePosition
        for document in (self.doc, self.library):
            document.save()
            FreeCAD.closeDocument(document.Name)
        self.doc = FreeCAD.openDocument(f"{self.folder}/user.FCStd")
        self.library = FreeCAD.getDocument("library")
        cable = self.doc.Cable
        self.assertEqual(cable.NodePosition, before)
        self.compute()
        self.library.Pin.Height = 30
        self.library.recompute()
        self.doc.recompute()
        wire = cable.Centreline.Shape.Edges[0]
        self.assertNear(wire.valueAt(0), (0, 0, 30), 1e-6)
