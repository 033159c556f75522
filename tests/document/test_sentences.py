# SPDX-License-Identifier: LGPL-2.1-or-later
"""What real documents say is all German in a German window, and Chinese in a Chinese one, and stays English in the
document."""

import re
from unittest import mock
from xml.etree import ElementTree as ET

import Part
from FreeCAD import Placement, Rotation, Vector
from scenes import DocumentTest, SupportedTest

from freecad_cable.document import make, proxy, sentences, solving, studying
from freecad_cable.document.sentences import in_language
from freecad_cable.errors import CableError, SolverMissingError

LATIN = re.compile(r"[A-Za-zÄÖÜäöüß]+")

PLACE = re.compile(r"\{\d+\}")


def words(tag):
    """Those of all sentences, or of all German ones."""
    root = ET.parse(sentences.FOLDER / "Cable_de.ts").getroot()
    (context,) = (each for each in root if each.findtext("name") == sentences.CONTEXT)
    return {word for text in context.iter(tag) for word in LATIN.findall(PLACE.sub("", text.text))}


ENGLISH = words("source") - words("translation")
"""Names of properties are in both."""


class LanguageTest(SupportedTest):
    """Labels are such that no sentence has their words."""

    def setUp(self):
        super().setUp()
        self.cable.Label, self.type.Label, self.part.Label = "K1", "T1", "P1"
        self.start.Label, self.end.Label = "A1", "A2"

    def said(self, obj, name="Status"):
        """What a property says in German, after a recompute."""
        self.doc.recompute()
        value = getattr(obj, name)
        return [self.german(each) for each in ([value] if isinstance(value, str) else value)]

    def german(self, text):
        german, chinese = in_language(text, "de"), in_language(text, "zh-CN")
        self.assertNotEqual(german, text)
        self.assertEqual(set(LATIN.findall(german)) & ENGLISH, set(), german)
        self.assertEqual(set(LATIN.findall(chinese)) & ENGLISH, set(), chinese)
        self.assertEqual(sorted(re.findall(r"\d+", text)), sorted(re.findall(r"\d+", german)))
        return german

    def check(self, obj, *expected):
        """A part of the German sentence, which the document has in English."""
        before = obj.Status
        (german,) = self.said(obj)
        for part in expected:
            self.assertIn(part, german)
        self.assertNotIn(german, (before, obj.Status))
        return german

    def test_the_vocabulary(self):
        self.assertLessEqual({"the", "is", "cable", "must", "which"}, ENGLISH)
        self.assertFalse({"MinBendRadius", "Clamped", "in"} & ENGLISH)

    def test_converged_with_a_warning(self):
        self.type.MinBendRadius = "200 mm"
        german = self.check(self.cable, "Das Kabel ist im Gleichgewicht. ", "Warnung: die engste")
        self.assertIn("enger als die 200 mm, die T1 erlaubt (innen an der Biegung).", german)

    def test_another_language_has_another_order_and_other_stops(self):
        self.type.MinBendRadius = "200 mm"
        self.doc.recompute()
        said = in_language(self.cable.Status, "zh-CN")
        self.assertRegex(said, "^线缆处于平衡。.*警告：.* T1 所允许的 200 mm（在弯曲内侧）。")

    def test_the_model(self):
        self.end.Condition = "Swivel"
        german = self.said(self.cable, "ModelUsed")
        self.assertIn("Berücksichtigt: Biegung in zwei Richtungen", german)
        self.assertTrue(any(line.startswith("Weggelassen: Torsion: das Ende") for line in german))
        self.assertTrue(any(line.startswith("Gelöst mit ") for line in german))

    def test_a_section(self):
        self.type.SecondBendingStiffness = "0.05 N*m^2"
        self.check(self.type, "Durchmesser 7 mm", " und 0.05 N m²")
        self.type.MassPerLength = "4.46 kg/m"
        self.check(self.type, "Warnung: bei diesem Durchmesser bedeutet die Masse")

    def test_too_short(self):
        self.cable.Length = "100 mm"
        self.check(self.cable, "K1, Length: ist 100 mm, aber die Anschlüsse sind 120 mm ausein")

    def test_numbers_that_are_none(self):
        self.cable.Length = -3
        self.check(self.cable, "es muss größer als 0 mm sein.")
        self.cable.Length, self.cable.Tolerance = 300, 1
        self.check(self.cable, "es muss zwischen 1e-10 und 0.1 liegen.")

    def test_the_shortest_length(self):
        self.type.MinBendRadius, self.cable.LengthMode = "25 mm", "Shortest"
        self.check(self.cable, "Wenn kürzer als ", "28.5 mm ist die Grenze.")
        self.type.MinBendRadius = "70 mm"
        self.check(self.cable, "ist Shortest. Keine Form dieses Kabels erfüllt", "Keine Länge bis")

    def test_a_bend_that_is_formed(self):
        self.type.MinBendRadius, self.cable.BendRadiusMode = "50 mm", "Enforce"
        for line in self.said(self.cable, "FormedPlaces"):
            self.assertRegex(line, "^Von .* wenn es dort geformt wird, mit einem Moment von")
        self.check(self.cable, "geformt wird")

    def test_a_support_out_of_reach(self):
        ring = self.support("ring")
        ring.Label, self.part.Placement.Base.z = "H1", 500
        self.check(self.cable, "aber der Weg durch seine Halterungen ist")
        self.end.Condition = "Free"
        self.check(self.cable, "H1 ist ", "von Anfang entfernt", "reicht daher nicht")

    def test_supports_that_are_wrong(self):
        first, second = (self.support("clip", position=f"{at} mm") for at in (140, 165))
        first.Label, second.Label = "H1", "H2"
        second.Offset = Placement(Vector(0, 0, 20), Rotation())
        self.cable.Supports = [second, first]
        self.check(self.cable, "H1, Position, ist 140 mm, aber Halterung H2 davor ist bei 165 mm")
        self.cable.Supports = [first, first]
        self.check(self.cable, "enthält H1 zweimal")

    def test_obstacles(self):
        box = self.doc.addObject("Part::Box", "Box")
        box.Label, box.Placement.Base.z = "B1", -30
        self.cable.Obstacles = [(box, "")]
        lines = self.said(self.cable, "ModelUsed")
        self.assertTrue(
            any("Hindernisse in Reichweite: das Kabel" in line for line in lines), lines
        )
        self.doc.removeObject(self.part.Name)
        group = self.doc.addObject("App::Part", "Group")
        group.Label = "G1"
        self.cable.Obstacles = [(group, "")]
        self.check(self.cable, "enthält G1, das keinen Körper hat")

    def test_a_part_that_has_changed(self):
        self.end.Reference = [(self.part, "Edge99")]
        self.check(self.end, "A2, Reference: Edge99 von P1 fehlt", "Etwas anderes wählen.")
        self.doc.removeObject(self.part.Name)
        self.check(self.end, "ist leer: das Objekt wurde gelöscht")

    def test_a_profile(self):
        sketch = self.doc.addObject("Part::Feature", "Sketch")
        sketch.Label = "S1"
        sketch.Shape = Part.makePolygon([Vector(), Vector(1, 0, 0), Vector(1, 1, 0)])
        self.cable.Profile = sketch
        self.check(self.cable, "Profile: S1: Das Profil ist nicht geschlossen")

    def test_a_cable_that_waits(self):
        self.cable.Update, self.cable.Length = "Manual", "310 mm"
        self.check(self.cable, "Veraltet: Update ist Manual; „Jetzt lösen“")
        solving.stopped(self.cable)
        self.german(self.cable.Status)

    def test_a_route_and_a_study(self):
        route = make.route(self.doc, self.cable, method="Catenary")
        route.Label, self.cable.Gravity = "W1", Vector()
        self.check(route, "Catenary kann nicht gezeichnet werden: Schwerkraft: ist null")
        study = make.study(self.doc, self.cable, varied="Length", start=300, stop=320, count=1)
        study.Label = "D1"
        self.check(study, "Noch keine Ergebnisse")
        with self.assertRaises(CableError) as caught:
            studying.run(study)
        self.assertIn("es muss mindestens 2 sein.", self.german(str(caught.exception)))

    def test_without_casadi(self):
        error = SolverMissingError(
            "CasADi is not installed, so no cable can be solved; what was solved before can still be seen. "
            "Install it with: python3.11 -m pip install --no-deps casadi"
        )
        self.cable.Length = "310 mm"
        with mock.patch.object(solving, "find_equilibrium", side_effect=error):
            self.doc.recompute()
        german = in_language(self.cable.Status, "de")
        self.assertIn("bleibt zu sehen. Installieren mit: python3.11 -m pip install --no", german)

    def test_freecad_shows_it_and_the_document_keeps_english(self):
        with mock.patch.object(proxy, "in_language", lambda text: in_language(text, "de")):
            self.cable.Length = "100 mm"
            self.doc.recompute()
        self.assertIn("aber die Anschlüsse", self.cable.getStatusString())
        self.assertIn("but the terminals", self.cable.Status)
        self.assertIn("but the terminals", self.cable.Centreline.Status)


class TextTest(DocumentTest):
    """Without a document."""

    def test_english_stays(self):
        said = "The cable is in equilibrium."
        self.assertEqual(in_language(said), said)
        self.assertEqual(in_language(said, "en"), said)
        self.assertEqual(in_language(said, "xx"), said)

    def test_what_nobody_has_translated_stays_and_the_rest_does_not(self):
        said = "Foo: the solver broke off: division by zero. Bar."
        self.assertEqual(in_language(said, "de"), "Foo: der Löser brach ab: division by zero. Bar.")
        for said in ("", " ", "Das Kabel ist im Gleichgewicht.", "3.5 mm", "{1} {x}"):
            self.assertEqual(in_language(said, "de"), said)

    def test_a_label_is_no_word(self):
        said = "start line, End: is the end, which is no cable terminal; choose a terminal."
        self.assertEqual(
            in_language(said, "de"),
            "start line, End: ist the end, das kein Kabelanschluss ist; einen Anschluss wählen.",
        )

    def test_a_value_does_not_reach_into_the_sentence_before(self):
        """There is an "is the" in both, and the second begins with a value."""
        said = (
            "it bends to 5 mm at 7 mm, and 6 mm is the limit. 9 mm is the longest at which an equilibrium was found. "
            "At 10 mm: The solver found no equilibrium."
        )
        self.assertEqual(
            in_language(said, "de"),
            "es biegt sich auf 5 mm bei 7 mm, und 6 mm ist die Grenze. 9 mm ist die größte Länge, bei der ein "
            "Gleichgewicht gefunden wurde. Bei 10 mm: Der Löser hat kein Gleichgewicht gefunden.",
        )
        self.assertIn("限值为 6 mm。9 mm 是找到平衡的最长长度。", in_language(said, "zh-CN"))

    def test_a_value_may_be_several_sentences(self):
        said = (
            "No length up to 1 m will do. The best is 500 mm, but The solver found no equilibrium. It is 3 s.; "
            "a limit that this length keeps, other ends or supports, or a softer cable would help."
        )
        self.assertEqual(
            in_language(said, "de"),
            "Keine Länge bis 1 m genügt. Am besten ist 500 mm, aber Der Löser hat kein Gleichgewicht gefunden. Sie "
            "beträgt 3 s.; eine Grenze, die diese Länge einhält, andere Enden oder Halterungen oder ein weicheres "
            "Kabel würden helfen.",
        )
