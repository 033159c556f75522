# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report on all cables of a document: an HTML page that stands alone, and a spreadsheet in the document.

from freecad_cable.document import report
report.write(doc, folder)
"""

from .entry import Entry, Load, Verdict, collect
from .output import page_path, write
from .spreadsheet import sheet

__all__ = ["Entry", "Load", "Verdict", "collect", "page_path", "sheet", "write"]
