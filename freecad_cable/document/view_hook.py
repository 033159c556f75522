# SPDX-License-Identifier: LGPL-2.1-or-later
"""How an object gets its face in the window without this room knowing the window."""

attach = None
"""Called with an object that was made or opened; ``gui.views`` puts its function here."""
