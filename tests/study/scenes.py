# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scenes of the tests of studies: the seed paper's Table 1, and arches and a twisted rod of L = EI = 1."""

import numpy as np

from freecad_cable.geometry import rotation
from freecad_cable.options import SolveOptions
from freecad_cable.problem import Clamped, Rod, Scene, round_section

ALONG_X = rotation.from_tangent([1.0, 0.0, 0.0])


def table_1(length=0.73, **rod):
    """Radius 3.5 mm, 1160 kg/m³, E = 10 MPa, G = 20 MPa."""
    return Scene(
        rod=Rod(length=length, **round_section(0.007, 10e6, 20e6, 1160.0), **rod),
        start=Clamped([0, 0, 0], [0.7071, 0.7071, 0, 0], place="start"),
        end=Clamped([0.16, -0.235, 0.33], [0.5, 0.5, 0.5, 0.5]),
    )


def strip(chord, tilt=0.0, weight=0.0):
    """An upright arch of a strip that bends in the x-z plane only, as other directions are a hundred times stiffer;
    its start clamp tilted upwards by an angle [rad]."""
    upwards = rotation.exponential([0.0, -tilt, 0.0])
    return Scene(
        rod=Rod(
            length=1.0,
            radius=0.005,
            mass_per_length=1.0,
            bending_stiffness=[100.0, 1.0],
            torsional_stiffness=100.0,
        ),
        start=Clamped([0, 0, 0], rotation.multiply(upwards, ALONG_X), place="start"),
        end=Clamped([chord, 0, 0], ALONG_X),
        gravity=[0, 0, -weight],
    )


def twisted(turn, strain=0.002, axial=1e4, torsional=0.8):
    """A straight rod between clamps, pulled by EA times the strain, its end turned [rad]."""
    return Scene(
        rod=Rod(
            length=1.0,
            radius=0.005,
            mass_per_length=0.0,
            bending_stiffness=1.0,
            torsional_stiffness=torsional,
            axial_stiffness=axial,
        ),
        start=Clamped([0, 0, 0], ALONG_X, place="start"),
        end=Clamped(
            np.array([1 + strain, 0, 0]),
            rotation.multiply(ALONG_X, rotation.exponential([0, 0, turn])),
        ),
        # Near the critical turn the estimate of the error grows without bound, and so would the mesh.
        options=SolveOptions(elements=32),
    )
