# SPDX-License-Identifier: LGPL-2.1-or-later
"""The centreline of a cable."""

from .view import View


class CentrelineView(View):
    icon_name = "cable_centreline"
