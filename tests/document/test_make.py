# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a macro calls: defaults, and one sentence for wrong arguments."""

import FreeCAD
from FreeCAD import Placement, Rotation, Vector
from scenes import TOP, DocumentTest, SupportedTest

from freecad_cable.document import make
from freecad_cable.document.reference import container
from freecad_cable.errors import DocumentError


class MakeTest(DocumentTest):
    def setUp(self):
        super().setUp()
        self.left, self.right = self.pin("Left", (0, 0, 0)), self.pin("Right", (120, 0, 0))
        self.doc.recompute()
        self.ends = [make.terminal(self.doc, (pin, TOP)) for pin in (self.left, self.right)]

    def cable(self, **arguments):
        return make.cable(self.doc, start=self.ends[0], end=self.ends[1], **arguments)

    def test_a_cable_with_nothing_else_said_has_a_type_and_slack(self):
        cable = self.cable()
        self.compute()
        self.assertEqual(cable.CableType.Label, "Multi-core cable 7 mm")
        self.assertAlmostEqual(cable.SolvedLength.Value, 132, delta=1e-9)
        self.assertIs(self.cable().CableType, cable.CableType)

    def test_lengths(self):
        self.assertEqual(self.cable(length="0.2 m").Length.Value, 200)
        self.assertEqual(self.cable(length=250).Length.Value, 250)
        cable = self.cable(slack=0.25, gravity=(0, 0, 0), tolerance=1e-3)
        self.assertEqual((cable.LengthMode, cable.Slack), ("Slack", 0.25))
        self.assertEqual((cable.Gravity, cable.Tolerance), (Vector(), 1e-3))

    def test_terminal_properties(self):
        terminal = make.terminal(
            self.doc, (self.left, TOP), condition="Pinned", reverse=True, roll="0.5 rad"
        )
        self.assertEqual((terminal.Condition, terminal.Reverse), ("Pinned", True))
        self.assertAlmostEqual(terminal.Roll.Value, 28.6478897565, delta=1e-9)

    def test_all_is_made_beside_the_terminals(self):
        unit = self.doc.addObject("App::Part", "Unit")
        unit.addObjects([self.left, self.right])
        ends = [make.terminal(self.doc, (pin, TOP), inside=unit) for pin in (self.left, self.right)]
        cable = make.cable(self.doc, start=ends[0], end=ends[1], slack=0.5)
        route = make.route(self.doc, cable)
        for obj in (*ends, cable, cable.Centreline, route):
            self.assertIs(container(obj), unit)
        self.compute()
        self.assertFalse(set(unit.InList) & {*ends, cable, route})

    def check(self, words, function, *arguments, **keywords):
        before = [obj.Name for obj in self.doc.Objects]
        with self.assertRaisesRegex(DocumentError, words):
            function(self.doc, *arguments, **keywords)
        self.assertEqual([obj.Name for obj in self.doc.Objects], before)

    def test_one_support_is_a_list_of_one(self):
        clip = make.clip(self.doc, (self.left, TOP), position="50 mm")
        self.assertEqual(self.cable(supports=clip).Supports, [clip])
        self.assertEqual(self.cable(supports=None).Supports, [])

    def test_what_is_in_another_document(self):
        other = FreeCAD.newDocument("Other")
        try:
            with self.assertRaisesRegex(DocumentError, "Terminal is in .*; it must be in Other"):
                make.cable(other, start=self.ends[0], end=self.ends[1])
            self.assertEqual(other.Objects, [])
        finally:
            FreeCAD.closeDocument(other.Name)

    def test_wrong_arguments_are_one_sentence_and_leave_nothing(self):
        start, end = self.ends
        ends, left = {"start": start, "end": end}, (self.left, TOP)
        for words, function, arguments, keywords in (
            ("it must be an object, or a pair", make.terminal, ["Left"], {}),
            (
                "condition is 'Glued'; it must be one of Clamped",
                make.terminal,
                [left],
                {"condition": "Glued"},
            ),
            (
                "kind is no property of a Terminal; known are condition",
                make.terminal,
                [left],
                {"kind": 1},
            ),
            (
                "roll is '3 mm'; it must be something in deg",
                make.terminal,
                [left],
                {"roll": "3 mm"},
            ),
            ("reverse is 'maybe'", make.terminal, [left], {"reverse": "maybe"}),
            ("either a length or a slack", make.cable, [], ends | {"length": "1 m", "slack": 0.1}),
            (
                "The start is None; it must be a terminal",
                make.cable,
                [],
                {"start": None, "end": end},
            ),
            (
                "The end is Left; it must be a terminal",
                make.cable,
                [],
                {"start": start, "end": self.left},
            ),
            (
                "Both ends are Terminal; a cable needs",
                make.cable,
                [],
                {"start": start, "end": start},
            ),
            ("What it is to be inside is 5", make.terminal, [left], {"inside": 5}),
            ("The name is 7; it must be text", make.cable_type, [7], {}),
            (
                "A support is Left; it must be a clamp",
                make.cable,
                [],
                ends | {"supports": self.left},
            ),
            ("The cable type is 'thick'", make.cable, [], ends | {"cable_type": "thick"}),
            (
                "length is 'long'; it must be something in mm",
                make.cable,
                [],
                ends | {"length": "long"},
            ),
            ("slack is '10 %'; it must be a float", make.cable, [], ends | {"slack": "10 %"}),
            ("gravity is 9.81; it must be a vector", make.cable, [], ends | {"gravity": 9.81}),
            (
                "colour is no property of a Cable; known are",
                make.cable,
                [],
                ends | {"colour": "red"},
            ),
            (
                "bending_stiffness is 0.001 without a unit",
                make.cable_type,
                ["A"],
                {"bending_stiffness": 1e-3},
            ),
            (
                "axial_stiffness is 400 without a unit",
                make.cable_type,
                ["A"],
                {"axial_stiffness": 400},
            ),
            ("mass_per_length is '3 mm'", make.cable_type, ["A"], {"mass_per_length": "3 mm"}),
            (
                "bend_radius_convention is 'Outside'",
                make.cable_type,
                ["A"],
                {"bend_radius_convention": "Outside"},
            ),
            ("cannot be read", make.cable_type, ["A"], {"card": "none.FCMat"}),
            ("The cable is Left; it must be a cable", make.route, [self.left], {}),
        ):
            with self.subTest(words):
                self.check(words, function, *arguments, **keywords)
        self.check(
            "method is 'Guess'; it must be one of Spline", make.route, self.cable(), method="Guess"
        )


class HoldTest(SupportedTest):
    def test_a_support_takes_its_place_along_the_cable(self):
        places = {"middle": 0, "late": 25, "early": -25}
        for place in places:
            made = make.ring(
                self.doc, self.hole, offset=Placement(Vector(0, 0, places[place]), Rotation())
            )
            made.Label = place
            make.hold(self.cable, made)
        self.assertEqual([o.Label for o in self.cable.Supports], ["early", "middle", "late"])
        self.compute()
        # What was put in an order by hand stays.
        self.cable.Supports = self.cable.Supports[::-1]
        make.hold(
            self.cable,
            make.ring(self.doc, self.hole, offset=Placement(Vector(0, 0, 40), Rotation())),
        )
        self.assertEqual([o.Label for o in self.cable.Supports[:3]], ["late", "middle", "early"])

    def test_along_a_cable_that_is_not_solved_it_is_the_last(self):
        self.cable.Length = "10 mm"
        self.cable.NodePosition = []
        for _ in range(2):
            make.hold(self.cable, last := make.sleeve(self.doc, self.hole))
            self.assertIs(self.cable.Supports[-1], last)

    def test_wrong_arguments(self):
        ring = make.ring(self.doc, self.hole)
        with self.assertRaisesRegex(DocumentError, "must be a cable"):
            make.hold(self.part, ring)
        with self.assertRaisesRegex(DocumentError, "must be a clamp, sleeve, ring or clip"):
            make.hold(self.cable, self.start)
