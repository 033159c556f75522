# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inputs have units, and expressions drive them."""

from FreeCAD import Units
from scenes import TOP, DocumentTest

from freecad_cable.document import make

PLAIN = {
    "Slack": "a share",
    "Tolerance": "a share",
    "Gravity": "in m/s^2",
    "NaturalCurvature": "in 1/m",
}
"""Inputs that are numbers without a unit, and what their text says: FreeCAD's vectors have none."""

NUMBERS = ("Float", "Vector", "Integer")

UNITED = ("Distance", "Angle", "Quantity", "Force", "Pressure")


class ExpressionTest(DocumentTest):
    def setUp(self):
        super().setUp()
        self.cable_between_pins()
        supports = [make.clamp, make.clip, make.ring, make.sleeve]
        self.supports = [
            make_one(self.doc, (self.left, TOP), position="60 mm") for make_one in supports
        ]
        self.compute()
        self.ours = [self.cable, self.type, self.start, self.end, *self.supports]

    def inputs(self):
        return [
            (obj, p) for obj in self.ours for p in obj.Proxy.TABLE if not (p.result or p.hidden)
        ]

    def test_every_input_with_a_unit_has_it(self):
        for obj, prop in self.inputs():
            if prop.kind in NUMBERS:
                self.assertIn(prop.name, PLAIN, f"{obj.Name}.{prop.name} has no unit")
                if PLAIN[prop.name] != "a share":
                    self.assertIn(PLAIN[prop.name], prop.text)
            elif prop.kind in UNITED:
                value = getattr(obj, prop.name)
                self.assertNotEqual(value.Unit, Units.Unit(), prop.name)
                self.assertEqual(value.Unit, Units.Quantity(f"1 {prop.unit}").Unit, prop.name)

    def test_every_input_with_a_unit_takes_an_expression_in_another_one(self):
        sheet = self.doc.addObject("Spreadsheet::Sheet", "Sheet")
        other = {"mm": "0.012 m", "deg": "0.2 rad", "N": "0.3 kN", "Pa": "2 GPa"}
        other |= {"kg/m": "31 g/m", "N*m^2": "2100 N*mm^2", "kg/m^3": "1.3 g/cm^3"}
        for unit, value in other.items():
            alias = "of_" + "".join(c if c.isalnum() else "_" for c in unit)
            cell = f"A{list(other).index(unit) + 1}"
            # A spreadsheet reads N*mm^2 only with a number before each unit.
            sheet.set(cell, f"={value}".replace("*", " * 1 "))
            sheet.setAlias(cell, alias)
            self.doc.recompute()
            for obj, prop in self.inputs():
                if prop.name == "Radius":
                    continue  # that of the circle which the ring sits on
                if prop.kind in UNITED and prop.unit == unit:
                    obj.setExpression(prop.name, f"Sheet.{alias}")
                    obj.recompute()
                    expected = Units.Quantity(value).getValueAs(unit).Value
                    found = getattr(obj, prop.name).getValueAs(unit).Value
                    self.assertAlmostEqual(found / expected, 1, delta=1e-9, msg=prop.name)
                    obj.setExpression(prop.name, None)

    def test_a_cable_follows_a_spreadsheet(self):
        sheet = self.doc.addObject("Spreadsheet::Sheet", "Sheet")
        sheet.set("A1", "=0.31 m")
        self.doc.recompute()
        self.cable.setExpression("Length", "Sheet.A1 + 2 cm")
        self.end.setExpression("Roll", "90 deg * 2")
        self.compute()
        self.assertAlmostEqual(self.cable.SolvedLength.Value, 330, delta=1e-9)
        sheet.set("A1", "=0.32 m")
        self.compute()
        self.assertAlmostEqual(self.cable.SolvedLength.Value, 340, delta=1e-9)
        self.assertEqual(self.end.Roll.Value, 180)
        # And what it found can be used by others.
        box = self.doc.addObject("Part::Box", "Box")
        box.setExpression("Length", f"{self.cable.Name}.SmallestBendRadius")
        self.compute()
        self.assertEqual(box.Length.Value, self.cable.SmallestBendRadius.Value)
