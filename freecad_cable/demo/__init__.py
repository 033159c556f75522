# SPDX-License-Identifier: LGPL-2.1-or-later
"""The demo: cables on real input, headless, into a folder.

Uses the document as a macro would, and adds tables and pictures. ``./run demo`` calls ``main``.
"""

from .program import main

__all__ = ["main"]
