# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the documents of the demo look in FreeCAD's window.

Without a window FreeCAD stores no appearance, and what has none opens hidden.
"""

import zipfile
from xml.etree import ElementTree

from ..document.cable import Cable
from ..document.proxy import proxy_of
from ..document.route import Route
from ..document.study import Study
from .colours import COLOURS, METAL


def add_appearance(path, document):
    """Add to the file ``path`` of the document what is seen, and in which colour.

    Cables have the colours of the pictures; what is not named stays hidden.
    """
    root = ElementTree.Element("Document", SchemaVersion="1")
    views = ElementTree.SubElement(root, "ViewProviderData")
    for obj, properties in seen(document):
        view = ElementTree.SubElement(views, "ViewProvider", name=obj.Name, expanded="0")
        listed = ElementTree.SubElement(
            view, "Properties", Count=str(1 + len(properties)), TransientCount="0"
        )
        _add(listed, "Visibility", "Bool", "Bool", "true")
        for name, colour in properties.items():
            _add(listed, name, "Color", "PropertyColor", str(int(f"{colour[1:]}00", 16)))
    views.set("Count", str(len(views)))
    ElementTree.SubElement(root, "Camera", settings="")
    with zipfile.ZipFile(path, "a", zipfile.ZIP_DEFLATED) as file:
        file.writestr("GuiDocument.xml", ElementTree.tostring(root, "utf-8", xml_declaration=True))


def seen(document):
    """Pairs of an object and the colours of its view."""
    cables = [obj for obj in document.Objects if proxy_of(obj, Cable)]
    for obj in document.Objects:
        if obj in cables:
            yield (
                obj,
                {"ShapeColor": COLOURS[cables.index(obj)], "LineColor": COLOURS[cables.index(obj)]},
            )
        elif obj.TypeId == "Part::Feature":
            yield obj, {"ShapeColor": METAL, "LineColor": "#7d8892"}
        elif obj.TypeId == "App::Part" or proxy_of(obj, Route) or proxy_of(obj, Study):
            yield obj, {}


def _add(properties, name, kind, tag, value):
    entry = ElementTree.SubElement(properties, "Property", name=name, type=f"App::Property{kind}")
    ElementTree.SubElement(entry, tag, value=value)
