# SPDX-License-Identifier: LGPL-2.1-or-later
"""A curve without mechanics."""

from .view import View


class RouteView(View):
    icon_name = "cable_route"
    line_colour = (0.96, 0.47, 0.0)
