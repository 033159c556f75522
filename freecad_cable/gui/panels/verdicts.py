# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is to be judged about a cable, as text and colour."""

import math
from html import escape

import FreeCAD
from FreeCAD import Units
from PySide import QtCore, QtGui

from ...document.sentences import in_language

translate = FreeCAD.Qt.translate

GOOD, DOUBTFUL, BAD, NEUTRAL = "#2e8b57", "#c17d11", "#cc0000", ""
"""Read on light and on dark."""

SIGNS = {GOOD: "✓", DOUBTFUL: "!", BAD: "✗", NEUTRAL: ""}
"""For those who do not see the colours."""

SCARCE = 0.1
"""Margin, as a share of the limit, below which a bend radius is worth a look."""


class Verdicts(QtGui.QLabel):
    """Rows of what, how much, and whether that is good."""

    def __init__(self):
        super().__init__()
        self.setObjectName("Verdicts")
        self.setTextFormat(QtCore.Qt.RichText)
        self.setWordWrap(True)
        self.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)

    def show_verdict(self, verdict, tolerance, more=()):
        """``tolerance`` of position, in mm; ``verdict`` None: there is nothing to say. ``more``: rows of what and how
        much."""
        found = [*rows(verdict, tolerance), *((*row, NEUTRAL) for row in more)] if verdict else []
        self.setText(_table(found) if found else "")


class Said(QtGui.QLabel):
    """One sentence, and how it stands."""

    def __init__(self):
        super().__init__()
        self.setObjectName("Said")
        self.setTextFormat(QtCore.Qt.RichText)
        self.setWordWrap(True)
        self.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)

    def say(self, sentence, colour=NEUTRAL):
        """What the document says comes in English."""
        self.setText(_coloured(f"{SIGNS[colour]} {in_language(sentence)}".strip(), colour))


def rows(verdict, tolerance):
    """(what, how much, colour) of a ``Verdict``."""
    yield translate("Cable", "Length"), length(verdict.length), NEUTRAL
    yield translate("Cable", "Smallest bend radius"), _bend(verdict), NEUTRAL
    yield translate("Cable", "Bend radius margin"), *_margin(verdict)
    yield translate("Cable", "Clearance"), *_clearance(verdict)
    if verdict.stable:
        yield translate("Cable", "Stability"), translate("Cable", "stable"), GOOD
    else:
        yield translate("Cable", "Stability"), translate("Cable", "not stable"), BAD
    exact = verdict.error <= tolerance
    yield translate("Cable", "Error estimate"), length(verdict.error), GOOD if exact else DOUBTFUL


def _bend(verdict):
    if math.isinf(verdict.bend_radius):
        return translate("Cable", "straight")
    return translate("Cable", "{radius} at {place} from the start").format(
        radius=length(verdict.bend_radius), place=length(verdict.bend_at)
    )


def _margin(verdict):
    if not verdict.limit:
        return translate("Cable", "its type has no limit"), NEUTRAL
    if math.isinf(verdict.margin):
        return translate("Cable", "straight"), GOOD
    if verdict.margin < 0:
        said, colour = translate("Cable", "{margin} below {limit}"), BAD
    else:
        said = translate("Cable", "{margin} above {limit}")
        colour = GOOD if verdict.margin >= SCARCE * verdict.limit else DOUBTFUL
    return said.format(margin=length(abs(verdict.margin)), limit=length(verdict.limit)), colour


def _clearance(verdict):
    if math.isinf(verdict.clearance):
        return translate("Cable", "no obstacle in reach"), NEUTRAL
    # What a solve leaves between its nodes is no violation.
    short = verdict.clearance < verdict.clearance_asked - 0.05
    return length(verdict.clearance), BAD if short else GOOD


def length(value):
    """In the units that the user has chosen."""
    return Units.Quantity(value, Units.Length).UserString


def _table(found):
    lines = "".join(
        f"<tr><td>{escape(what)}&nbsp;&nbsp;</td>"
        f"<td>{_coloured(f'{SIGNS[colour]} {how_much}'.strip(), colour)}</td></tr>"
        for what, how_much, colour in found
    )
    return f"<table>{lines}</table>"


def _coloured(text, colour):
    return f'<span style="color:{colour}">{escape(text)}</span>' if colour else escape(text)
