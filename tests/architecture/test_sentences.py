# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every sentence that the source can say in a document has its German and its Chinese, with the same values in it."""

import re
import runpy
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest

CHECKOUT = Path(__file__).resolve().parents[2]
PACKAGE = CHECKOUT / "freecad_cable"
FOLDER = CHECKOUT / "resources" / "translations"

SENTENCES = runpy.run_path(str(FOLDER / "sentences.py"))

PLACE = re.compile(r"\{\d+\}")


def translations(language):
    """(source, translation) of the sentences of a language; an unfinished translation is None."""
    root = ET.parse(FOLDER / f"Cable_{language}.ts").getroot()
    return [
        (message.findtext("source"), message.findtext("translation"))
        for context in root.iter("context")
        for message in context.iter("message")
        if context.findtext("name") == SENTENCES["CONTEXT"]
    ]


@pytest.mark.parametrize("language", ["de", "zh-CN"])
def test_the_list_is_that_of_the_source(language):
    known = [source for source, _ in translations(language)]
    assert len(set(known)) == len(known) > 200
    assert sorted(known) == SENTENCES["templates"](PACKAGE), "./run translations"


@pytest.mark.parametrize("language", ["de", "zh-CN"])
def test_every_sentence_is_translated_with_its_values(language):
    for source, translation in translations(language):
        assert translation, source
        assert sorted(PLACE.findall(source)) == sorted(PLACE.findall(translation)), source
        # A value at the end takes in what is left of the sentence, as its translation must.
        assert translation.endswith(".") == source.endswith(".") or language == "zh-CN", source


def test_what_is_left_out_is_there():
    paths = [path.relative_to(PACKAGE) for path in PACKAGE.rglob("*.py")]
    for pattern in SENTENCES["LEFT_OUT"]:
        assert any(path.match(pattern) for path in paths), pattern


@pytest.mark.parametrize(
    ("source", "expected"),
    [
        ('x = "The solver found no equilibrium."', ["The solver found no equilibrium"]),
        ('f"is {value:g} m; it must be less"', ["is {1}; it must be less"]),
        ('f"is {value:g} N m; it must be less"', ["is {1} N m; it must be less"]),
        ('f"is {value}{unit}; it must be at least {b}"', ["is {1}; it must be at least {2}"]),
        ('f"{obj.Label}: the solver broke off: {e}."', ["the solver broke off: {1}"]),
        ('f"{Status.A.value} It is {time} s."', ["It is {1} s"]),
        ('f"{Status.A.value} {said}, and no more."', [", and no more"]),
        ('f"{name} cannot be drawn: {e}"', ["{1} cannot be drawn: {2}"]),
        ('f"Warning: it is {a} of {b}"', ["it is {1} of {2}"]),
        ('f"Kept: {said}"', ["Kept: {1}"]),
        ("f\"torn ({'at the end' if end else 1})\"", ["at the end"]),
        ('f"{a} to {b}"', []),
        ('f"{name}Force"', []),
        ('TABLE = (Prop("A", "What it is made of"),)', []),
        ('text = translate("Cable", "What it is made of")', []),
        ('found = "rims of rings" in said', []),
        ('def f():\n    """What it does."""', []),
    ],
)
def test_what_is_a_sentence(source, expected):
    assert list(SENTENCES["of_source"](source)) == expected
