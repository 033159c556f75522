# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panels: change and see. Each edits the properties of one object, in one step of undo."""
