# SPDX-License-Identifier: LGPL-2.1-or-later
"""What holds a cable on its way."""

from .view import View


class SupportView(View):
    line_colour = (0.2, 0.4, 0.64)

    def make_panel(self):
        from ..panels.support import SupportPanel

        return SupportPanel(self.object)


class ClampView(SupportView):
    icon_name = "cable_clamp"


class ClipView(SupportView):
    icon_name = "cable_clip"


class RingView(SupportView):
    icon_name = "cable_ring"


class SleeveView(SupportView):
    icon_name = "cable_sleeve"
