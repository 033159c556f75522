# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the statement to an optimal control problem along the arc length, in CasADi.

Arc length plays the part of time (Kirchhoff's kinetic analogue): the state of a stage is a node's position
and frame, its control the strain of the element, its dynamics the step along a screw, its cost the element's
energy; the multipliers of the dynamics are the internal force and moment. Everything here is without units:
``scaling`` is the door.
"""
