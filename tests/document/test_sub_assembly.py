# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cable in an assembly, from one sub-assembly to another, both the same mechanism of another document."""

import shutil
import tempfile

import FreeCAD
from FreeCAD import Placement, Rotation, Vector
from mechanisms import ASSEMBLIES, TIP, Mechanism, add_unit, new_assembly
from scenes import TOP, DocumentTest

from freecad_cable.document import make
from freecad_cable.document.reference import container

ASIDE = Placement(Vector(150, 20, 10), Rotation(Vector(1, 2, 3), 25))
BESIDE = Placement(Vector(60, 0, 0), Rotation())
LOWER = Placement(Vector(50, 10, -20), Rotation(Vector(0, 1, 0), 35))


class UnitTest(DocumentTest):
    """Two units in an assembly, beside each other."""

    def setUp(self):
        super().setUp()
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        user, self.doc = self.doc, FreeCAD.newDocument("Unit")
        self.library = self.doc
        self.addCleanup(lambda: FreeCAD.closeDocument(self.library.Name))
        self.mechanism = Mechanism(
            self.doc, self.pin("Base", (0, 0, 0)), self.pin("Arm", (60, 0, 0))
        )
        self.mechanism.place(BESIDE)
        self.doc.recompute()
        self.doc.saveAs(f"{self.folder}/unit.FCStd")
        self.doc = user
        self.doc.saveAs(f"{self.folder}/user.FCStd")
        self.assembly = new_assembly(self.doc)
        self.units, self.ways = [], []
        for name in ("One", "Two"):
            unit, ways = add_unit(self.mechanism, self.assembly, name)
            self.units.append(unit)
            self.ways.append(ways)
        self.units[1].Placement = ASIDE
        self.doc.recompute()

    def add_cable(self, inside):
        """From the arm of the one to the base of the other, in the assembly or beside it."""
        ends = [
            make.terminal(self.doc, (unit, way + TOP), inside=inside)
            for unit, way in zip(self.units, (self.ways[0][1], self.ways[1][0]), strict=True)
        ]
        self.cable = make.cable(self.doc, start=ends[0], end=ends[1], length="400 mm")
        self.compute()
        return self.cable

    def tips(self):
        """Of both parts, found by the way that FreeCAD itself goes, from the outermost container."""
        for unit, way in zip(self.units, (self.ways[0][1], self.ways[1][0]), strict=True):
            yield (self.assembly.getSubObject(f"{unit.Name}.{way}", retType=3) * TIP).Base

    def assertConnected(self):
        self.compute()
        inside = container(self.cable) is self.assembly
        outside = self.assembly.Placement.inverse() if inside else Placement()
        wire = self.cable.Centreline.Shape.Edges[0]
        ends = (wire.valueAt(at) for at in (wire.FirstParameter, wire.LastParameter))
        for end, tip in zip(ends, self.tips(), strict=True):
            self.assertNear(end, outside * tip, 1e-6)


class RigidTest(UnitTest):
    def test_it_follows_units_and_what_moves_in_their_document(self):
        for inside in (self.assembly, None):
            self.add_cable(inside)
            self.assertConnected()
            self.units[1].Placement = Placement(Vector(100, 80, 0), Rotation())
            self.assertConnected()
            first, _ = self.tips()
            self.mechanism.place(LOWER)
            self.library.recompute()
            self.assertConnected()
            moved, _ = self.tips()
            self.assertGreater(first.distanceToPoint(moved), 20)
            self.mechanism.place(BESIDE)
            self.library.recompute()
            self.units[1].Placement = ASIDE
            self.assertConnected()


if ASSEMBLIES:

    class FlexibleTest(UnitTest):
        """A flexible sub-assembly moves in its own way, unlike the others of its kind."""

        def setUp(self):
            super().setUp()
            self.units[0].Rigid = False
            self.doc.recompute()

        def test_its_parts_have_places_of_their_own(self):
            for inside in (self.assembly, None):
                self.add_cable(inside)
                self.assertConnected()
                arm = self.units[0].getObject(self.ways[0][1][:-1])
                before, _ = self.tips()
                arm.Placement.Base += Vector(0, 30, 15)
                arm.purgeTouched()
                self.assertConnected()
                moved, _ = self.tips()
                self.assertNear(moved - before, (0, 30, 15))

        def test_they_are_obstacles_where_they_are(self):
            cable = self.add_cable(self.assembly)
            cable.Obstacles = [(self.units[0], self.ways[0][0])]
            self.compute()
            base = self.units[0].getObject(self.ways[0][0][:-1])
            middle = cable.NodePosition[len(cable.NodePosition) // 2] * 1000
            base.Placement.Base = middle - Vector(0, 0, 5)
            base.purgeTouched()
            self.compute()
            self.assertGreater(len(cable.ContactPlaces), 0)

        def test_rigid_again(self):
            self.add_cable(self.assembly)
            for rigid in (True, False):
                self.units[0].Rigid = rigid
                self.assertConnected()
