# SPDX-License-Identifier: LGPL-2.1-or-later
"""Terminals of the demo's connectors."""

from ..document import make


def plugged(document, circles, name, connector):
    """The terminal at a connector. A cable is plugged in before its plug is locked, so it turns until it is free of
    twist."""
    reference = circles.reference(connector.centre, connector.radius)
    terminal = make.terminal(document, reference, condition="Swivel")
    terminal.Label = name
    return terminal
