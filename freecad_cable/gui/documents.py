# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents, as those see them who come back to them later: closed, changed or busy meanwhile."""

from contextlib import suppress

import FreeCAD


def alive(key):
    """The cable, if its document is still open and it is still there."""
    document, name = key
    with suppress(NameError):
        return FreeCAD.getDocument(document).getObject(name)
    return None


def is_busy(document):
    return document.Recomputing or document.Restoring or document.Importing or document.Transacting


def recompute(objects):
    for document in {obj.Document.Name for obj in objects}:
        FreeCAD.getDocument(document).recompute(
            [obj for obj in objects if obj.Document.Name == document]
        )
