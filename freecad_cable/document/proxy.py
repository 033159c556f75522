# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the proxies of all our objects share: properties, state in files, and what an error does."""

import traceback

import FreeCAD
import Part
from FreeCAD import Placement

from ..errors import CableError, DocumentError
from . import observer, view_hook
from .property_table import VERSION, complete, reset
from .sentences import in_language

SAID_BEFORE = "Error"
"""What FreeCAD says of an object that is still in error, but that the last recompute did not come to."""


class IncompleteError(DocumentError):
    """The results stand, but something that follows from them is missing."""


class OutdatedError(DocumentError):
    """The results are from before the last change, and better than none: no fault of the document keeps it from new
    ones."""


class Proxy:
    """Base of the proxies. FreeCAD makes one without ``__init__`` when it opens a file."""

    TABLE = ()

    def __init__(self, obj):
        obj.Proxy = self
        self.onDocumentRestored(obj)

    def onDocumentRestored(self, obj):
        """Also after copying."""
        complete(obj, self.TABLE)
        self.set_editor_modes(obj)
        observer.install()
        if view_hook.attach:
            view_hook.attach(obj)

    def set_editor_modes(self, obj):
        """What the property editor shows and lets the user change; files do not keep that."""

    def home(self, obj) -> Placement:
        """Where it belongs, whatever hand takes hold of it: the drag of an assembly moves all that has no joint."""
        return Placement()

    def run(self, obj):
        """What ``execute`` does. Errors: ``CableError`` with a sentence for the user."""
        raise NotImplementedError

    def execute(self, obj):
        try:
            self.run(obj)
        except CableError as error:
            if isinstance(error, OutdatedError):
                self.outdate(obj, str(error))
            elif isinstance(error, IncompleteError):
                obj.Status = str(error)
                self.clear_dependents(obj, str(error))
            else:
                self.clear(obj, str(error))
                self.clear_dependents(obj, str(error))
            # Without its cause: FreeCAD shows the sentence, and a traceback would hide it. It shows this one and keeps
            # none, so it is in the language of the window.
            raise DocumentError(in_language(str(error))) from None
        except Exception as error:
            sentence = f"{obj.Label}: {type(error).__name__}: {error}"
            self.clear(obj, sentence)
            self.clear_dependents(obj, sentence)
            # A fault of ours: whoever mends it wants to know where it is.
            FreeCAD.Console.PrintError(traceback.format_exc())
            raise DocumentError(sentence) from error

    def outdate(self, obj, sentence):
        """All stays, and says that and why it is from before."""
        for each in (obj, *observer.dependents(obj)):
            if proxy_of(each, Proxy):
                each.Status = sentence
                if hasattr(each, "OutOfDate"):
                    each.OutOfDate = True

    def clear_dependents(self, obj, sentence):
        """FreeCAD does not execute what depends on a failed object, so its old shape would stay and look new."""
        for dependent in observer.dependents(obj):
            if proxy := proxy_of(dependent, Proxy):
                proxy.clear(dependent, sentence)

    def has_said(self, obj):
        """Whether an error of ``obj`` is one of ``execute``, which cleared it; that of an expression comes before."""
        return not obj.isValid() and obj.getStatusString() in (SAID_BEFORE, in_language(obj.Status))

    def leave_behind(self, obj, failed):
        """FreeCAD did not execute ``obj``, because ``failed`` is in error: it, or what it depends on."""
        if not in_use(obj) or self.has_said(obj):
            return
        reason = " ".join(failed.getStatusString().split())  # it may be several lines
        if reason == SAID_BEFORE and failed.Label in obj.Status:
            return
        if hasattr(obj, "Shape") and obj.Shape.isNull():
            obj.Status = f"No shape yet: {failed.Label} cannot be computed ({reason})."
        else:
            obj.Status = (
                f"Out of date: {failed.Label} cannot be computed ({reason}). "
                "Shape and numbers are from before; mend it."
            )
        if hasattr(obj, "OutOfDate"):
            obj.OutOfDate = True
        obj.touch()

    def clear(self, obj, sentence):
        """No shape, no numbers, and the reason why."""
        reset(obj, self.TABLE)
        obj.Status = sentence
        if hasattr(obj, "Shape"):
            obj.Shape = Part.Shape()

    # FreeCAD up to 0.21 asks for the state by one pair of names, later by the other.
    def dumps(self):
        return None

    def loads(self, state):
        pass

    __getstate__ = dumps
    __setstate__ = loads


def in_use(obj):
    """Whether ``obj`` has all its properties: it is neither being made nor read from a file or a copy."""
    document = obj.Document
    return not (document.Restoring or document.Importing) and VERSION.name in obj.PropertiesList


def proxy_of(obj, kind):
    """The proxy of ``obj`` if it is of this class, else None."""
    proxy = getattr(obj, "Proxy", None)
    return proxy if isinstance(proxy, kind) else None
