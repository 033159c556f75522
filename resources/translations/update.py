# SPDX-License-Identifier: LGPL-2.1-or-later
"""Brings ``Cable_*.ts`` up to date with the source, and makes the ``Cable_*.qm`` that FreeCAD reads; see ``./run
translations``.

Runs in FreeCAD's window, which knows the commands. What is not translated yet is printed, and stands in the file
without a translation; what the source no longer says is gone.
"""

import ast
import importlib
import os
import runpy
import shutil
import subprocess
import sys
import traceback
from pathlib import Path
from xml.etree import ElementTree as ET

FOLDER = Path(__file__).parent
PACKAGE = FOLDER.parents[1] / "freecad_cable"

LANGUAGES = ("de", "zh-CN")
"""As FreeCAD calls them: the end of the name of a file."""

OF_A_PROPERTY = "App::Property"
"""The context in which FreeCAD translates what the property editor says of a property."""


SENTENCES = runpy.run_path(str(FOLDER / "sentences.py"))


def source_strings():
    """(context, text) of all that a person reads in the window, sorted."""
    found = {("Workbench", "Cable")}
    for path in PACKAGE.rglob("*.py"):
        found.update(_literals(ast.parse(path.read_text(encoding="utf-8"))))
    found.update(_of_commands())
    found.update(_of_properties())
    for page in (FOLDER.parent / "ui").glob("*.ui"):
        found.update(_of_page(ET.parse(page).getroot()))
    found.update((SENTENCES["CONTEXT"], text) for text in SENTENCES["templates"](PACKAGE))
    return sorted(found)


def _literals(tree):
    """Of the calls of ``translate``. Errors: ``ValueError`` if one does not say its text literally."""
    for node in ast.walk(tree):
        name = getattr(
            getattr(node, "func", None), "attr", getattr(getattr(node, "func", None), "id", None)
        )
        if isinstance(node, ast.Call) and name in ("translate", "QT_TRANSLATE_NOOP"):
            if not all(isinstance(each, ast.Constant) for each in node.args[:2]):
                raise ValueError(f"line {node.lineno}: translate is not given its text")
            yield node.args[0].value, node.args[1].value


def _of_commands():
    """FreeCAD translates them in the context of their name."""
    from freecad_cable.gui.commands import COMMANDS

    for name, command in COMMANDS.items():
        resources = command.GetResources()
        yield from ((name, resources[key]) for key in ("MenuText", "ToolTip"))


def _of_properties():
    for path in (PACKAGE / "document").glob("*.py"):
        importlib.import_module(f"freecad_cable.document.{path.stem}")
    from freecad_cable.document.proxy import Proxy

    kinds = [Proxy]
    while kinds:
        kind = kinds.pop()
        kinds += kind.__subclasses__()
        yield from ((OF_A_PROPERTY, prop.text) for prop in kind.TABLE if not prop.hidden)
    from freecad_cable.gui.views.cable import SHOWN

    yield from ((OF_A_PROPERTY, text) for text in SHOWN.values())


def _of_page(root):
    for string in root.iter("string"):
        if string.get("notr") != "true":
            yield root.find("class").text, string.text


def translations(path):
    """(context, text): translation, of a ``.ts`` file; what is not translated is left out."""
    if not path.exists():
        return {}
    return {
        (context.find("name").text, message.find("source").text): message.find("translation").text
        for context in ET.parse(path).getroot().iter("context")
        for message in context.iter("message")
        if message.find("translation").text
    }


def write(path, language, strings, known):
    """The ``.ts`` file of a language: ``strings``, with the translations that are known."""
    root = ET.Element("TS", version="2.1", language=language.replace("-", "_"), sourcelanguage="en")
    for name in sorted({context for context, _ in strings}):
        context = ET.SubElement(root, "context")
        ET.SubElement(context, "name").text = name
        for text in (text for where, text in strings if where == name):
            message = ET.SubElement(context, "message")
            ET.SubElement(message, "source").text = text
            translation = ET.SubElement(message, "translation")
            translation.text = known.get((name, text))
            if not translation.text:
                translation.set("type", "unfinished")
    ET.indent(root)
    text = ET.tostring(root, "unicode")
    path.write_text(f'<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n{text}\n', "utf-8")


def main():
    strings = source_strings()
    for language in LANGUAGES:
        path = FOLDER / f"Cable_{language}.ts"
        known = translations(path)
        write(path, language, strings, known)
        for context, text in strings:
            if (context, text) not in known:
                print(f"{language}, {context}: {text}", file=sys.__stdout__)
        program = shutil.which("lrelease") or shutil.which("pyside6-lrelease")
        subprocess.run([program, "-silent", path, "-qm", path.with_suffix(".qm")], check=True)


if __name__ in ("__main__", "update"):
    # FreeCAD imports it. It returns 0 after an exception, and with a window does not end by itself.
    status = 1
    try:
        main()
        status = 0
    except Exception:  # noqa: BLE001 - becomes the exit code
        traceback.print_exc(file=sys.__stdout__)
    finally:
        sys.__stdout__.flush()
        os._exit(status)
