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

    def run(self, obj):
        cable = self.linked_cable(obj)
        if cable.OutOfDate and not cable.SolvedInputs:
            self.clear(obj, cable.Status)  # it is being solved for the first time
        else:
            self.follow(obj, self._solved(cable))

    def follow(self, obj, cable):
        """What ``execute`` does with a cable that has an answer."""
        raise NotImplementedError

    def _solved(self, cable):
        if not cable.SolvedInputs:
            raise DocumentError(cable.Status or f"{cable.Label} is not solved; recompute it.")
        return cable
