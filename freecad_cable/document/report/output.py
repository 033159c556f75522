# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write the report of a document."""

import re
from datetime import datetime
from pathlib import Path

import FreeCAD

from ... import __version__
from ...errors import DocumentError
from .. import solving
from .drawing import outlines
from .entry import collect
from .page import page
from .spreadsheet import sheet

translate = FreeCAD.Qt.translate

NO_NAME = re.compile(r"[^\w.-]+")
"""What does not belong into the name of a file."""


def write(doc, folder, *, picture=None) -> Path:
    """The page into ``folder``, which is made if it is not there, and the spreadsheet ``CableReport`` into the
    document, which is recomputed before. Returns the path of the page, named after the document.

    ``picture``: the path of a PNG to put on it, as a picture of the window. Errors: ``DocumentError`` if the page
    cannot be written.
    """
    doc.recompute()
    solving.wait(doc)
    entries = collect(doc)
    sheet(doc, entries)
    doc.recompute()
    path = page_path(doc, folder)
    try:
        shown = Path(picture).read_bytes() if picture else None
        title = translate("CableReport", "Cables of {document}").format(document=doc.Label)
        text = page(title, _meta(doc), entries, outlines(doc), shown)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    except OSError as error:
        raise DocumentError(
            f"The report cannot be written: {error.filename}: {error.strerror}; choose another folder."
        ) from None
    return path


def page_path(doc, folder) -> Path:
    """Where the page of a document is written."""
    stem = NO_NAME.sub("-", Path(doc.FileName).stem or doc.Label)
    return Path(folder) / f"{stem}-cables.html"


def _meta(doc):
    freecad = ".".join(FreeCAD.Version()[:3]).split()[0]
    now = datetime.now().astimezone().strftime("%Y-%m-%d %H:%M %Z")
    return f"{doc.FileName or doc.Label} · {now} · FreeCAD {freecad}, Cable {__version__}"
