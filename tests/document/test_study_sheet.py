# SPDX-License-Identifier: LGPL-2.1-or-later
"""The spreadsheet of a study: its rows come and go, the cells of the user stay."""

from studies import StudyTest

from freecad_cable.document import studying
from freecad_cable.errors import DocumentError


class TestStudySheet(StudyTest):
    def setUp(self):
        super().setUp()
        self.varied = self.study(varied="Length", values=[300, 310, 320])
        studying.run(self.varied)
        self.sheet = self.varied.Sheet

    def put(self, **cells):
        for cell, text in cells.items():
            self.sheet.set(cell, text)
        self.doc.recompute()

    def run_with(self, **settings):
        for name, value in settings.items():
            setattr(self.varied, name, value)
        studying.run(self.varied)
        self.doc.recompute()

    def text(self, cell, sheet=None):
        return (sheet or self.sheet).getContents(cell).lstrip("'")

    def lengths(self, sheet=None):
        return [self.text(f"A{row}", sheet) for row in range(2, 8)]

    def test_cells_beside_and_below_stay(self):
        self.put(Z1="7", T30="=Z1 * 2", R2="beside", A5="'mean", B5="=average(B2:B4)")
        self.sheet.setAlias("Z1", "mine")
        self.sheet.setBackground("Z1", (1.0, 0.0, 0.0, 1.0))
        self.run_with(Values=[330, 340, 350])
        self.assertIs(self.varied.Sheet, self.sheet)
        self.assertEqual(self.lengths(), ["330", "340", "350", "mean", "", ""])
        self.assertEqual(self.text("R2"), "beside")
        self.assertEqual((self.sheet.mine, self.sheet.T30), (7, 14))
        self.assertEqual(self.sheet.getBackground("Z1")[:3], (1.0, 0.0, 0.0))
        self.assertAlmostEqual(self.sheet.B5, 340, places=3)

    def test_a_smaller_table_leaves_nothing_of_the_larger(self):
        self.put(Z1="7", A5="'mean")
        self.run_with(Values=[330, 340])
        self.assertIs(self.varied.Sheet, self.sheet)
        self.assertEqual(self.lengths(), ["330", "340", "", "mean", "", ""])
        self.assertIsNone(self.sheet.getBackground("A4"))
        self.assertEqual(self.text("B4"), "")
        self.assertEqual(self.sheet.Z1, 7)

    def test_a_larger_table_takes_what_is_free(self):
        self.put(A7="'mean", T30="5")
        self.run_with(Values=[330, 340, 350, 360, 370])
        self.assertIs(self.varied.Sheet, self.sheet)
        self.assertEqual(self.lengths(), ["330", "340", "350", "360", "370", "mean"])

    def test_a_larger_table_goes_elsewhere_where_a_cell_is_in_the_way(self):
        self.put(B5="=average(B2:B4)", T30="5")
        self.run_with(Values=[330, 340, 350, 360])
        new = self.varied.Sheet
        self.assertIsNot(new, self.sheet)
        self.assertEqual(self.lengths(sheet=new), ["330", "340", "350", "360", "", ""])
        self.assertEqual(self.lengths(), ["300", "310", "320", "", "", ""])
        self.assertAlmostEqual(self.sheet.B5, 310, places=3)
        self.run_with(Values=[330])
        self.assertIs(self.varied.Sheet, new)
        self.assertEqual(self.lengths(sheet=new), ["330", "", "", "", "", ""])
        self.assertEqual(self.lengths(), ["300", "310", "320", "", "", ""])

    def test_one_that_was_deleted_is_missed(self):
        self.doc.removeObject(self.sheet.Name)
        self.doc.recompute()
        self.assertTrue(self.varied.OutOfDate)
        self.assertIn("spreadsheet is not there", self.varied.Status)
        self.run_with()
        self.assertFalse(self.varied.OutOfDate)
        self.assertEqual(self.varied.Status, "")
        self.assertEqual(self.lengths(self.varied.Sheet), ["300", "310", "320", "", "", ""])

    def test_columns_come_and_go(self):
        self.put(Z1="7")
        self.run_with(Kind="Corners", StiffnessFactor=2.0)
        self.assertEqual(self.text("R1"), "Note")
        self.assertIsNone(self.sheet.getBackground("A2"))
        self.run_with(Kind="Values")
        self.assertEqual(self.text("Q1"), "Note")
        self.assertEqual(self.text("R1"), "")
        self.assertIsNone(self.sheet.getStyle("R1"))
        self.assertIsNotNone(self.sheet.getBackground("A2"))
        self.assertIs(self.varied.Sheet, self.sheet)
        self.assertEqual(self.sheet.Z1, 7)

    def test_a_name_that_the_user_gives_a_cell_of_the_table_stays(self):
        self.sheet.setAlias("B2", "first")
        self.put(Z1="=first * 2")
        self.run_with(Values=[330, 340, 350])
        self.assertEqual(self.sheet.getAlias("B2"), "first")
        self.assertAlmostEqual(self.sheet.Z1, 660, places=3)

    def test_what_is_to_be_recorded(self):
        self.run_with(Record=["End force", "Smallest bend radius"])
        heads = [self.text(f"{letter}1") for letter in "ABCDE"]
        self.assertEqual(heads[1:], ["End force [N]", "Smallest bend radius [mm]", "Note", ""])
        self.assertEqual(self.text("E2"), "")
        with self.assertRaisesRegex(DocumentError, "Record: has Colour, which is no column"):
            self.run_with(Record=["Colour"])
