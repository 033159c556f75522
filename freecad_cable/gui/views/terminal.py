# SPDX-License-Identifier: LGPL-2.1-or-later
"""An arrow or plane where a connector holds a cable."""

from .view import View


class TerminalView(View):
    icon_name = "cable_terminal"
    line_colour = (0.2, 0.4, 0.64)

    def make_panel(self):
        from ..panels.terminal import TerminalPanel

        return TerminalPanel(self.object)
