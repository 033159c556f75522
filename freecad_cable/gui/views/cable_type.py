# SPDX-License-Identifier: LGPL-2.1-or-later
"""A type of cable has no shape."""

from .view import View


class CableTypeView(View):
    icon_name = "cable_type"
