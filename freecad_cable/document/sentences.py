# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sentences that are stored in English, in the language of the window.

``Status`` and the like are part of the file format, and their sentences hold values, so they are translated where they
are shown: taken to pieces by the templates that ``./run translations`` finds in the source and writes, with their
translations, into ``resources/translations/Cable_*.ts``. Without a window the language is English."""

import re
from functools import lru_cache
from pathlib import Path
from xml.etree import ElementTree as ET

import FreeCAD

translate = FreeCAD.Qt.translate

FOLDER = Path(__file__).parents[2] / "resources" / "translations"

CONTEXT = "Sentence"

INSIDE, ANY = r"((?:(?!\. ).)*?)", "(.*?)"
"""A value within a sentence, as almost all are, and one that may be several sentences."""

WORD = re.compile(r"(\{1\} )?\w+( \{\d\})?")
"""What says so little that it is translated only where it is a whole value: an object may be called the same."""


def in_language(text, language="") -> str:
    """A sentence, several, or a part of one. ``language`` is that of the window if it is not given; what nobody has
    translated stays as it is."""
    return _translated(text, language or translate("CableReport", "en"))


class _Template:
    """A sentence with places for values, and its translation."""

    def __init__(self, text, translation):
        self.translation = translation
        self.is_word = bool(WORD.fullmatch(text))
        self.said = re.split(r"\{\d+\}", text)
        begin = r"(?<!\w)" if text[0].isalnum() else r"(?<!\S)(?=\S)" if text[0] == "{" else ""
        # A value at the end goes as far as the sentence; a number that is said goes with its unit.
        end = r"(?=\.?$|\. )" if text.endswith("}") else r"(?! ?\w)" if text.strip() == text else ""
        parts = [re.escape(part) for part in self.said]
        self.patterns = [
            re.compile(begin + value.join(parts) + end, re.DOTALL) for value in (INSIDE, ANY)
        ]

    def match(self, text):
        if not all(part in text for part in self.said):  # saves most searches
            return None
        if self.is_word:
            return self.patterns[0].fullmatch(text)
        return next(filter(None, (pattern.search(text) for pattern in self.patterns)), None)


@lru_cache
def _templates(language):
    """Of a language, what says most first: it may hold others as values."""
    path = FOLDER / f"Cable_{language}.ts"
    if not path.exists():
        return []
    found = [
        _Template(message.findtext("source"), message.findtext("translation"))
        for context in ET.parse(path).getroot().iter("context")
        for message in context.iter("message")
        if context.findtext("name") == CONTEXT and message.findtext("translation")
    ]
    return sorted(found, key=lambda each: -sum(map(len, each.said)))


@lru_cache(maxsize=1000)
def _translated(text, language):
    for template in _templates(language) if text.strip() else ():
        if (match := template.match(text)) is None:
            continue
        before, after = text[: match.start()], text[match.end() :]
        values = (_translated(value, language) for value in match.groups())
        said = template.translation.format("", *values)
        return _translated(before, language) + said + _translated(after, language)
    return text
