# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the core and the document say in sentences with values in them, found in their source; see ``./run
translations``, and ``freecad_cable/document/sentences.py``, which shows them in the language of the window.

What is said is stored in documents, in English, so it cannot be translated where it is made. A template is the text of
the source with ``{1}``, ``{2}`` where the source puts values, without what goes before it, a label or another sentence,
and without the full stop: not every source ends its sentence itself.
"""

import ast
import re

CONTEXT = "Sentence"

LEFT_OUT = (
    # Say it in the language of the window by themselves.
    *("gui/*", "gui/*/*", "document/report/[!o]*"),
    # Met only in scene and study files, on the command line, in macros and in tests, where English stays.
    *("__main__.py", "demo/*", "reference/*", "problem/scene_file.py"),
    *("problem/obstacles.py", "study/study_file.py", "study/parameter.py", "study/variation.py"),
    *("study/program.py", "study/stopping.py", "document/make.py", "document/material_card.py"),
    # Tables and drawings stay as they are in the document.
    *("document/interference.py", "document/study_sheet.py", "study/plot.py", "study/rows_file.py"),
    # Words of files, no sentences.
    *("document/stored_solution.py", "document/material_library.py", "result/solution_file.py"),
)
"""Files of the package in which nobody with a mouse meets a sentence."""

NO_SENTENCES = re.compile(
    r"On recompute|not given|(user|derived), .*|.* -m pip .*|.* · .*|EI \0 N m²"
)
"""A choice of a property, sources of numbers, the command to install, versions, symbols: they stay as they are."""

WORDS = (
    *(": ", ". ", ".", "Warning", "has {1}", ", line {1}"),
    *("start", "end", "support {1}", "obstacle {1}", "length", "its length"),
    *("Edge{1} of {2}", "Face{1} of {2}", "Vertex{1} of {2}", "fatrop or ipopt"),
    *("bending", "torsional", "torsion", "shear", "stretch", "shear and stretch", "gravity"),
    *("obstacles", "shorter", "longer", "shortest", "longest", "positions", "quaternions"),
)
"""What sentences are joined by, and single words that stand for a value in them."""

SENTENCE = re.compile(r"[A-Za-z]{2}[,;:]?( \0[,;:]?)* [A-Za-z]|^[A-Za-z]+: \0$")
"""Two words, or a word before a sentence; anything else is a name."""


def templates(package):
    """Of all sentences in the folder ``package`` that are to be translated, sorted."""
    found = set(WORDS)
    for path in package.rglob("*.py"):
        if not any(path.relative_to(package).match(pattern) for pattern in LEFT_OUT):
            found.update(of_source(path.read_text(encoding="utf-8")))
    return sorted(found)


def of_source(source):
    """The templates in the text of a file."""
    texts = _Texts()
    texts.visit(ast.parse(source))
    for node in texts.found:
        text = _bare(node)
        if SENTENCE.search(text) and not NO_SENTENCES.fullmatch(text):
            parts = text.split("\0")
            numbered = (f"{{{i}}}{part}" for i, part in enumerate(parts[1:], 1))
            yield "".join([parts[0], *numbered])


class _Texts(ast.NodeVisitor):
    """Texts that a person may read, and none that is translated where it stands."""

    def __init__(self):
        self.found = []

    def visit_Expr(self, node):
        if not isinstance(node.value, ast.Constant):  # a docstring
            self.generic_visit(node)

    def visit_Assign(self, node):
        calls = [each.func for each in ast.walk(node) if isinstance(each, ast.Call)]
        if not any(getattr(func, "id", "") == "Prop" for func in calls):
            self.generic_visit(node)

    def visit_Call(self, node):
        name = getattr(node.func, "attr", getattr(node.func, "id", ""))
        if name not in ("Prop", "translate", "replace"):
            self.generic_visit(node)
        elif name == "replace":
            self.visit(node.func)

    def visit_Compare(self, node):
        """What is looked for in a sentence is none."""

    def visit_Constant(self, node):
        if isinstance(node.value, str):
            self.found.append(node)

    def visit_JoinedStr(self, node):
        self.found.append(node)
        for part in node.values:
            if isinstance(part, ast.FormattedValue):
                self.visit(part.value)


def _bare(node):
    """The text with a zero for each value."""
    parts = node.values if isinstance(node, ast.JoinedStr) else [node]
    text = "".join(part.value if isinstance(part, ast.Constant) else "\0" for part in parts)
    # A length comes in m, or in mm: its unit belongs to the value, and so does whatever else is put beside one.
    text = re.sub(r"\0 m(?![\w²³/·*^])", "\0", text)
    text = re.sub(r"\0+", "\0", text).strip()
    text = re.sub(r"^\0(, [\w\0]+)?: |^(\0[: ]*)+(?=[A-Z,])|^cable\.length: ", "", text)
    return text.removeprefix("Warning: ").removesuffix(".")
