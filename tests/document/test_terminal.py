# SPDX-License-Identifier: LGPL-2.1-or-later
"""Terminals: where they stand, that they stay with their part, and what they say when they cannot."""

import FreeCAD
from FreeCAD import Placement, Rotation, Units, Vector
from scenes import BOTTOM, SIDE, TOP, DocumentTest

from freecad_cable.document import make
from freecad_cable.errors import DocumentError

MOVE = Placement(Vector(30, -20, 50), Rotation(Vector(1, 2, -3), 77))


class PinTest(DocumentTest):
    """One connector."""

    def setUp(self):
        super().setUp()
        self.part = self.pin("Pin", (10, 20, 30))
        self.doc.recompute()


class TerminalTest(PinTest):
    def frame(self, terminal):
        self.compute()
        self.assertFrame(terminal, terminal.Placement)
        return terminal.Frame

    def assertFrame(self, terminal, expected):
        self.assertNear(terminal.Frame.Base, expected.Base)
        self.assertTrue(terminal.Frame.Rotation.isSame(expected.Rotation, 1e-12))

    def test_it_stands_on_its_edge_and_shows_the_way_out(self):
        terminal = make.terminal(self.doc, (self.part, TOP))
        frame = self.frame(terminal)
        self.assertNear(frame.Base, (10, 20, 30))
        self.assertNear(frame.Rotation.multVec(Vector(0, 0, 1)), (0, 0, 1))
        box = terminal.Shape.BoundBox
        self.assertNear((box.XMin, box.YMin, box.ZMin), (6, 16, 30))
        self.assertNear((box.XMax, box.YMax, box.ZMax), (14, 24, 38))

    def test_roll_reverse_and_offset_act_in_the_axes_of_the_reference(self):
        self.part.Placement = MOVE
        terminal = make.terminal(self.doc, (self.part, TOP))
        plain = self.frame(terminal)
        terminal.Roll = "30 deg"
        roll = Placement(Vector(), Rotation(Vector(0, 0, 1), 30))
        self.compute()
        self.assertFrame(terminal, plain * roll)
        terminal.Offset = Placement(Vector(1, 2, 3), Rotation(Vector(1, 0, 0), 20))
        self.compute()
        self.assertFrame(terminal, plain * roll * terminal.Offset)
        terminal.Reverse = True
        flip = Placement(Vector(), Rotation(Vector(1, 0, 0), 180))
        self.compute()
        self.assertFrame(terminal, plain * flip * roll * terminal.Offset)

    def test_a_vertex_with_a_second_entry_for_the_axes(self):
        box = self.doc.addObject("Part::Box", "Axes")
        box.Placement = MOVE
        self.doc.recompute()
        corner = self.part.Shape.Vertexes[0].Point
        terminal = make.terminal(self.doc, [(self.part, "Vertex1"), box])
        frame = self.frame(terminal)
        self.assertNear(frame.Base, corner)
        self.assertTrue(frame.Rotation.isSame(MOVE.Rotation, 1e-12))

    def test_a_local_coordinate_system_in_a_body(self):
        body = self.doc.addObject("PartDesign::Body", "Body")
        body.Placement = MOVE
        axes = self.doc.addObject("PartDesign::CoordinateSystem", "Axes")
        body.addObject(axes)
        axes.Placement.Base = Vector(0, 0, 5)
        terminal = make.terminal(self.doc, axes)
        self.assertEqual(terminal.Reference, [(body, ("Axes.",))])
        self.compute()
        self.assertFrame(terminal, MOVE * axes.Placement)
        body.Placement = Placement()
        self.compute()
        self.assertFrame(terminal, axes.Placement)

    def test_another_terminal_serves_as_a_reference(self):
        first = make.terminal(self.doc, (self.part, TOP), roll="15 deg")
        second = make.terminal(self.doc, first)
        self.compute()
        self.assertFrame(second, first.Frame)

    def test_a_reference_set_by_hand_is_put_on_the_right_root(self):
        unit = self.doc.addObject("App::Part", "Unit")
        unit.addObject(self.part)
        terminal = make.terminal(self.doc, (unit, f"Pin.{TOP}"))
        terminal.Reference = (self.part, BOTTOM)
        self.assertEqual(terminal.Reference, [(unit, (f"Pin.{BOTTOM}",))])

    def test_a_move_by_hand_is_taken_back(self):
        terminal = make.terminal(self.doc, (self.part, TOP))
        frame = self.frame(terminal)
        terminal.Placement.Base = Vector(1, 1, 1)
        self.assertNear(terminal.Placement.Base, frame.Base)
        self.assertNear(self.frame(terminal).Base, frame.Base)

    def test_a_free_end_needs_no_reference(self):
        terminal = make.terminal(self.doc, None, condition="Free")
        self.compute()
        self.assertTrue(terminal.Shape.isNull())

    def test_put_into_the_container_of_its_part_it_refers_from_there(self):
        unit = self.doc.addObject("App::Part", "Unit")
        unit.Placement = MOVE
        unit.addObject(self.part)
        terminal = make.terminal(self.doc, (self.part, TOP))
        self.assertEqual(terminal.Reference, [(unit, (f"Pin.{TOP}",))])
        outside = MOVE * self.part.Placement * Placement(Vector(0, 0, 10), Rotation())
        self.compute()
        self.assertFrame(terminal, outside)
        unit.addObject(terminal)
        self.assertEqual(terminal.Reference, [(self.part, (TOP,))])
        self.compute()
        self.assertFrame(terminal, MOVE.inverse() * outside)
        unit.removeObject(terminal)
        self.assertEqual(terminal.Reference, [(unit, (f"Pin.{TOP}",))])
        self.compute()
        self.assertFrame(terminal, outside)


class BrokenReferenceTest(PinTest):
    """Each says what is missing where, and shows no mark."""

    def assertNoMark(self, terminal, *words):
        self.assertFailed(terminal, "Reference", *words)
        self.assertTrue(terminal.Shape.isNull())
        self.assertEqual(terminal.Frame, Placement())

    def test_a_deleted_part(self):
        terminal = make.terminal(self.doc, (self.part, TOP))
        self.compute()
        self.doc.removeObject(self.part.Name)
        self.assertNoMark(terminal, "is empty", "deleted")

    def test_a_part_deleted_inside_a_container(self):
        unit = self.doc.addObject("App::Part", "Unit")
        unit.addObject(self.part)
        terminal = make.terminal(self.doc, (self.part, TOP))
        self.compute()
        unit.removeObject(self.part)
        self.doc.removeObject("Pin")
        self.assertNoMark(terminal, "Pin is not inside Unit")

    def test_an_edge_that_is_gone(self):
        ball = self.doc.addObject("Part::Feature", "Ball")
        ball.Shape = self.part.Shape
        terminal = make.terminal(self.doc, (ball, TOP))
        self.compute()
        import Part

        ball.Shape = Part.makeLine((0, 0, 0), (1, 0, 0)).Vertexes[0]
        self.assertNoMark(terminal, f"{TOP} of Ball is missing")

    def test_an_edge_without_a_direction_of_its_own(self):
        self.assertNoMark(
            make.terminal(self.doc, (self.part, SIDE)), f"{SIDE} of Pin gives no direction"
        )

    def test_three_entries(self):
        terminal = make.terminal(self.doc, [(self.part, "Vertex1"), self.part, (self.part, TOP)])
        self.assertNoMark(terminal, "3 entries")

    def test_a_part_outside_its_container(self):
        unit = self.doc.addObject("App::Part", "Unit")
        with self.assertRaisesRegex(DocumentError, "Pin is not inside Unit"):
            make.terminal(self.doc, (self.part, TOP), inside=unit)
        terminal = make.terminal(self.doc, (self.part, TOP))
        unit.addObject(terminal)
        self.assertNoMark(terminal, "Pin is not inside Unit")
        unit.addObject(self.part)
        self.compute()
        self.assertNear(terminal.Frame.Base, (10, 20, 30))

    def test_whole_turns_of_roll_do_not_count(self):
        for roll in (90, 450, "-270 deg"):
            terminal = make.terminal(self.doc, (self.part, TOP), roll=roll)
            self.compute()
            self.assertNear(terminal.Frame.multVec(Vector(1, 0, 0)), (10, 21, 30))
        self.assertEqual(terminal.Roll, Units.Quantity("-270 deg"))

    def test_a_part_taken_out_of_the_container(self):
        self.doc.UndoMode = 1
        unit = self.doc.addObject("App::Part", "Unit")
        unit.Placement = MOVE
        unit.addObject(self.part)
        terminal = make.terminal(self.doc, (self.part, TOP), inside=unit)
        self.compute()
        self.doc.openTransaction("Take it out")
        unit.removeObject(self.part)
        self.doc.commitTransaction()
        self.assertNoMark(terminal, "Pin is not inside Unit")
        self.doc.undo()
        self.compute()
        self.doc.redo()
        self.assertNoMark(terminal, "Pin is not inside Unit")
        unit.addObject(self.part)
        self.compute()
        self.assertNear(terminal.Frame.Base, (10, 20, 30))

    def test_roll_that_is_no_number(self):
        terminal = make.terminal(self.doc, (self.part, TOP))
        terminal.Roll = float("nan")
        self.assertFailed(terminal, "Roll", "nan deg", "finite")


class MoveTest(DocumentTest):
    """Assembly ⊃ unit ⊃ pin, a link to the unit; every move of anything arrives at the terminals."""

    def setUp(self):
        super().setUp()
        self.assembly = self.doc.addObject("App::Part", "Assembly")
        self.unit = self.doc.addObject("App::Part", "Unit")
        self.part = self.pin("Pin", (0, 0, 10))
        self.unit.addObject(self.part)
        self.link = self.doc.addObject("App::Link", "Twin")
        self.link.LinkedObject = self.unit
        self.assembly.addObjects([self.unit, self.link])
        self.doc.recompute()

    def top(self, *placements):
        """Where the end of the pin is, moved by the placements, outermost first."""
        place = Placement()
        for placement in placements:
            place = place * placement
        return (place * self.part.Placement * Placement(Vector(0, 0, 10), Rotation())).Base

    def check_every_move(self, terminal, containers, purge):
        """Move one after the other, with the touch taken back as an assembly solver does if ``purge``."""
        for i, moved in enumerate((self.part, *containers)):
            moved.Placement = (
                Placement(Vector(7 + i, 11, 13), Rotation(Vector(3, i, 1), 25)) * moved.Placement
            )
            if purge:
                for obj in self.doc.Objects:
                    if obj not in (terminal,):
                        obj.purgeTouched()
            self.doc.recompute()
            expected = self.top(*(c.Placement for c in reversed(containers)))
            self.assertNear(terminal.Frame.Base, expected)

    def test_from_outside_through_nested_parts(self):
        for purge in (False, True):
            terminal = make.terminal(self.doc, (self.part, TOP))
            self.doc.recompute()
            self.check_every_move(terminal, [self.unit, self.assembly], purge)

    def test_from_outside_through_a_link(self):
        for purge in (False, True):
            terminal = make.terminal(self.doc, (self.link, f"Pin.{TOP}"))
            self.doc.recompute()
            self.check_every_move(terminal, [self.link, self.assembly], purge)

    def test_inside_the_assembly(self):
        for purge in (False, True):
            terminal = make.terminal(self.doc, (self.part, TOP), inside=self.assembly)
            self.doc.recompute()
            self.check_every_move(terminal, [self.unit], purge)
            linked = make.terminal(self.doc, (self.link, f"Pin.{TOP}"), inside=self.assembly)
            self.doc.recompute()
            self.check_every_move(linked, [self.link], purge)

    def test_inside_the_assembly_a_move_of_the_assembly_changes_nothing(self):
        terminal = make.terminal(self.doc, (self.part, TOP), inside=self.assembly)
        self.compute()
        self.assembly.Placement = MOVE
        self.compute()
        self.assertNear(terminal.Frame.Base, self.top())

    def test_a_part_of_another_document(self):
        with_part = FreeCAD.newDocument("Library")
        self.addCleanup(FreeCAD.closeDocument, with_part.Name)
        import tempfile

        folder = tempfile.mkdtemp()
        pin = with_part.addObject("Part::Cylinder", "Pin")
        with_part.recompute()
        with_part.saveAs(f"{folder}/library.FCStd")
        self.doc.saveAs(f"{folder}/user.FCStd")
        link = self.doc.addObject("App::Link", "Loan")
        link.LinkedObject = pin
        link.Placement = MOVE
        self.doc.recompute()
        terminal = make.terminal(self.doc, (link, TOP))
        self.compute()
        expected = MOVE * Placement(Vector(0, 0, 10), Rotation())
        self.assertNear(terminal.Frame.Base, expected.Base)
        pin.Height = 25
        with_part.recompute()
        self.doc.recompute()
        self.assertNear(terminal.Frame.Base, (MOVE * Placement(Vector(0, 0, 25), Rotation())).Base)
