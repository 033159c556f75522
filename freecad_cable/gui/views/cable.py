# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cable, and under it in the tree what belongs to it."""

from .view import View


class CableView(View):
    icon_name = "cable"

    def claimChildren(self):
        """The terminals and supports, and what is drawn from the cable."""
        cable = self.object
        ours = [obj for obj in cable.InList if hasattr(getattr(obj, "Proxy", None), "TABLE")]
        return [obj for obj in (cable.Start, *cable.Supports, cable.End, *ours) if obj]
