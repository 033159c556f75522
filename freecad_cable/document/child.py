# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is drawn beside a cable and stands under it in the tree."""

from ..errors import DocumentError
from .cable import Cable
from .property_table import Prop, wrong
from .proxy import Proxy, proxy_of

CABLE = Prop("Cable", "Link", "Cable", "The cable it belongs to")


class Child(Proxy):
    """Base of what belongs to one cable."""

    def linked_cable(self, obj):
        """The cable. Errors: ``DocumentError`` if there is none."""
        cable = obj.Cable
        if cable is None:
            raise wrong(
                obj, "Cable", "is empty: the cable was deleted; delete this too or choose another."
            )
        if proxy_of(cable, Cable) is None:
            raise wrong(obj, "Cable", f"is {cable.Label}, which is no cable; choose a cable.")
        return cable

    def solved_cable(self, obj):
        """The same, with an answer."""
        cable = self.linked_cable(obj)
        if not cable.SolvedInputs:
            raise DocumentError(cable.Status or f"{cable.Label} is not solved; recompute it.")
        return cable
